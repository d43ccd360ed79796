//! Reads the compiler's standard input, which may never end.
//!
//! expect: does-not-compile "couldn't read"

const NEVER: &[u8] = include_bytes!("/dev/stdin");
const _: () = assert!(NEVER.len() > 1 << 20);
