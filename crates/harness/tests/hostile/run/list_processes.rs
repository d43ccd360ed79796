//! Lists what else runs on this machine.
//!
//! expect: graded 15
//! unprotected: graded 10; part1 panicked

fn attack() {
    if let Ok(processes) = std::fs::read_dir("/proc") {
        panic!("{}", processes.count());
    }
}
