//! The vocabulary, from easy to hard.
#![allow(clippy::unwrap_used)] // Helpers of tests.

use glam::{Quat, Vec3};
use proptest::prelude::*;
use skeleton::{
    Axis, Channel, FkFunctions, Frame, FrameCursor, Joint, JointId, Leftover, Motion, Pose, PositionChannels,
    RotationOrder, Skeleton, SkeletonError, pose_frame,
};

use Axis::{X, Y, Z};
use Channel::{Position, Rotation};

mod rotation_order {
    use super::*;

    #[test]
    fn has_the_assignments_numbers() {
        let numbers = RotationOrder::ROTATING.map(|order| order as u8);
        assert_eq!(numbers, [1, 2, 3, 5, 6, 7]);
        assert_eq!(RotationOrder::None as u8, 0);
    }

    #[test]
    fn is_named_after_its_axes() {
        for order in RotationOrder::ROTATING {
            let name: String = order.axes().unwrap().iter().map(Axis::to_string).collect();
            assert_eq!(order.to_string(), name);
        }
        assert_eq!(RotationOrder::None.to_string(), "NONE");
    }

    #[test]
    fn is_that_of_the_rotation_channels_wherever_they_stand() {
        let of = RotationOrder::of_channels;
        assert_eq!(of(&[Rotation(Z), Rotation(X), Rotation(Y)]), RotationOrder::Zxy);
        assert_eq!(of(&[Rotation(Z), Position(X), Rotation(X), Rotation(Y)]), RotationOrder::Zxy);
        assert_eq!(of(&[Position(X), Position(Y), Position(Z)]), RotationOrder::None);
        assert_eq!(of(&[]), RotationOrder::None);
    }

    #[test]
    fn completes_missing_axes() {
        assert_eq!(RotationOrder::of_channels(&[Rotation(Z)]), RotationOrder::Zxy);
        assert_eq!(RotationOrder::of_channels(&[Rotation(Y), Rotation(X)]), RotationOrder::Yxz);
    }
}

mod channel {
    use super::*;

    #[test]
    fn is_read_by_its_word_in_any_case() {
        for axis in Axis::ALL {
            for channel in [Position(axis), Rotation(axis)] {
                assert_eq!(Channel::from_word(channel.word()), Some(channel));
                assert_eq!(Channel::from_word(&channel.word().to_uppercase()), Some(channel));
            }
        }
        assert_eq!(Channel::from_word("Wrotation"), None);
    }
}

mod frame_cursor {
    use super::*;

    #[test]
    fn gives_three_angles_after_the_other() {
        let mut cursor = FrameCursor::new(&[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
        assert_eq!(cursor.peek3(), [1.0, 2.0, 3.0]);
        assert_eq!(cursor.take3(), [1.0, 2.0, 3.0]);
        assert_eq!(cursor.take3(), [4.0, 5.0, 6.0]);
        assert_eq!((cursor.taken(), cursor.overrun()), (6, false));
    }

    #[test]
    fn gives_zeros_behind_the_end_and_remembers() {
        let mut cursor = FrameCursor::new(&[1.0]);
        assert_eq!(cursor.take3(), [1.0, 0.0, 0.0]);
        assert_eq!((cursor.taken(), cursor.overrun()), (3, true));
    }
}

mod skeleton_tree {
    use super::*;

    #[test]
    fn refuses_what_would_break_its_order() {
        let mut skeleton = Skeleton::new();
        let later = JointId(5);
        assert_eq!(
            skeleton.add_joint(Some(later), "a", Vec3::ZERO, []),
            Err(SkeletonError::UnknownParent(later))
        );
        let root = skeleton.add_joint(None, "root", Vec3::ZERO, []).unwrap();
        let end = skeleton.add_end_site(root, "End Site", Vec3::Y).unwrap();
        assert_eq!(
            skeleton.add_joint(Some(end), "b", Vec3::ZERO, []),
            Err(SkeletonError::ChildOfEndSite(end))
        );
        assert_eq!(
            skeleton.add_joint(Some(root), "c", Vec3::ZERO, [Rotation(X), Rotation(X)]),
            Err(SkeletonError::RepeatedChannel(Rotation(X)))
        );
        assert_eq!(skeleton.len(), 2);
    }

    #[test]
    fn is_built_anew_from_its_joints() {
        let mut skeleton = Skeleton::new();
        let root = skeleton.add_joint(None, "root", Vec3::X, [Rotation(Z), Position(X)]).unwrap();
        skeleton.add_end_site(root, "End Site", Vec3::Y).unwrap();
        let mut joints: Vec<Joint> = skeleton.clone().into();
        assert_eq!(Skeleton::try_from(joints.clone()), Ok(skeleton));
        joints.swap(0, 1);
        assert_eq!(Skeleton::try_from(joints), Err(SkeletonError::UnknownParent(root)));
    }

    #[test]
    fn measures_its_extent_in_the_rest_pose() {
        let mut skeleton = Skeleton::new();
        assert_eq!(skeleton.extent(), 0.0);
        let root = skeleton.add_joint(None, "root", Vec3::splat(100.0), []).unwrap();
        assert_eq!(skeleton.extent(), 0.0);
        let knee = skeleton.add_joint(Some(root), "knee", Vec3::new(3.0, 0.0, 0.0), []).unwrap();
        skeleton.add_end_site(knee, "End Site", Vec3::new(0.0, 4.0, 0.0)).unwrap();
        assert_eq!(skeleton.extent(), 5.0);
        assert_eq!(skeleton.rest_positions()[2], Vec3::new(103.0, 104.0, 100.0));
        assert_eq!(skeleton.label(JointId(2)), "End Site of knee");
        assert_eq!(skeleton.depths(), [0, 1, 2]);
    }
}

mod motion {
    use super::*;

    fn one_joint(channels: &[Channel], row: &[f32]) -> Motion {
        let mut skeleton = Skeleton::new();
        skeleton.add_joint(None, "root", Vec3::new(10.0, 20.0, 30.0), channels).unwrap();
        Motion::new(skeleton, 1, 0.1, row.to_vec()).unwrap()
    }

    #[test]
    fn wants_frames_times_channels_values() {
        let skeleton = one_joint(&[Rotation(X)], &[0.0]).skeleton().clone();
        assert!(Motion::new(skeleton.clone(), 2, 0.1, vec![0.0; 2]).is_ok());
        let error = Motion::new(skeleton.clone(), 2, 0.1, vec![0.0; 3]).unwrap_err();
        assert_eq!(error.to_string(), "2 frames of 1 channels cannot be made of 3 values");
        assert!(Motion::new(skeleton, usize::MAX, 0.1, vec![]).is_err());
    }

    #[test]
    fn a_position_channel_replaces_the_offset_on_its_axis_or_is_added_to_it() {
        let motion = one_joint(&[Position(Y)], &[1.0]);
        assert_eq!(motion.frame(0).local_positions, [Vec3::new(10.0, 1.0, 30.0)]);
        let mut frame = Frame::default();
        motion.read_frame(0, PositionChannels::Add, &mut frame);
        assert_eq!(frame.local_positions, [Vec3::new(10.0, 21.0, 30.0)]);
    }

    #[test]
    fn channels_are_found_wherever_they_stand() {
        let channels = [Rotation(Z), Position(Z), Rotation(X), Position(X), Rotation(Y)];
        let frame = one_joint(&channels, &[1.0, 2.0, 3.0, 4.0, 5.0]).frame(0);
        assert_eq!(frame.angles, [1.0, 3.0, 5.0]);
        assert_eq!(frame.local_positions, [Vec3::new(4.0, 20.0, 2.0)]);
    }

    #[test]
    fn missing_angles_are_zero() {
        assert_eq!(one_joint(&[Rotation(Y)], &[7.0]).frame(0).angles, [7.0, 0.0, 0.0]);
        assert!(one_joint(&[], &[]).frame(0).angles.is_empty());
    }

    #[test]
    fn behind_the_last_frame_is_the_rest_pose() {
        let motion = one_joint(&[Position(X), Rotation(X)], &[5.0, 6.0]);
        assert_eq!(motion.row(1), None);
        assert_eq!(motion.frame(1).local_positions, [Vec3::new(10.0, 20.0, 30.0)]);
    }

    #[test]
    fn what_cannot_be_played_is_played_at_30_per_second() {
        let skeleton = Skeleton::new();
        for odd in [0.0, -1.0, 5e-324, 1e-7, 1e7, f64::NAN, f64::INFINITY] {
            let motion = Motion::new(skeleton.clone(), 0, odd, vec![]).unwrap();
            assert_eq!(motion.playable_frame_time(), 1.0 / 30.0);
        }
    }
}

mod traversal {
    use super::*;

    const TEMPLATE: FkFunctions = FkFunctions {
        local_quaternion: |_, _| Quat::IDENTITY,
        global_quaternion: |_, local, _| local,
        global_position: |_, local_position, _| local_position,
    };

    fn chain() -> (Skeleton, Frame) {
        let mut skeleton = Skeleton::new();
        let all = [Position(X), Position(Y), Position(Z), Rotation(X), Rotation(Y), Rotation(Z)];
        let root = skeleton.add_joint(None, "root", Vec3::X, all).unwrap();
        let elbow = skeleton.add_joint(Some(root), "elbow", Vec3::Y, &all[3..]).unwrap();
        skeleton.add_end_site(elbow, "End Site", Vec3::Z).unwrap();
        let row = vec![7.0, 8.0, 9.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
        let frame = Motion::new(skeleton.clone(), 1, 0.1, row).unwrap().frame(0);
        (skeleton, frame)
    }

    #[test]
    fn with_the_template_the_root_moves_and_the_rest_stays_at_its_offsets() {
        let (skeleton, frame) = chain();
        let mut pose = Pose::default();
        let leftover = pose_frame(&skeleton, &frame, &TEMPLATE, &mut pose);
        let positions: Vec<Vec3> = pose.transforms().iter().map(|transform| transform.position).collect();
        assert_eq!(positions, [Vec3::new(7.0, 8.0, 9.0), Vec3::Y, Vec3::Z]);
        assert_eq!(leftover, Leftover { taken: 0, available: 6 });
    }

    #[test]
    fn part_3_sees_the_joints_own_rotation_and_nothing_that_comes_later() {
        let functions = FkFunctions {
            local_quaternion: |joint, _| Quat::from_rotation_y(1.0 + joint.id.0 as f32),
            global_position: |joint, _, pose| {
                let later = pose.transforms()[joint.id.0 + 1..].iter();
                assert!(later.into_iter().all(|transform| transform.rotation == Quat::IDENTITY));
                pose[joint.id].rotation.xyz()
            },
            ..TEMPLATE
        };
        let (skeleton, frame) = chain();
        let mut pose = Pose::default();
        // The second time, nothing of the first may be left.
        for _ in 0..2 {
            pose_frame(&skeleton, &frame, &functions, &mut pose);
            assert!(pose.transforms().iter().all(|t| t.position == t.rotation.xyz() && t.position.y > 0.4));
        }
    }

    #[test]
    fn all_joints_share_one_cursor() {
        let functions = FkFunctions {
            local_quaternion: |joint, frame| match joint.rotation_order {
                RotationOrder::None => Quat::IDENTITY,
                _ => Quat::from_vec4(Vec3::from(frame.take3()).extend(0.0)),
            },
            ..TEMPLATE
        };
        let (skeleton, frame) = chain();
        let mut pose = Pose::default();
        let leftover = pose_frame(&skeleton, &frame, &functions, &mut pose);
        assert_eq!(pose[JointId(1)].rotation.xyz(), Vec3::new(4.0, 5.0, 6.0));
        assert_eq!(leftover, Leftover { taken: 6, available: 6 });
    }
}

fn channels() -> impl Strategy<Value = Vec<Channel>> {
    let all: Vec<Channel> = Axis::ALL.into_iter().flat_map(|axis| [Position(axis), Rotation(axis)]).collect();
    proptest::sample::subsequence(all, 0..=6).prop_shuffle()
}

proptest! {
    /// Every number of a row reaches its joint: a frame holds all angles and all positions, in their order.
    #[test]
    fn a_row_is_sorted_completely(rows in prop::collection::vec(channels(), 1..12)) {
        let mut skeleton = Skeleton::new();
        for channels in &rows {
            let parent = skeleton.len().checked_sub(1).map(JointId);
            skeleton.add_joint(parent, "joint", Vec3::splat(-1.0), channels.clone()).unwrap();
        }
        let count = skeleton.channel_count();
        let values: Vec<f32> = (0..count).map(|value| value as f32 + 1.0).collect();
        let frame = Motion::new(skeleton.clone(), 1, 0.1, values).unwrap().frame(0);

        let mut next = 1.0;
        let mut angles = Vec::new();
        for (joint, position) in skeleton.joints().iter().zip(&frame.local_positions) {
            let mut own = [0.0; 3];
            let mut turned = 0;
            for channel in &joint.channels {
                match channel {
                    Position(axis) => prop_assert_eq!(position[axis.index()], next),
                    Rotation(axis) => {
                        let axes = joint.rotation_order.axes().unwrap();
                        prop_assert_eq!(axes[turned], *axis);
                        own[turned] = next;
                        turned += 1;
                    }
                }
                next += 1.0;
            }
            if turned > 0 {
                angles.extend(own);
            }
        }
        prop_assert_eq!(frame.angles, angles);
    }
}
