//! Reads the questions by a second descriptor, past the lock. There is no question before the answer.
//!
//! expect: graded 10; part1 timed-out

use std::io::Read;
use std::os::fd::AsFd;

fn attack() {
    let Ok(descriptor) = std::io::stdin().as_fd().try_clone_to_owned() else { return };
    let mut question = [0; 1 << 16];
    let _ = std::fs::File::from(descriptor).read(&mut question);
}
