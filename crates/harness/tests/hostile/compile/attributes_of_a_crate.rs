//! Attributes that only the root of a program may have: here they do nothing.
//!
//! expect: graded 15

#![no_main]
#![no_std]
#![crate_name = "other"]
