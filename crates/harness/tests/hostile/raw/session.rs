//! Leaves the group in which it was started.
//!
//! with: system_calls
//! expect: graded 15 | graded 10; part1 panicked

fn attack() {
    // Where there are no other processes to hide among, this gains nothing.
    if system_call(112, [0; 3]) > 0 {
        panic!("left");
    }
}
