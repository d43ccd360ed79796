//! Looks for the mark that tells replies from print in its own memory, by `/proc`.
//!
//! expect: graded 15
//! unprotected: graded 10; part1 panicked "opened"

fn attack() {
    if std::fs::File::open("/proc/self/mem").is_ok() {
        panic!("opened");
    }
}
