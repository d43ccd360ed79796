//! Calls a function of the C library in the way of earlier editions.
//!
//! expect: does-not-compile "extern blocks must be unsafe"

extern "C" {
    fn getppid() -> i32;
}
pub fn call() -> i32 {
    unsafe { getppid() }
}
