//! Allows itself what is forbidden, for its own file.
//!
//! expect: does-not-compile "unsafe_code"

#![allow(unsafe_code)]
pub fn poke() {
    unsafe { *(8 as *mut u8) = 1 }
}
