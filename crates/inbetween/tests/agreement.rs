//! The clip's poses are those of the exercises' solutions.
#![allow(clippy::unwrap_used)] // Helpers of tests.

mod support;

use glam::Vec3;
use inbetween::{InbetweenClip, Scratch, pose_of};
use proptest::prelude::*;
use skeleton::{Clip, Joint, LocalPose, Pose, Representation, Skeleton, Transform};
use solutions::{FK, INTERPOLATION};
use support::{frames, motion};

/// Angles of some hundred degrees are stored to a ten-thousandth, and bones are up to 5 long, a dozen in a row.
const TOLERANCE: f32 = 2e-3;

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
        let local = (INTERPOLATION.interpolate_frame)(motion.skeleton(), from, to, t, representation);
        let expected = globals(motion.skeleton(), &local);
        let mut pose = Pose::default();
        clip.between(start, end, frame, &mut pose);
        is_close(&pose, &expected)?;
        pose_of(motion.skeleton(), &clip.local_between(start, end, frame), &mut pose);
        is_close(&pose, &expected)?;
        let mut scratch = Scratch::default();
        let tips = clip.tips_between(start, end, frame, &mut scratch);
        is_close_at_tips(motion.skeleton(), tips, &expected)?;
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
            skeleton::pose_frame(motion.skeleton(), frame, &FK, &mut expected);
            clip.original(index, &mut pose);
            is_close(&pose, &expected)?;
            pose_of(motion.skeleton(), &clip.local(index), &mut pose);
            is_close(&pose, &expected)?;
            is_close_at_tips(motion.skeleton(), clip.tips(index), &expected)?;
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

fn is_close(pose: &Pose, expected: &Pose) -> Result<(), TestCaseError> {
    prop_assert_eq!(pose.len(), expected.len());
    for (Transform { rotation, position }, expected) in pose.transforms().iter().zip(expected.transforms()) {
        prop_assert!(position.distance(expected.position) < TOLERANCE, "{position} {}", expected.position);
        let dot = rotation.dot(expected.rotation).abs();
        prop_assert!((1.0 - dot).abs() < 1e-5, "{rotation} {}", expected.rotation);
    }
    Ok(())
}

fn is_close_at_tips(skeleton: &Skeleton, tips: &[Vec3], expected: &Pose) -> Result<(), TestCaseError> {
    let is_parent = |joint: &Joint| skeleton.joints().iter().any(|child| child.parent == Some(joint.id));
    let leaves: Vec<&Joint> = skeleton.joints().iter().filter(|joint| !is_parent(joint)).collect();
    prop_assert_eq!(tips.len(), leaves.len());
    for (tip, joint) in tips.iter().zip(leaves) {
        let expected = expected[joint.id].position;
        prop_assert!(tip.distance(expected) < TOLERANCE, "{tip} {expected}");
    }
    Ok(())
}
