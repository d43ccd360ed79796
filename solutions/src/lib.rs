//! The reference solutions, one module per exercise.
#![deny(missing_docs)]

use skeleton::{FkFunctions, InterpolationFunctions, KeyframesFunctions};

pub mod fk;
pub mod interpolation;
pub mod keyframes;
pub mod template;

/// The right answers to the forward-kinematics exercise.
pub const FK: FkFunctions = FkFunctions {
    local_quaternion: fk::local_quaternion,
    global_quaternion: fk::global_quaternion,
    global_position: fk::global_position,
};

/// The right answers to the exercise on interpolation.
pub const INTERPOLATION: InterpolationFunctions = InterpolationFunctions {
    interpolate_angles: interpolation::interpolate_angles,
    slerp: interpolation::slerp,
    interpolate_frame: interpolation::interpolate_frame,
};

/// The right answers to the exercise on keyframes.
pub const KEYFRAMES: KeyframesFunctions = KeyframesFunctions {
    pose_error: keyframes::pose_error,
    removal_cost: keyframes::removal_cost,
    reduce: keyframes::reduce,
};

/// Compiles and runs the Rust code in the book.
#[cfg(doctest)]
#[doc = include_str!("../../docs/getting-started.md")]
mod getting_started {}
