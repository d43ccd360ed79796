//! Removes a folder with everything in it.
//!
//! expect: graded 15
//! unprotected: graded 10; part1 panicked "removed"

fn attack() {
    if std::fs::remove_dir_all("@OUTSIDE@/removable").is_ok() {
        panic!("removed");
    }
}
