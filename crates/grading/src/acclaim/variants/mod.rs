//! Known-wrong variants of the three functions, one misconception each.

pub(super) mod ends;
pub(super) mod rotation;
pub(super) mod visits;

use glam::Quat;
use skeleton::acclaim::AcclaimFunctions;

/// The functions of the untouched template.
pub const TEMPLATE: AcclaimFunctions = AcclaimFunctions {
    bone_rotation: |_, _, _| Quat::IDENTITY,
    bone_ends: |_, _, parent_end, _| (parent_end, parent_end),
    visit_bones: |_, bone, visitor| visitor.visit(bone),
};
