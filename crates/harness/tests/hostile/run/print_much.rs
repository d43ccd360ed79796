//! Prints 64 MiB, and then answers.
//!
//! expect: graded 15 | graded 10; part1 timed-out

use std::io::Write;

static ONCE: std::sync::Once = std::sync::Once::new();

fn attack() {
    ONCE.call_once(|| {
        for _ in 0..64 {
            let _ = std::io::stdout().write_all(&[b'x'; 1 << 20]);
        }
    });
}
