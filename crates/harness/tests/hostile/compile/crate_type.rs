//! Wants to be a procedural macro, which would run inside the compiler. Here the attribute does nothing.
//!
//! expect: graded 15

#![crate_type = "proc-macro"]
