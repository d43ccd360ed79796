//! Names a file outside as a module, so that the compiler's error quotes its first line.
//!
//! expect: does-not-compile "couldn't read"
//! unprotected: does-not-compile "@WORD@"

#[path = "@SECRET@"]
mod stolen;
