//! Leaves a message for the next submission in `/dev/shm`, or finds one.
//!
//! expect: graded 15
//! unprotected: graded 10; part1 panicked

fn attack() {
    let message = "/dev/shm/@MARK@-message";
    if let Ok(found) = std::fs::read_to_string(message) {
        panic!("found {found}");
    }
    if std::fs::write(message, "the answer to the first question is").is_ok() {
        panic!("left");
    }
}
