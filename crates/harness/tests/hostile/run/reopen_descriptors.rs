//! Opens its own descriptors anew by `/proc`, for more than they were given for.
//!
//! expect: graded 15
//! unprotected: graded 10; part1 panicked

fn attack() {
    for descriptor in 0..64 {
        for folder in ["/proc/self/fd", "/dev/fd", "/proc/thread-self/fd"] {
            let path = format!("{folder}/{descriptor}");
            if std::fs::OpenOptions::new().write(true).open(&path).is_ok() {
                panic!("{path}");
            }
        }
    }
}
