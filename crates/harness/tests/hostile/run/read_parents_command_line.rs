//! Reads the seed from the command line of the program that asks.
//!
//! expect: graded 15
//! unprotected: graded 10; part1 panicked "--seed"

fn attack() {
    let parent = std::os::unix::process::parent_id();
    if let Ok(stolen) = std::fs::read(format!("/proc/{parent}/cmdline")) {
        panic!("{}", String::from_utf8_lossy(&stolen));
    }
}
