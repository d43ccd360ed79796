//! The forward-kinematics exercise. This file is fixed: yours is `fk.rs`.

use exam::Functions;
use skeleton::FkFunctions;

pub mod fk;

/// The three functions of `fk.rs`, for the viewer and for grading.
pub const FUNCTIONS: Functions = Functions::Fk(FkFunctions {
    local_quaternion: fk::local_quaternion,
    global_quaternion: fk::global_quaternion,
    global_position: fk::global_position,
});
