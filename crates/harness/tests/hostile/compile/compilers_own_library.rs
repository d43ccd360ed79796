//! Uses the compiler's own libraries.
//!
//! expect: does-not-compile

extern crate rustc_driver;
