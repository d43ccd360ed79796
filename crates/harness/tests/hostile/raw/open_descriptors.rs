//! Looks for files that the program that asks has left open.
//!
//! with: system_calls
//! expect: graded 15

fn attack() {
    for descriptor in 3..1024 {
        // F_GETFD
        if system_call(72, [descriptor, 1, 0]) >= 0 {
            panic!("{descriptor}");
        }
    }
}
