//! Forward kinematics: a joint, and its three parts.

use exam::fk::LocalAnswer;
use glam::{Quat, Vec3};
use grading::fk::POSITION_TOLERANCE;
use skeleton::{FrameCursor, Joint, JointId, Pose, Skeleton};

use super::same;

/// What a student's functions made of one frame, and what they were given.
#[derive(Clone, Copy)]
pub struct Case<'a> {
    /// The skeleton.
    pub skeleton: &'a Skeleton,
    /// The frame's angles, in degrees.
    pub angles: &'a [f32],
    /// For every joint its position relative to its parent.
    pub local_positions: &'a [Vec3],
    /// The global transforms that the functions gave.
    pub given: &'a Pose,
    /// What part 1 gave by itself; `None` until it is known.
    pub locals: Option<&'a [LocalAnswer]>,
    /// The size of the skeleton, by which distances are judged.
    pub size: f32,
}

/// Whose fault it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Blame {
    /// Nobody's: the joint's own parts are right, and so are those of all joints above it.
    Nobody,
    /// The joint's own: these of its three parts, of which at least one is true.
    Own([bool; 3]),
    /// Part 1 or part 2 of the joint: which of them is known when part 1 has been asked by itself.
    RotationOf,
    /// That of a joint above it; the nearest one whose own parts are wrong.
    Above(JointId),
}

/// The three angles of `joint`, in degrees and in its rotation order; `None` when it has none.
pub fn angles_of<'a>(skeleton: &Skeleton, angles: &'a [f32], joint: JointId) -> Option<&'a [f32]> {
    let rotates = |joint: &&Joint| joint.rotation_order.axes().is_some();
    skeleton.get(joint).filter(rotates)?;
    let before = skeleton.joints().iter().take(joint.0).filter(rotates).count();
    angles.get(3 * before..3 * before + 3)
}

/// The right local rotation of `joint`.
pub fn right_local(skeleton: &Skeleton, angles: &[f32], joint: JointId) -> Quat {
    let own = angles_of(skeleton, angles, joint).unwrap_or_default();
    let mut cursor = FrameCursor::new(own);
    skeleton.get(joint).map_or(Quat::IDENTITY, |joint| (solutions::FK.local_quaternion)(joint, &mut cursor))
}

/// Who is to blame for where `joint` is and how it is turned.
pub fn blame(case: &Case, joint: JointId) -> Blame {
    let mut next = case.skeleton.get(joint);
    while let Some(judged) = next {
        let found = match own(case, judged) {
            None => None,
            Some(found) if judged.id == joint => Some(found),
            Some(_) => Some(Blame::Above(judged.id)),
        };
        if let Some(found) = found {
            return found;
        }
        next = judged.parent.and_then(|parent| case.skeleton.get(parent));
    }
    Blame::Nobody
}

/// What is wrong with a joint's own parts, given what they were given.
fn own(case: &Case, joint: &Joint) -> Option<Blame> {
    let given = case.given.transforms().get(joint.id.0)?;
    let expected_local = right_local(case.skeleton, case.angles, joint.id);
    let position = case.local_positions.get(joint.id.0).copied().unwrap_or(joint.offset);
    let moved = (solutions::FK.global_position)(joint, position, case.given);
    let near = given.position.distance(moved) <= POSITION_TOLERANCE * case.size;
    // What is made of no numbers is handed on, and not made here.
    let third = !near && (given.position.is_finite() || moved.is_finite());

    let local = case.locals.and_then(|locals| locals.get(joint.id.0)).map(|answer| answer.rotation);
    let turned = |local| (solutions::FK.global_quaternion)(joint, local, case.given);
    let Some(local) = local else {
        return match (same(given.rotation, turned(expected_local)), third) {
            (true, false) => None,
            (true, true) => Some(Blame::Own([false, false, true])),
            (false, _) => Some(Blame::RotationOf),
        };
    };
    let parts = [!same(local, expected_local), !same(given.rotation, turned(local)), third];
    parts.contains(&true).then_some(Blame::Own(parts))
}

#[cfg(test)]
mod tests {
    use skeleton::{FkFunctions, Frame, pose_frame};

    use super::*;
    use crate::samples;

    fn locals(skeleton: &Skeleton, frame: &Frame, functions: &FkFunctions) -> Vec<LocalAnswer> {
        let mut cursor = FrameCursor::new(&frame.angles);
        let ask =
            |joint| LocalAnswer { rotation: (functions.local_quaternion)(joint, &mut cursor), taken: 0 };
        skeleton.joints().iter().map(ask).collect()
    }

    fn judge(functions: FkFunctions, joint: usize, with_locals: bool) -> Blame {
        let motion = samples::chain(3, 1.0);
        let (skeleton, frame) = (motion.skeleton(), motion.frame(2));
        let mut given = Pose::default();
        pose_frame(skeleton, &frame, &functions, &mut given);
        let locals = locals(skeleton, &frame, &functions);
        let case = Case {
            skeleton,
            angles: &frame.angles,
            local_positions: &frame.local_positions,
            given: &given,
            locals: with_locals.then_some(&locals[..]),
            size: 1.0,
        };
        blame(&case, JointId(joint))
    }

    #[test]
    fn nobody_is_to_blame_where_all_is_right() {
        assert!((0..5).all(|joint| judge(solutions::FK, joint, true) == Blame::Nobody));
        assert!((0..5).all(|joint| judge(solutions::FK, joint, false) == Blame::Nobody));
    }

    #[test]
    fn each_part_is_told_by_itself() {
        let first = FkFunctions {
            local_quaternion: |joint, frame| (solutions::FK.local_quaternion)(joint, frame).inverse(),
            ..solutions::FK
        };
        assert_eq!(judge(first, 1, true), Blame::Own([true, false, false]));
        assert_eq!(judge(first, 1, false), Blame::RotationOf);
        let second = FkFunctions { global_quaternion: |_, local, _| local, ..solutions::FK };
        assert_eq!(judge(second, 1, true), Blame::Own([false, true, false]));
        assert_eq!(judge(second, 0, true), Blame::Nobody, "a root has no parent to forget");
        let third = FkFunctions { global_position: |_, position, _| position, ..solutions::FK };
        assert_eq!(judge(third, 1, true), Blame::Own([false, false, true]));
        assert_eq!(judge(third, 1, false), Blame::Own([false, false, true]));
    }

    #[test]
    fn what_comes_from_above_is_told_with_the_joint_that_it_comes_from() {
        let root_only = FkFunctions {
            local_quaternion: |joint, frame| {
                let right = (solutions::FK.local_quaternion)(joint, frame);
                if joint.is_root() { Quat::from_rotation_x(1.0) } else { right }
            },
            ..solutions::FK
        };
        assert_eq!(judge(root_only, 2, true), Blame::Above(JointId(0)));
    }

    #[test]
    fn what_is_no_number_is_the_fault_of_the_part_that_made_it() {
        let nan = FkFunctions { global_position: |_, _, _| Vec3::NAN, ..solutions::FK };
        assert_eq!(judge(nan, 0, true), Blame::Own([false, false, true]));
        let nan = FkFunctions { local_quaternion: |_, _| Quat::NAN, ..solutions::FK };
        assert_eq!(judge(nan, 0, true), Blame::Own([true, false, false]), "the others hand it on");
        let once = FkFunctions {
            local_quaternion: |joint, frame| {
                let right = (solutions::FK.local_quaternion)(joint, frame);
                if joint.is_root() { Quat::NAN } else { right }
            },
            ..solutions::FK
        };
        assert_eq!(judge(once, 2, true), Blame::Above(JointId(0)));
        let not_unit =
            FkFunctions { local_quaternion: |_, _| Quat::from_xyzw(1.0, 2.0, 3.0, 4.0), ..solutions::FK };
        assert_eq!(judge(not_unit, 0, true), Blame::Own([true, false, false]));
    }

    #[test]
    fn a_joint_finds_its_own_angles() {
        let motion = samples::chain(3, 1.0);
        let frame = motion.frame(2);
        let of = |joint| angles_of(motion.skeleton(), &frame.angles, JointId(joint)).map(<[f32]>::to_vec);
        assert_eq!(of(0).unwrap(), frame.angles[..3]);
        assert_eq!(of(1).unwrap(), frame.angles[3..6]);
        assert_eq!((of(2), of(3), of(99)), (None, None, None));
    }
}
