//! Sends a signal to the program that asks. (One that does nothing, but the last would be as easy.)
//!
//! expect: graded 15
//! unprotected: graded 10; part1 panicked "sent"

fn attack() {
    let parent = std::os::unix::process::parent_id();
    let sent = std::process::Command::new("/bin/sh").args(["-c", &format!("kill -CONT {parent}")]).status();
    if sent.is_ok_and(|status| status.success()) {
        panic!("sent");
    }
}
