//! One name of two hundred thousand letters, which every error about it repeats.
//!
//! expect: does-not-compile "cannot find value"

pub fn long() -> i32 {
    @REPEAT 200000 x@
}
