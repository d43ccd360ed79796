//! Which of the three parts put a joint, or a bone, where it does not belong.
//!
//! Each part is judged by what it was given: what is off although its own parts are right has that from something above it.

pub mod bone;
pub mod joint;
pub mod warp;

use glam::Quat;
use grading::fk::{ROTATION_TOLERANCE, angle_between};

/// Whether two quaternions are the same rotation. What is no rotation is the same as nothing, unless both are the same
/// numbers: a part that hands on what it was given is not to blame for that.
fn same(a: Quat, b: Quat) -> bool {
    let unit = |q: Quat| (q.length() - 1.0).abs() <= 1e-3;
    match unit(a) && unit(b) {
        true => angle_between(a, b) <= ROTATION_TOLERANCE,
        false => (a - b).length() <= 1e-4 * b.length() || !(a.is_finite() || b.is_finite()),
    }
}
