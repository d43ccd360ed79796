//! References to references, two hundred thousand deep.
//!
//! expect: does-not-compile

pub fn deep(_: @REPEAT 200000 &@u8) {}
