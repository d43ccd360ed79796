//! Writes to the terminal of whoever makes the marks, or types there.
//!
//! expect: graded 15

use std::io::Write;

fn attack() {
    for terminal in ["/dev/tty", "/dev/console", "/dev/pts/0", "/dev/pts/1"] {
        if let Ok(mut terminal) = std::fs::OpenOptions::new().write(true).open(terminal) {
            let _ = terminal.write_all(b"");
            panic!("opened");
        }
    }
}
