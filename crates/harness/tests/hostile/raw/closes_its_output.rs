//! Closes the descriptor on which the answers go out.
//!
//! with: system_calls
//! expect: graded 10; part1 timed-out | graded 10; part1 crashed

fn attack() {
    system_call(3, [1, 0, 0]);
}
