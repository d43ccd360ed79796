//! Prints without end.
//!
//! expect: graded 10; part1 timed-out
//! quick: yes

fn attack() {
    loop {
        println!("All work and no play makes Jack a dull boy");
    }
}
