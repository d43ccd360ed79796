//! Never comes back.
//!
//! expect: graded 10; part1 timed-out
//! quick: yes

fn attack() {
    loop {
        std::hint::spin_loop();
    }
}
