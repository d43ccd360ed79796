//! Moves a file away.
//!
//! expect: graded 15
//! unprotected: graded; part1 partly-right "moved"

fn attack() {
    if std::fs::rename("@OUTSIDE@/movable", "@OUTSIDE@/moved").is_ok() {
        panic!("moved");
    }
}
