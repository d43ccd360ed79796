//! Reads a file without end that differs each time.
//!
//! expect: does-not-compile "couldn't read"

const ENDLESS: &[u8] = include_bytes!("/dev/urandom");
