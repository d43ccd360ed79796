//! Writes what is no reply by a second descriptor, past the lock.
//!
//! expect: graded 15

use std::io::Write;
use std::os::fd::AsFd;

fn attack() {
    if let Ok(descriptor) = std::io::stdout().as_fd().try_clone_to_owned() {
        let _ = std::fs::File::from(descriptor).write_all(&[0; 100]);
    }
}
