//! The process in which the viewer runs your functions. This file is fixed: yours is `fk.rs`.

fn main() {
    exam::worker::serve(fk::FUNCTIONS)
}
