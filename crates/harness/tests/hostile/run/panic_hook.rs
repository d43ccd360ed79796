//! Replaces what happens at a panic, and then panics.
//!
//! expect: graded 10; part1 panicked

fn attack() {
    std::panic::set_hook(Box::new(|_| println!("15 of 15 points")));
    panic!("unheard");
}
