//! The process in which the viewer runs your functions. This file is fixed: yours is `time_warp.rs`.

fn main() {
    exam::worker::serve(time_warp::FUNCTIONS)
}
