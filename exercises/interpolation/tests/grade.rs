//! Your points. This file is fixed: yours is `src/interpolation.rs`.

use std::process::ExitCode;

fn main() -> ExitCode {
    grading::self_grade(interpolation::FUNCTIONS)
}
