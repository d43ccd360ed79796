//! Uses the library that holds the right answers.
//!
//! place: alone
//! expect: does-not-compile

extern crate solutions;
pub use solutions::fk::{global_position, global_quaternion, local_quaternion};
