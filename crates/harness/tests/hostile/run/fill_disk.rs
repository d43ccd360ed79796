//! Writes until the disk is full. (It stops at 256 MiB.)
//!
//! expect: graded 15

use std::io::Write;

static ONCE: std::sync::OnceLock<u64> = std::sync::OnceLock::new();

fn attack() {
    let written = *ONCE.get_or_init(|| {
        let mut written = 0;
        for folder in ["/tmp", "/var/tmp", "/dev/shm", "/dev/mqueue", "/run", "/", ".", "@OUTSIDE@"] {
            let Ok(mut file) = std::fs::File::create(format!("{folder}/@MARK@-fill")) else { continue };
            for _ in 0..256 {
                written += file.write(&[7; 1 << 20]).unwrap_or(0) as u64;
            }
        }
        written
    });
    if written > 0 {
        panic!("{written} bytes");
    }
}
