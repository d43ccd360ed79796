//! Parentheses a hundred thousand deep, on which the compiler itself breaks down.
//!
//! expect: does-not-compile "broke down"

pub fn deep() -> i32 {
    @REPEAT 100000 (@1@REPEAT 100000 )@
}
