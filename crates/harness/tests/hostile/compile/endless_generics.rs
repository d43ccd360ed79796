//! A function that calls itself with ever larger types.
//!
//! place: before local_quaternion
//! expect: does-not-compile "recursion limit" | does-not-compile "reached the type-length limit" | too-expensive-to-compile time | too-expensive-to-compile memory

fn attack() {
    grow(1_u8, 10);
}

fn grow<T: Copy>(it: T, count: usize) {
    if count > 0 {
        grow((it, it), count - 1);
    }
}
