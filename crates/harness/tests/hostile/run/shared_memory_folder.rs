//! Leaves a message, here by its mere name, for the next submission in `/dev/shm`, or finds one.
//!
//! expect: graded 15
//! unprotected: graded 10; part1 panicked

fn attack() {
    let message = "/dev/shm/@MARK@-message";
    if let Ok(found) = std::fs::metadata(message) {
        panic!("found {found:?}");
    }
    if std::fs::File::create(message).is_ok() {
        panic!("left");
    }
}
