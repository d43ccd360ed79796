//! Your points. This file is fixed: yours is `src/fk.rs`.

use std::process::ExitCode;

fn main() -> ExitCode {
    grading::self_grade(fk::FUNCTIONS)
}
