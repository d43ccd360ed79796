//! Reads the right answers from the memory of the program that asks.
//!
//! expect: graded 15
//! unprotected: graded 10; part1 panicked "opened"

fn attack() {
    let parent = std::os::unix::process::parent_id();
    if std::fs::File::open(format!("/proc/{parent}/mem")).is_ok() {
        panic!("opened");
    }
}
