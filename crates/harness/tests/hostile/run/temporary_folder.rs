//! Leaves a message for the next submission in the temporary folder.
//!
//! expect: graded 15
//! unprotected: graded 10; part1 panicked

fn attack() {
    for folder in ["/tmp", "/var/tmp", "/run/lock"] {
        if std::fs::write(format!("{folder}/@MARK@-message"), "the answer is").is_ok() {
            panic!("left in {folder}");
        }
    }
    if std::fs::write(std::env::temp_dir().join("@MARK@-message"), "the answer is").is_ok() {
        panic!("left in the temporary folder");
    }
}
