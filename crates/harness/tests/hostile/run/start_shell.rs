//! Starts a shell.
//!
//! expect: graded 15
//! unprotected: graded 10; part1 panicked "started"
//! quick: yes

fn attack() {
    if std::process::Command::new("/bin/sh").args(["-c", "exit 0"]).status().is_ok() {
        panic!("started");
    }
}
