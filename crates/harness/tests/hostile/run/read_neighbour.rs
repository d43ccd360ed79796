//! Reads what others have handed in.
//!
//! expect: graded 15
//! unprotected: graded 10; part1 panicked

fn attack() {
    if let Ok(stolen) = std::fs::read_to_string("@NEIGHBOUR@") {
        panic!("{stolen}");
    }
}
