//! The reference solutions, one module per exercise.
#![deny(missing_docs)]

use skeleton::FkFunctions;

pub mod fk;
pub mod template;

/// The right answers to the forward-kinematics exercise.
pub const FK: FkFunctions = FkFunctions {
    local_quaternion: fk::local_quaternion,
    global_quaternion: fk::global_quaternion,
    global_position: fk::global_position,
};

/// Compiles and runs the Rust code in the book.
#[cfg(doctest)]
#[doc = include_str!("../../docs/getting-started.md")]
mod getting_started {}
