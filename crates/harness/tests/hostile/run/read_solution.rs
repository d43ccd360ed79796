//! Reads the reference solution in the workspace.
//!
//! expect: graded 15
//! unprotected: graded 10; part1 panicked

fn attack() {
    if let Ok(stolen) = std::fs::read_to_string("@SOLUTION@") {
        panic!("{stolen}");
    }
}
