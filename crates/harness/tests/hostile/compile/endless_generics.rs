//! A function that calls itself with ever larger types.
//!
//! expect: does-not-compile "recursion limit" | too-expensive-to-compile memory | too-expensive-to-compile time

pub fn grow<T: Copy>(it: T, count: usize) {
    if count > 0 {
        grow((it, it), count - 1);
    }
}
pub fn explode() {
    grow(1_u8, 10);
}
