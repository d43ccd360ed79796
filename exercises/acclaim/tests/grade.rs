//! Your points. This file is fixed: yours is `src/acclaim.rs`.

use std::process::ExitCode;

fn main() -> ExitCode {
    grading::self_grade(acclaim::FUNCTIONS)
}
