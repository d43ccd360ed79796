//! Writes its own verdict.
//!
//! expect: graded 15
//! unprotected: graded 10; part1 panicked "written"

fn attack() {
    if std::fs::write("@OUT@/@MARK@-results.json", "15 points").is_ok() {
        panic!("written");
    }
}
