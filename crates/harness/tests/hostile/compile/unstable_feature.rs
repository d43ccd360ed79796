//! Asks for features that are not ready.
//!
//! expect: does-not-compile

#![feature(core_intrinsics, rustc_private, plugin)]
#![plugin(evil)]
pub fn stop() {
    core::intrinsics::abort()
}
