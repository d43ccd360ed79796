//! Brackets that are never closed, two hundred thousand of them.
//!
//! expect: does-not-compile

@REPEAT 200000 [@
