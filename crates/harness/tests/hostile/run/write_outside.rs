//! Writes a file into a folder where everybody may.
//!
//! expect: graded 15
//! unprotected: graded 10; part1 panicked "written"
//! quick: yes

fn attack() {
    if std::fs::write("@OUTSIDE@/@MARK@-written", "I was here").is_ok() {
        panic!("written");
    }
}
