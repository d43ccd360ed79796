//! Calls a function of the C library that it declares to be safe.
//!
//! place: before local_quaternion
//! expect: does-not-compile "unsafe"
//! quick: yes

unsafe extern "C" {
    safe fn getppid() -> i32;
}
fn attack() {
    panic!("{}", getppid());
}
