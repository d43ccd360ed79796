//! Reads the machine's list of users.
//!
//! expect: graded 15
//! unprotected: graded 10; part1 panicked "root:"

fn attack() {
    if let Ok(stolen) = std::fs::read_to_string("/etc/passwd") {
        panic!("{stolen}");
    }
}
