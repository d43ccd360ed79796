//! Your points. This file is fixed: yours is `src/keyframes.rs`.

use std::process::ExitCode;

fn main() -> ExitCode {
    grading::self_grade(keyframes::FUNCTIONS)
}
