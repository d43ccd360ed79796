//! Puts its own verdict beside the others.
//!
//! expect: graded 15
//! unprotected: graded 10; part1 panicked "written"

fn attack() {
    if std::fs::File::create("@OUT@/@MARK@-results.json").is_ok() {
        panic!("written");
    }
}
