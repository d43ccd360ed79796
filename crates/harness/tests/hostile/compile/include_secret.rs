//! Reads a file outside by `include_str!`, and lets the compiler print it in an error.
//!
//! expect: does-not-compile "couldn't read"
//! unprotected: does-not-compile "@WORD@"
//! quick: yes

const STOLEN: &str = include_str!("@SECRET@");
const _: () = panic!("{}", STOLEN);
