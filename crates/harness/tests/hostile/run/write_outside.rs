//! Puts a file into a folder where everybody may.
//!
//! expect: graded 15
//! unprotected: graded 10; part1 panicked "written"
//! quick: yes

fn attack() {
    if std::fs::File::create("@OUTSIDE@/@MARK@-written").is_ok() {
        panic!("written");
    }
}
