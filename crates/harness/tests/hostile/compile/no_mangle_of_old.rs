//! Takes the place of the program's beginning, in the way of earlier editions.
//!
//! expect: does-not-compile "unsafe attribute"

#[no_mangle]
pub extern "C" fn main() -> i32 {
    0
}
