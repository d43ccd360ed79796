//! The exercise on interpolation. This file is fixed: yours is `interpolation.rs`.

use exam::Functions;
use skeleton::InterpolationFunctions;

pub mod interpolation;

/// The three functions of `interpolation.rs`, for the viewer and for grading.
pub const FUNCTIONS: Functions = Functions::Interpolation(InterpolationFunctions {
    interpolate_angles: interpolation::interpolate_angles,
    slerp: interpolation::slerp,
    interpolate_frame: interpolation::interpolate_frame,
});
