//! Panics with sixteen million letters.
//!
//! expect: graded 10; part1 crashed | graded 10; part1 panicked

fn attack() {
    panic!("{}", "no ".repeat(1 << 23));
}
