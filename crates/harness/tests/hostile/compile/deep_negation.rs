//! Not not not, two hundred thousand times.
//!
//! expect: does-not-compile

pub const DEEP: bool = @REPEAT 200000 !@true;
