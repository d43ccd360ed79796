//! Time warping: a bone in a frame, and the three parts.
//!
//! The functions say how every bone is turned against its parent, so what is off although it is turned rightly has that from a
//! bone above it.

use skeleton::acclaim::Between;
use skeleton::{JointId, Pose, Skeleton};

use grading::fk::POSITION_TOLERANCE;

use super::same;
use crate::motion::time_map::position_of;

/// What a student's functions made of one frame, and of parts of it by themselves.
#[derive(Clone, Copy)]
pub struct Case<'a> {
    /// The joints that stand for the bones.
    pub skeleton: &'a Skeleton,
    /// What part 3 gave.
    pub given: &'a Pose,
    /// What it should have given.
    pub expected: &'a Pose,
    /// Where part 1 says that the frame is.
    pub place: Between,
    /// Where it is.
    pub right_place: Between,
    /// What part 2 makes of the right place, and of that which part 1 says, if that is there; `None` until it has been asked.
    pub blended: Option<(&'a Pose, Option<&'a Pose>)>,
    /// The size of the skeleton, by which distances are judged.
    pub size: f32,
}

/// Whose fault it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Blame {
    /// Nobody's.
    Nobody,
    /// That of these of the three parts, of which at least one is true.
    Parts([bool; 3]),
    /// Parts 1 and 2 have not been asked by themselves yet.
    Unclear,
    /// That of a bone above it, the nearest one that is turned wrongly.
    Above(JointId),
}

/// Places in the old motion that differ by less than this, in frames, are the same.
const SAME_PLACE: f64 = 1e-4;

/// Whether two ways to say where a frame is mean the same.
pub fn is_same_place(a: Between, b: Between) -> bool {
    (position_of(a) - position_of(b)).abs() <= SAME_PLACE
}

/// Who is to blame for where `joint` is and how it is turned.
pub fn blame(case: &Case, joint: JointId) -> Blame {
    let mut next = Some(joint);
    while let Some(judged) = next {
        if !is_turned_alike(case, case.given, case.expected, judged) {
            return if judged == joint { parts(case, joint) } else { Blame::Above(judged) };
        }
        next = case.skeleton.get(judged).and_then(|joint| joint.parent);
    }
    Blame::Nobody
}

/// Which parts turn a joint wrongly.
fn parts(case: &Case, joint: JointId) -> Blame {
    let Some((right, own)) = case.blended else { return Blame::Unclear };
    let first = !is_same_place(case.place, case.right_place);
    let second = !is_turned_alike(case, right, case.expected, joint);
    let third = own.is_some_and(|own| !is_turned_alike(case, case.given, own, joint));
    match [first, second, third] {
        // Asked by themselves all parts are right: then it is how they are put together.
        [false, false, false] => Blame::Parts([false, false, true]),
        parts => Blame::Parts(parts),
    }
}

/// Whether a joint is turned against its parent in one pose as in another; a root also stands in the same place.
fn is_turned_alike(case: &Case, one: &Pose, other: &Pose, joint: JointId) -> bool {
    let Some(parent) = case.skeleton.get(joint).map(|joint| joint.parent) else { return true };
    let at = |pose: &Pose, joint: JointId| pose.transforms().get(joint.0).copied();
    let (Some(own), Some(others)) = (at(one, joint), at(other, joint)) else { return true };
    match parent {
        None => {
            let apart = own.position.distance(others.position);
            same(own.rotation, others.rotation) && apart <= POSITION_TOLERANCE * case.size
        }
        Some(parent) => {
            let (Some(above), Some(others_above)) = (at(one, parent), at(other, parent)) else { return true };
            same(above.rotation.inverse() * own.rotation, others_above.rotation.inverse() * others.rotation)
        }
    }
}

#[cfg(test)]
mod tests;
