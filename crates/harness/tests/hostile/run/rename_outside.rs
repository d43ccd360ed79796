//! Moves a file away.
//!
//! expect: graded 15
//! unprotected: graded 10; part1 panicked "moved"

fn attack() {
    if std::fs::rename("@OUTSIDE@/movable", "@OUTSIDE@/moved").is_ok() {
        panic!("moved");
    }
}
