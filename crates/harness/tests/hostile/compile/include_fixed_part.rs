//! Reads the fixed part around its own module. There is nothing secret in it.
//!
//! expect: graded 15

const FIXED: &str = include_str!("lib.rs");
const _: () = assert!(!FIXED.is_empty());
