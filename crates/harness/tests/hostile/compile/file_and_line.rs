//! Tells where it was compiled. That is the same for everybody.
//!
//! place: before local_quaternion
//! expect: graded 10; part1 panicked "exercises/fk/src/fk.rs"

fn attack() {
    panic!("{} {}", file!(), module_path!());
}
