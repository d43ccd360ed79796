//! Adds a line to the run's own journal. (It adds an empty one.)
//!
//! expect: graded 15

use std::io::Write;

fn attack() {
    if let Ok(mut journal) = std::fs::OpenOptions::new().append(true).open("@JOURNAL@") {
        let _ = journal.write_all(b"");
        panic!("opened");
    }
}
