//! The clip's poses are those of the exercises' solutions.
#![allow(clippy::unwrap_used)] // Helpers of tests.

use glam::Vec3;
use inbetween::{InbetweenClip, Scratch, pose_of};
use proptest::collection::vec;
use proptest::prelude::*;
use skeleton::{
    Axis, Channel, Clip, Frame, Joint, JointId, LocalPose, Motion, Pose, Representation, Skeleton, Transform,
};
use solutions::{FK, INTERPOLATION};

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

fn frames(motion: &Motion) -> Vec<Frame> {
    (0..motion.frame_count()).map(|index| motion.frame(index)).collect()
}

/// Joints of all rotation orders and of none, with position channels or without, below any joint before them or below none;
/// End Sites below some.
fn motion(frames: std::ops::Range<usize>) -> impl Strategy<Value = Motion> {
    let place = prop::array::uniform3(-5.0_f32..5.0).prop_map(Vec3::from);
    let axes = prop::sample::select(&Axis::ALL[..]).prop_map(Some);
    let rotations = prop_oneof![
        1 => Just(vec![]),
        6 => Just(Axis::ALL.to_vec()).prop_shuffle(),
        1 => axes.prop_map(|axis| axis.into_iter().collect()),
    ];
    let joint = (
        any::<prop::sample::Index>(),
        prop::bool::weighted(0.1),
        place,
        rotations,
        0_u8..8,
        prop::bool::weighted(0.3),
    );
    (vec(joint, 0..12), frames)
        .prop_flat_map(|(joints, frames)| {
            let mut skeleton = Skeleton::new();
            for (parent, is_root, offset, rotations, positions, has_end_site) in joints {
                let inner: Vec<JointId> = skeleton
                    .joints()
                    .iter()
                    .filter(|joint| !joint.is_end_site)
                    .map(|joint| joint.id)
                    .collect();
                let parent = (!is_root && !inner.is_empty()).then(|| inner[parent.index(inner.len())]);
                let positions =
                    Axis::ALL.into_iter().filter(|axis| positions >> axis.index() & 1 == 1 && positions < 4);
                let channels: Vec<Channel> = positions
                    .map(Channel::Position)
                    .chain(rotations.into_iter().map(Channel::Rotation))
                    .collect();
                let joint = skeleton.add_joint(parent, "joint", offset, channels).unwrap();
                if has_end_site {
                    skeleton.add_end_site(joint, "End Site", -offset).unwrap();
                }
            }
            // Most angles are within a turn or so, few are large, and some are the same again and again.
            let value = prop_oneof![8 => -360.0_f32..360.0, 1 => -1000.0_f32..1000.0, 2 => Just(30.0)];
            let count = frames * skeleton.channel_count();
            (Just(skeleton), Just(frames), vec(value, count))
        })
        .prop_map(|(skeleton, frames, values)| Motion::new(skeleton, frames, 1.0 / 30.0, values).unwrap())
}
