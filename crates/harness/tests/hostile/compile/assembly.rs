//! Runs instructions of its own.
//!
//! expect: does-not-compile "unsafe"

pub fn run() {
    unsafe { core::arch::asm!("ud2") }
}
