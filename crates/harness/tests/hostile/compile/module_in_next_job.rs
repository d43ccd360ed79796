//! Hands in what another job is compiling right now, in the folder beside its own.
//!
//! place: alone
//! expect: does-not-compile

#[path = "../../../../1/exercises/fk/src/fk.rs"]
mod one;
#[path = "../../../../0/exercises/fk/src/fk.rs"]
mod zero;
pub use one::{global_position, global_quaternion, local_quaternion};
