//! Reads a file outside as Rust, so that the compiler's error quotes the line that is none.
//!
//! expect: does-not-compile "couldn't read"
//! unprotected: does-not-compile "@WORD@"

include!("@SECRET@");
