//! Removes a folder with everything in it.
//!
//! expect: graded 15
//! unprotected: graded; part1 partly-right "removed"

fn attack() {
    if std::fs::remove_dir_all("@OUTSIDE@/removable").is_ok() {
        panic!("removed");
    }
}
