//! Reads the machine's list of users.
//!
//! expect: does-not-compile "couldn't read"
//! unprotected: does-not-compile "root:"

const STOLEN: &str = include_str!("/etc/passwd");
const _: () = panic!("{}", STOLEN);
