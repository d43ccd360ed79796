//! The process in which the viewer runs your functions. This file is fixed: yours is `interpolation.rs`.

fn main() {
    exam::worker::serve(interpolation::FUNCTIONS)
}
