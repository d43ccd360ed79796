//! Puts a file outside into the program by `include_bytes!`, to tell it when it is asked.
//!
//! place: before local_quaternion
//! expect: does-not-compile "couldn't read"
//! unprotected: graded 10; part1 panicked "@WORD@"

fn attack() {
    let stolen = include_bytes!("@SECRET@");
    panic!("{}", String::from_utf8_lossy(stolen));
}
