//! Asks only whether a file is there. A file system of its own hides that; without one it can be seen.
//!
//! expect: graded 15
//! expect without namespaces: graded 15 | graded 10; part1 panicked
//! unprotected: graded 10; part1 panicked

fn attack() {
    if let Ok(found) = std::fs::metadata("@SECRET@") {
        panic!("{}", found.len());
    }
}
