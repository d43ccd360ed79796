//! Replaces what happens at a panic by something that never ends.
//!
//! expect: graded 10; part1 timed-out

fn attack() {
    std::panic::set_hook(Box::new(|_| {
        loop {
            std::hint::spin_loop();
        }
    }));
    panic!("unheard");
}
