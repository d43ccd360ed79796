//! Prints errors without end.
//!
//! expect: graded 10; part1 timed-out

fn attack() {
    loop {
        eprintln!("All work and no play makes Jack a dull boy");
    }
}
