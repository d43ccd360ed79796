//! Answers questions on its own account, by the function that asked it.
//!
//! expect: graded 10; part1 timed-out | graded 10; part1 crashed

fn attack() {
    exam::worker::serve(crate::FUNCTIONS);
}
