//! Writes to any address.
//!
//! expect: does-not-compile "unsafe"

pub fn poke() {
    unsafe { *(8 as *mut u8) = 1 }
}
