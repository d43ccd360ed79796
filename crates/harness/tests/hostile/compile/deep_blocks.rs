//! Blocks a hundred thousand deep.
//!
//! expect: does-not-compile

pub fn deep() -> i32 {
    @REPEAT 100000 {@1@REPEAT 100000 }@
}
