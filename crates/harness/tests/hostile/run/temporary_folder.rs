//! Leaves a message for the next submission in the temporary folder.
//!
//! expect: graded 15
//! unprotected: graded 10; part1 panicked

fn attack() {
    for folder in ["/tmp", "/var/tmp", "/run/lock"] {
        if std::fs::File::create(format!("{folder}/@MARK@-message")).is_ok() {
            panic!("left in {folder}");
        }
    }
    if std::fs::File::create(std::env::temp_dir().join("@MARK@-message")).is_ok() {
        panic!("left in the temporary folder");
    }
}
