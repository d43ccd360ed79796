//! Takes the place of a function of the C library.
//!
//! expect: does-not-compile "unsafe"
//! quick: yes

#[unsafe(no_mangle)]
pub extern "C" fn write(_: i32, _: *const u8, count: usize) -> usize {
    count
}
