//! Reads a file outside.
//!
//! expect: graded 15
//! unprotected: graded 10; part1 panicked "@WORD@"
//! quick: yes

fn attack() {
    if let Ok(stolen) = std::fs::read_to_string("@SECRET@") {
        panic!("{stolen}");
    }
}
