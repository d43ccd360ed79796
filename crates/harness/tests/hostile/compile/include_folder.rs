//! Reads a folder as if it were a file.
//!
//! expect: does-not-compile "couldn't read"

const FOLDER: &[u8] = include_bytes!("/");
