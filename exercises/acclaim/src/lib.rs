//! The exercise on Acclaim forward kinematics. This file is fixed: yours is `acclaim.rs`.

use exam::Functions;
use skeleton::acclaim::AcclaimFunctions;

pub mod acclaim;

/// The three functions of `acclaim.rs`, for the viewer and for grading.
pub const FUNCTIONS: Functions = Functions::Acclaim(AcclaimFunctions {
    bone_rotation: acclaim::bone_rotation,
    bone_ends: acclaim::bone_ends,
    visit_bones: acclaim::visit_bones,
});
