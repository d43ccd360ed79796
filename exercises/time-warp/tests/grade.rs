//! Your points. This file is fixed: yours is `src/time_warp.rs`.

use std::process::ExitCode;

fn main() -> ExitCode {
    grading::self_grade(time_warp::FUNCTIONS)
}
