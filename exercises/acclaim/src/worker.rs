//! The process in which the viewer runs your functions. This file is fixed: yours is `acclaim.rs`.

fn main() {
    exam::worker::serve(acclaim::FUNCTIONS)
}
