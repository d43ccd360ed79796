//! Hides the path of a module behind `cfg_attr`.
//!
//! expect: does-not-compile "couldn't read"
//! unprotected: does-not-compile "@WORD@"

#[cfg_attr(all(), path = "@SECRET@")]
mod stolen;
