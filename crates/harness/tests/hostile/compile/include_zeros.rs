//! Reads a file without end.
//!
//! expect: does-not-compile "couldn't read"
//! unprotected: does-not-compile "out of memory" | too-expensive-to-compile memory | too-expensive-to-compile time

const ENDLESS: &[u8] = include_bytes!("/dev/zero");
