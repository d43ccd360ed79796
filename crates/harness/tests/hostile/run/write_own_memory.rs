//! Writes to its own memory by `/proc`, past everything that the compiler has checked.
//!
//! expect: graded 15
//! unprotected: graded 10; part1 panicked "opened"

fn attack() {
    if std::fs::OpenOptions::new().write(true).open("/proc/self/mem").is_ok() {
        panic!("opened");
    }
}
