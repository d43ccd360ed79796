//! Puts the forbidden word together in a macro.
//!
//! expect: does-not-compile "unsafe"

macro_rules! block {
    ($word:tt $body:tt) => { $word $body };
}
pub fn poke() {
    block!(unsafe { *(8 as *mut u8) = 1 })
}
