//! Hands in the reference solution, which lies in the same workspace.
//!
//! place: alone
//! expect: does-not-compile "couldn't read"
//! unprotected: graded 15

#[path = "@SOLUTION@"]
mod stolen;
pub use stolen::{global_position, global_quaternion, local_quaternion};
