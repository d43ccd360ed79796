use glam::{Quat, Vec3};
use parser::bvh;
use proptest::prelude::*;
use skeleton::{Frame, Pose, PositionChannels, Skeleton, pose_frame};
use solutions::interpolation::interpolate_frame;

use super::*;

/// One joint as drawn by chance: how far up the open branch it hangs, its offset, and its channels.
type Drawn = (usize, [f32; 3], Vec<Channel>);

/// Channels in any order, some or all of them, with a number of rotation channels out of `turning`.
fn channels(turning: &'static [usize]) -> impl Strategy<Value = Vec<Channel>> {
    let all = Axis::ALL.into_iter().flat_map(|axis| [Channel::Position(axis), Channel::Rotation(axis)]);
    let all: Vec<Channel> = all.collect();
    (Just(all).prop_shuffle(), 0usize..=3, prop::sample::select(turning)).prop_map(|(all, moved, turned)| {
        let (mut moves, mut turns) = (0, 0);
        let stays = |channel: &Channel| {
            let (count, most) = match channel {
                Channel::Position(_) => (&mut moves, moved),
                Channel::Rotation(_) => (&mut turns, turned),
            };
            *count += 1;
            *count <= most
        };
        all.into_iter().filter(stays).collect()
    })
}

fn skeletons(turning: &'static [usize]) -> impl Strategy<Value = Skeleton> {
    let joint = (0usize..3, [-10.0f32..10.0, 5.0..15.0, -10.0..10.0], channels(turning));
    prop::collection::vec(joint, 1..6).prop_map(|drawn: Vec<Drawn>| {
        let mut skeleton = Skeleton::new();
        let mut branch = Vec::new();
        for (index, (up, offset, mut channels)) in drawn.into_iter().enumerate() {
            branch.truncate(branch.len().saturating_sub(up).max(usize::from(index > 0)));
            if index == 0 && channels.is_empty() {
                // The format holds no frames of a skeleton without channels.
                channels.push(Channel::Position(Axis::X));
            }
            let parent = branch.last().copied();
            let name = format!("joint {index}");
            branch.push(skeleton.add_joint(parent, name, Vec3::from_array(offset), channels).unwrap());
        }
        skeleton.add_end_site(branch[branch.len() - 1], "End Site", Vec3::Y * 5.0).unwrap();
        skeleton
    })
}

/// A motion and keyframes of it.
fn motions(turning: &'static [usize]) -> impl Strategy<Value = (Motion, Vec<usize>)> {
    let value = || prop_oneof![8 => -800.0f32..800.0, 1 => Just(90.0f32), 1 => Just(-180.0f32)];
    let sized = (skeletons(turning), 2usize..12);
    let rows = sized.prop_flat_map(move |(skeleton, frames)| {
        let values = prop::collection::vec(value(), skeleton.channel_count() * frames);
        let inner = prop::collection::vec(any::<bool>(), frames);
        (Just(skeleton), Just(frames), values, inner)
    });
    rows.prop_map(|(skeleton, frames, mut values, inner)| {
        let places = skeleton.joints().iter().flat_map(|joint| &joint.channels);
        let moves: Vec<bool> = places.map(|channel| matches!(channel, Channel::Position(_))).collect();
        for row in values.chunks_exact_mut(moves.len()) {
            row.iter_mut().zip(&moves).filter(|(_, moves)| **moves).for_each(|(value, _)| *value /= 40.0);
        }
        let keyframes = (0..frames).filter(|frame| *frame == 0 || *frame == frames - 1 || inner[*frame]);
        let keyframes = keyframes.collect();
        (Motion::new(skeleton, frames, 0.04, values).unwrap(), keyframes)
    })
}

fn made(motion: &Motion, keyframes: &[usize], representation: Representation) -> Reduced {
    reduced(motion, &clip(motion, representation, PositionChannels::Replace), keyframes)
}

fn clip(motion: &Motion, representation: Representation, positions: PositionChannels) -> InbetweenClip {
    InbetweenClip::new(motion.skeleton(), &frames(motion, positions), representation)
}

fn frames(motion: &Motion, positions: PositionChannels) -> Vec<Frame> {
    let mut frames = vec![Frame::default(); motion.frame_count()];
    for (index, frame) in frames.iter_mut().enumerate() {
        motion.read_frame(index, positions, frame);
    }
    frames
}

fn rotation_channels(joint: &Joint) -> usize {
    turns(joint).count()
}

/// Writes the motion, reads it, poses every frame, and compares with the reference's interpolation.
fn assert_poses(
    motion: &Motion,
    keyframes: &[usize],
    representation: Representation,
    positions: PositionChannels,
) -> Result<(), TestCaseError> {
    let reduced = reduced(motion, &clip(motion, representation, positions), keyframes).motion;
    let mut text = Vec::new();
    bvh::write(&reduced, &mut text).unwrap();
    let read = bvh::read(&text[..]).unwrap().motion;
    prop_assert_eq!(&read, &reduced);
    prop_assert_eq!(
        (read.skeleton(), read.frame_count(), read.frame_time()),
        (motion.skeleton(), motion.frame_count(), motion.frame_time())
    );
    for keyframe in keyframes {
        prop_assert_eq!(read.row(*keyframe), motion.row(*keyframe));
    }
    let (skeleton, read, originals) =
        (motion.skeleton(), frames(&read, positions), frames(motion, positions));
    let tolerance = 1e-4 * skeleton.extent().max(1.0);
    let (mut pose, mut expected) = (Pose::default(), Pose::default());
    for gap in keyframes.windows(2) {
        for (frame, read) in read.iter().enumerate().take(gap[1]).skip(gap[0]) {
            let t = (frame - gap[0]) as f32 / (gap[1] - gap[0]) as f32;
            let (from, to) = (&originals[gap[0]], &originals[gap[1]]);
            inbetween::pose_of(
                skeleton,
                &interpolate_frame(skeleton, from, to, t, representation),
                &mut expected,
            );
            pose_frame(skeleton, read, &solutions::FK, &mut pose);
            for (found, expected) in pose.transforms().iter().zip(expected.transforms()) {
                let off = found.position.distance(expected.position);
                prop_assert!(off <= tolerance, "frame {frame} is off by {off}, extent {}", skeleton.extent());
            }
        }
    }
    Ok(())
}

proptest! {
    #[test]
    fn a_file_of_euler_angles_poses_as_the_interpolation_does(
        (motion, keyframes) in motions(&[0, 1, 2, 3]), added in any::<bool>(),
    ) {
        let positions = if added { PositionChannels::Add } else { PositionChannels::Replace };
        assert_poses(&motion, &keyframes, Representation::Euler, positions)?;
        prop_assert!(made(&motion, &keyframes, Representation::Euler).misfits.is_empty());
    }

    /// Rotations about one axis stay about it, so that one rotation channel holds them.
    #[test]
    fn a_file_of_quaternions_poses_as_the_interpolation_does(
        (motion, keyframes) in motions(&[0, 1, 3]), added in any::<bool>(),
    ) {
        let positions = if added { PositionChannels::Add } else { PositionChannels::Replace };
        assert_poses(&motion, &keyframes, Representation::Quaternion, positions)?;
        let misfits = made(&motion, &keyframes, Representation::Quaternion).misfits;
        prop_assert!(misfits.is_empty(), "{misfits:?}");
    }

    #[test]
    fn rotations_that_two_channels_cannot_hold_are_told_and_are_not_off_by_more(
        (motion, keyframes) in motions(&[0, 2]),
    ) {
        let Reduced { motion: written, misfits } = made(&motion, &keyframes, Representation::Quaternion);
        let (originals, written) = (frames(&motion, PositionChannels::Replace), frames(&written, PositionChannels::Replace));
        let skeleton = motion.skeleton();
        let mut worst = vec![0.0f64; skeleton.len()];
        for gap in keyframes.windows(2) {
            for (frame, same) in written.iter().enumerate().take(gap[1]).skip(gap[0]) {
                let t = (frame - gap[0]) as f32 / (gap[1] - gap[0]) as f32;
                let (from, to) = (&originals[gap[0]], &originals[gap[1]]);
                let wanted = interpolate_frame(skeleton, from, to, t, Representation::Quaternion);
                let found = interpolate_frame(skeleton, same, same, 0.0, Representation::Quaternion);
                for (worst, (wanted, found)) in worst.iter_mut().zip(wanted.rotations.iter().zip(&found.rotations)) {
                    let rest: Quat = wanted.inverse() * *found;
                    let degrees = f64::from(2.0 * rest.xyz().length().atan2(rest.w.abs())).to_degrees();
                    *worst = worst.max(degrees);
                }
            }
        }
        for joint in skeleton.joints() {
            let told = misfits.iter().find(|misfit| misfit.joint == joint.id);
            let worst = worst[joint.id.0];
            match told {
                Some(misfit) => {
                    prop_assert!((misfit.degrees - worst).abs() < 0.02, "{misfit:?}, found {worst}");
                    prop_assert!(misfit.channels == rotation_channels(joint) && misfit.channels == 2);
                }
                None => prop_assert!(worst < 2.0 * LEAST_MISFIT, "{}: {worst} degrees", joint.name),
            }
        }
    }

    /// Over a long gap angles are close to those of the frame before, however far that is from the keyframes: they change
    /// faster than the joint turns only where the middle angle makes them.
    #[test]
    fn angles_go_on_from_the_frame_before(
        order in prop::sample::select(skeleton::RotationOrder::ROTATING.to_vec()),
        from in [-400.0f32..400.0, -400.0..400.0, -400.0..400.0],
        to in [-400.0f32..400.0, -400.0..400.0, -400.0..400.0],
    ) {
        const FRAMES: usize = 300;
        let mut skeleton = Skeleton::new();
        skeleton.add_joint(None, "r", Vec3::ZERO, order.axes().unwrap().map(Channel::Rotation)).unwrap();
        let mut values = from.to_vec();
        values.resize(3 * (FRAMES - 1), 0.0);
        values.extend(to);
        let motion = Motion::new(skeleton, FRAMES, 0.1, values).unwrap();
        let written = made(&motion, &[0, FRAMES - 1], Representation::Quaternion).motion;
        for frame in 1..FRAMES - 1 {
            let [before, now] = [frame - 1, frame].map(|frame| written.row(frame).unwrap());
            let slope = before[1].to_radians().cos().abs().min(now[1].to_radians().cos().abs());
            // At most half a turn in all these frames, and so much more as the slope says.
            let most = 2.0 * 180.0 / FRAMES as f32 / slope.max(1e-3) + 0.01;
            for (before, now) in before.iter().zip(now) {
                prop_assert!((now - before).abs() <= most, "frame {frame}: from {before} to {now}, slope {slope}");
            }
        }
    }

    /// From one frame to the next an angle never goes more than half a turn, but to a keyframe, whose numbers are its own.
    #[test]
    fn between_keyframes_no_angle_jumps(
        (motion, keyframes) in motions(&[1, 3]), quaternions in any::<bool>(),
    ) {
        let representation = Representation::ALL[usize::from(quaternions)];
        let written = made(&motion, &keyframes, representation).motion;
        let places = motion.skeleton().joints().iter().flat_map(|joint| &joint.channels);
        for (column, channel) in places.enumerate() {
            if let Channel::Rotation(_) = channel {
                for frame in (1..motion.frame_count()).filter(|frame| !keyframes.contains(frame)) {
                    let [before, now] = [frame - 1, frame].map(|frame| written.row(frame).unwrap()[column]);
                    prop_assert!((now - before).abs() <= 180.01, "from {before} to {now}");
                }
            }
        }
    }
}

#[test]
fn no_keyframes_and_odd_keyframes_change_nothing() {
    let motion = bvh::read_file(concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/arm.bvh")).unwrap().motion;
    for representation in Representation::ALL {
        for keyframes in [&[][..], &[0], &[0, 1], &[375, 376, 900], &[9, 5], &[4000, 5000]] {
            assert_eq!(made(&motion, keyframes, representation).motion, motion, "{keyframes:?}");
        }
        assert_eq!(made(&Motion::default(), &[0, 1], representation).motion, Motion::default());
    }
}

#[test]
fn where_a_motion_stands_still_its_numbers_stay() {
    let mut skeleton = Skeleton::new();
    let channels = Axis::ALL.map(Channel::Rotation);
    skeleton.add_joint(None, "r", Vec3::ZERO, channels).unwrap();
    // The same rotation, one full turn apart.
    let values = vec![10.0, 0.0, 0.0, 370.0, 0.0, 0.0, 10.0, 0.0, 0.0];
    let motion = Motion::new(skeleton, 3, 0.1, values).unwrap();
    for representation in Representation::ALL {
        assert_eq!(made(&motion, &[0, 2], representation).motion, motion);
    }
}
