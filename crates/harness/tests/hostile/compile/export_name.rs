//! Takes the place of the functions that give out memory.
//!
//! expect: does-not-compile "unsafe"

#[unsafe(export_name = "malloc")]
pub extern "C" fn take(_: usize) -> *mut u8 {
    core::ptr::null_mut()
}
