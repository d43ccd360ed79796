//! Reads the seed of the questions and the verdicts on others.
//!
//! expect: graded 15
//! unprotected: graded 10; part1 panicked "schema"

fn attack() {
    if let Ok(stolen) = std::fs::read_to_string("@JOURNAL@") {
        panic!("{}", stolen.chars().take(1000).collect::<String>());
    }
}
