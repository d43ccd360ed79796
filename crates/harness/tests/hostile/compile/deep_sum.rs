//! A sum of a hundred thousand numbers, which the compiler reads as a tree as deep.
//!
//! expect: does-not-compile | too-expensive-to-compile time | too-expensive-to-compile memory

pub fn deep(a: i32) -> i32 {
    a@REPEAT 100000 +a@
}
