//! Reads a file outside as documentation, and fails to hide it.
//!
//! expect: does-not-compile "couldn't read"
//! unprotected: graded 15

#[doc = include_str!("@SECRET@")]
pub struct Documented;
