//! Types into the terminal of whoever makes the marks.
//!
//! with: system_calls
//! expect: graded 15

fn attack() {
    let letter = b'x';
    for descriptor in 0..3 {
        // TIOCSTI
        if system_call(16, [descriptor, 0x5412, address(&letter)]) == 0 {
            panic!("{descriptor}");
        }
    }
}
