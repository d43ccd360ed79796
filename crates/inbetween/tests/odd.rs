//! Frames that a motion does not have, and numbers that are none: no panic, and what the documentation says.
#![allow(clippy::unwrap_used)] // Helpers of tests.

mod support;

use glam::{Quat, Vec3};
use inbetween::{InbetweenClip, Scratch, pose_of};
use proptest::prelude::*;
use skeleton::{Clip, Frame, LocalPose, Pose, Representation, Skeleton};
use support::{frames, motion};

proptest! {
    #[test]
    fn frames_outside_count_as_the_nearest(
        motion in motion(1..6),
        asked in prop::array::uniform3(prop_oneof![0_usize..8, Just(usize::MAX)]),
        representation in prop::sample::select(&Representation::ALL[..]),
    ) {
        let clip = InbetweenClip::new(motion.skeleton(), &frames(&motion), representation);
        let last = motion.frame_count() - 1;
        let [start, end, frame] = asked.map(|frame| frame.min(last));
        let end = end.max(start);
        let frame = frame.clamp(start, end);
        let (mut pose, mut expected) = (Pose::default(), Pose::default());
        clip.between(asked[0], asked[1], asked[2], &mut pose);
        clip.between(start, end, frame, &mut expected);
        prop_assert_eq!(&pose, &expected);
        prop_assert_eq!(clip.local_between(asked[0], asked[1], asked[2]), clip.local_between(start, end, frame));
        let (mut scratch, mut nearest) = (Scratch::default(), Scratch::default());
        prop_assert_eq!(
            clip.tips_between(asked[0], asked[1], asked[2], &mut scratch),
            clip.tips_between(start, end, frame, &mut nearest)
        );
        clip.original(asked[2], &mut pose);
        clip.original(asked[2].min(last), &mut expected);
        prop_assert_eq!(&pose, &expected);
        prop_assert_eq!(clip.local(asked[2]), clip.local(asked[2].min(last)));
        prop_assert_eq!(clip.is_still(asked[0], asked[1]), clip.is_still(asked[0].min(last), asked[1].min(last)));
    }

    #[test]
    fn a_motion_without_frames_stands_in_its_rest_pose(
        motion in motion(0..1),
        [start, end, frame] in prop::array::uniform3(0_usize..3),
        representation in prop::sample::select(&Representation::ALL[..]),
    ) {
        let clip = inbetween::clip(motion.skeleton(), &[], representation);
        prop_assert_eq!(clip.frame_count(), 0);
        let mut pose = Pose::default();
        clip.between(start, end, frame, &mut pose);
        let positions: Vec<Vec3> = pose.transforms().iter().map(|transform| transform.position).collect();
        prop_assert_eq!(positions, motion.skeleton().rest_positions());
        let clip = InbetweenClip::new(motion.skeleton(), &[], representation);
        prop_assert!(clip.is_still(start, end));
        prop_assert!(clip.tips(frame).is_empty());
        prop_assert!(clip.tips_between(start, end, frame, &mut Scratch::default()).is_empty());
        prop_assert_eq!(clip.local(frame).positions.len(), motion.skeleton().len());
    }

    #[test]
    fn no_number_makes_it_panic(
        motion in motion(1..5),
        odd in prop::collection::vec(prop::num::f32::ANY, 1..20),
        representation in prop::sample::select(&Representation::ALL[..]),
    ) {
        let mut frames = frames(&motion);
        let mut odd = odd.into_iter().cycle();
        for frame in &mut frames {
            frame.angles.iter_mut().zip(&mut odd).for_each(|(angle, odd)| *angle = odd);
            frame.local_positions.iter_mut().zip(&mut odd).for_each(|(position, odd)| *position = Vec3::splat(odd));
        }
        let clip = InbetweenClip::new(motion.skeleton(), &frames, representation);
        let mut pose = Pose::default();
        for frame in 0..frames.len() {
            clip.between(0, frames.len() - 1, frame, &mut pose);
            prop_assert_eq!(pose.len(), motion.skeleton().len());
        }
    }
}

#[test]
fn what_a_frame_lacks_is_as_in_the_rest_pose() {
    let text = include_bytes!("../../../data/arm.bvh");
    let motion = parser::bvh::read(&text[..]).unwrap().motion;
    let skeleton = motion.skeleton();
    for representation in Representation::ALL {
        let clip = InbetweenClip::new(skeleton, &[Frame::default(), motion.frame(100)], representation);
        let mut pose = Pose::default();
        clip.original(0, &mut pose);
        let positions: Vec<Vec3> = pose.transforms().iter().map(|transform| transform.position).collect();
        assert_eq!(positions, skeleton.rest_positions());
    }
    let mut pose = Pose::default();
    pose_of(skeleton, &LocalPose::default(), &mut pose);
    assert_eq!(pose.transforms().last().unwrap().position, *skeleton.rest_positions().last().unwrap());
    assert_eq!(pose.transforms()[0].rotation, Quat::IDENTITY);
}

#[test]
fn a_skeleton_without_joints_has_empty_poses() {
    let clip =
        InbetweenClip::new(&Skeleton::new(), &[Frame::default(), Frame::default()], Representation::Euler);
    let mut pose = Pose::identity(5);
    clip.between(0, 1, 1, &mut pose);
    assert!(pose.is_empty() && clip.tips(0).is_empty() && clip.is_still(0, 1));
}
