//! Known-wrong variants of the three functions, one misconception each.

pub(super) mod cost;
pub(super) mod error;
pub(super) mod reduction;

use skeleton::KeyframesFunctions;

/// The functions of the untouched template.
pub const TEMPLATE: KeyframesFunctions = KeyframesFunctions {
    pose_error: |_, _, _| 0.0,
    removal_cost: |_, _, _, _| 0.0,
    reduce: |frame_count, _, _| (0..frame_count).collect(),
};
