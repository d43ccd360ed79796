//! The reference solutions, one module per exercise.
#![deny(missing_docs)]

use skeleton::acclaim::{AcclaimFunctions, TimeWarpFunctions};
use skeleton::{FkFunctions, InterpolationFunctions, KeyframesFunctions};

pub mod acclaim;
pub mod fk;
pub mod interpolation;
pub mod keyframes;
pub mod template;
pub mod time_warp;

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

/// The right answers to the exercise on Acclaim forward kinematics.
pub const ACCLAIM: AcclaimFunctions = AcclaimFunctions {
    bone_rotation: acclaim::bone_rotation,
    bone_ends: acclaim::bone_ends,
    visit_bones: acclaim::visit_bones,
};

/// The right answers to the exercise on time warping.
pub const TIME_WARP: TimeWarpFunctions = TimeWarpFunctions {
    old_position: time_warp::old_position,
    blend: time_warp::blend,
    warp: time_warp::warp,
};

/// Compiles and runs the Rust code in the book.
#[cfg(doctest)]
#[doc = include_str!("../../docs/getting-started.md")]
mod getting_started {}
