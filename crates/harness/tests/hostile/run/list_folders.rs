//! Looks around: in the root, the home folders, the folders of the run.
//!
//! expect: graded 15
//! unprotected: graded 10; part1 panicked

fn attack() {
    for folder in ["/home", "/root", "/etc", "/tmp", "/var", "/proc", "/sys", "@OUT@", "@SUBMISSIONS@", "@OUTSIDE@"] {
        if let Ok(entries) = std::fs::read_dir(folder) {
            panic!("{folder}: {}", entries.count());
        }
    }
}
