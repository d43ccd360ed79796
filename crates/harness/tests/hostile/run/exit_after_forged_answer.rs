//! Prints what looks like a reply, and ends the program as if all were well.
//!
//! expect: graded 10; part1 crashed

use std::io::Write;

fn attack() {
    let mut out = std::io::stdout();
    let _ = out.write_all(&[0; 16]);
    let _ = out.write_all(&[18, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 128, 63, 3, 0]);
    let _ = out.flush();
    std::process::exit(0);
}
