//! Closes the descriptor on which the questions come in, and waits.
//!
//! with: system_calls
//! expect: graded

fn attack() {
    system_call(3, [0, 0, 0]);
}
