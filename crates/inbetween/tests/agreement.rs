//! The clip's poses are those of the exercises' solutions.
#![allow(clippy::unwrap_used)] // Helpers of tests.

mod support;

use glam::Vec3;
use inbetween::{InbetweenClip, Scratch, pose_of};
use proptest::prelude::*;
use skeleton::{Clip, Frame, Joint, LocalPose, Pose, Representation, Skeleton, Transform};
use solutions::{FK, INTERPOLATION};
use support::{frames, motion};

/// Angles of some hundred degrees are stored to a ten-thousandth or so, and a dozen joints in a row add up what that loses.
const TOLERANCE: f32 = 5e-6;

proptest! {
    #[test]
    fn between_is_what_the_solutions_make_of_it(
        motion in motion(2..8),
        [start, end, frame] in prop::array::uniform3(0_usize..8),
        representation in prop::sample::select(&Representation::ALL[..]),
    ) {
        let frames = frames(&motion);
        let clip = InbetweenClip::new(motion.skeleton(), &frames, representation);
        let last = frames.len() - 1;
        let (start, end) = (start.min(end).min(last), end.max(start).min(last));
        let frame = frame.clamp(start, end);
        let t = (frame - start) as f32 / (end - start).max(1) as f32;
        let (from, to) = (&frames[start], &frames[end]);
        let reach = reach(from).max(reach(to));
        let local = (INTERPOLATION.interpolate_frame)(motion.skeleton(), from, to, t, representation);
        let expected = globals(motion.skeleton(), &local);
        let mut pose = Pose::default();
        clip.between(start, end, frame, &mut pose);
        is_close(&pose, &expected, reach)?;
        pose_of(motion.skeleton(), &clip.local_between(start, end, frame), &mut pose);
        is_close(&pose, &expected, reach)?;
        let mut scratch = Scratch::default();
        let tips = clip.tips_between(start, end, frame, &mut scratch);
        is_close_at_tips(motion.skeleton(), tips, &expected, reach)?;
    }

    #[test]
    fn the_original_is_the_pose_of_forward_kinematics(
        motion in motion(1..4),
        representation in prop::sample::select(&Representation::ALL[..]),
    ) {
        let frames = frames(&motion);
        let clip = InbetweenClip::new(motion.skeleton(), &frames, representation);
        let (mut pose, mut expected) = (Pose::default(), Pose::default());
        for (index, frame) in frames.iter().enumerate() {
            let reach = reach(frame);
            skeleton::pose_frame(motion.skeleton(), frame, &FK, &mut expected);
            clip.original(index, &mut pose);
            is_close(&pose, &expected, reach)?;
            pose_of(motion.skeleton(), &clip.local(index), &mut pose);
            is_close(&pose, &expected, reach)?;
            is_close_at_tips(motion.skeleton(), clip.tips(index), &expected, reach)?;
        }
    }
}

/// By the global functions of forward kinematics.
fn globals(skeleton: &Skeleton, local: &LocalPose) -> Pose {
    let mut pose = Pose::identity(skeleton.len());
    for joint in skeleton.joints() {
        let (rotation, position) = (local.rotations[joint.id.0], local.positions[joint.id.0]);
        pose[joint.id].rotation = (FK.global_quaternion)(joint, rotation, &pose);
        pose[joint.id].position = (FK.global_position)(joint, position, &pose);
    }
    pose
}

/// How far from the origin a joint can be at most.
fn reach(frame: &Frame) -> f32 {
    frame.local_positions.iter().map(|position| position.length()).sum()
}

fn is_close(pose: &Pose, expected: &Pose, reach: f32) -> Result<(), TestCaseError> {
    prop_assert_eq!(pose.len(), expected.len());
    for (Transform { rotation, position }, expected) in pose.transforms().iter().zip(expected.transforms()) {
        prop_assert!(
            position.distance(expected.position) <= TOLERANCE * reach,
            "{position} {}",
            expected.position
        );
        let dot = rotation.dot(expected.rotation).abs();
        prop_assert!((1.0 - dot).abs() < 1e-5, "{rotation} {}", expected.rotation);
    }
    Ok(())
}

fn is_close_at_tips(
    skeleton: &Skeleton,
    tips: &[Vec3],
    expected: &Pose,
    reach: f32,
) -> Result<(), TestCaseError> {
    let is_parent = |joint: &Joint| skeleton.joints().iter().any(|child| child.parent == Some(joint.id));
    let leaves: Vec<&Joint> = skeleton.joints().iter().filter(|joint| !is_parent(joint)).collect();
    prop_assert_eq!(tips.len(), leaves.len());
    for (tip, joint) in tips.iter().zip(leaves) {
        let expected = expected[joint.id].position;
        prop_assert!(tip.distance(expected) <= TOLERANCE * reach, "{tip} {expected}");
    }
    Ok(())
}
