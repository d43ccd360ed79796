//! A function that is nothing but instructions.
//!
//! expect: does-not-compile "unsafe"

#[unsafe(naked)]
pub extern "C" fn run() {
    core::arch::naked_asm!("ud2")
}
