//! Prints what belongs to the middle of a line, and zeros, before each answer.
//!
//! expect: graded 15

fn attack() {
    print!("local quaternion of \0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0 this joint: ");
}
