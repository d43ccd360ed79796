//! Promises what the compiler cannot check.
//!
//! expect: does-not-compile "unsafe"

pub struct Shared(pub *mut u8);
unsafe impl Send for Shared {}
unsafe impl Sync for Shared {}
