//! Puts instructions of its own where the program begins.
//!
//! expect: does-not-compile "unsafe"

core::arch::global_asm!(".section .init_array,\"aw\"", ".quad 8");
