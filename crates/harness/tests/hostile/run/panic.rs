//! Panics at once.
//!
//! expect: graded 10; part1 panicked
//! quick: yes

fn attack() {
    panic!("I give up");
}
