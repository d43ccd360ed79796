//! Never comes back where it computes positions.
//!
//! place: before global_position
//! expect: graded 10; part3 timed-out

fn attack() {
    loop {
        std::hint::spin_loop();
    }
}
