//! Hands in another student's file, which lies in the same folder of submissions.
//!
//! place: alone
//! expect: does-not-compile "couldn't read"
//! unprotected: graded 15
//! quick: yes

#[path = "@NEIGHBOUR@"]
mod stolen;
pub use stolen::{global_position, global_quaternion, local_quaternion};
