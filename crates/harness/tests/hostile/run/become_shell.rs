//! Becomes a shell, which inherits the questions.
//!
//! expect: graded 15
//! unprotected: graded 10; part1 crashed

use std::os::unix::process::CommandExt;

fn attack() {
    let _ = std::process::Command::new("/bin/sh").args(["-c", "exit 7"]).exec();
}
