//! Waits for somebody to wake it.
//!
//! expect: graded 10; part1 timed-out

fn attack() {
    loop {
        std::thread::park();
    }
}
