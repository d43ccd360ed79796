//! A short motion, with all its poses: as they are, and as they would be between any two keyframes.

use exam::keyframes::Question;
use glam::Vec3;
use skeleton::{
    Axis, Channel, Frame, JointId, LocalPose, Motion, Pose, Representation, RotationOrder, Skeleton,
    pose_frame,
};
use solutions::fk::{global_position, global_quaternion};
use solutions::interpolation::interpolate_frame;

use super::wander::wander;
use crate::dice::Dice;

/// Asks for `count` keyframes of a motion of `frames` frames. Rotations are interpolated as quaternions.
pub(super) fn question(dice: &mut Dice, frames: usize, count: usize) -> Question {
    let skeleton = small_figure(dice);
    let motion = wandering(dice, &skeleton, frames);
    let frames: Vec<Frame> = (0..motion.frame_count()).map(|index| motion.frame(index)).collect();
    let original = |frame| {
        let mut pose = Pose::default();
        pose_frame(&skeleton, frame, &solutions::FK, &mut pose);
        pose
    };
    let mut between = Vec::new();
    for start in 0..frames.len() {
        for frame in start + 1..frames.len() {
            for end in frame + 1..frames.len() {
                let t = (frame - start) as f32 / (end - start) as f32;
                let (from, to) = (&frames[start], &frames[end]);
                let local = interpolate_frame(&skeleton, from, to, t, Representation::Quaternion);
                between.push(global(&skeleton, &local));
            }
        }
    }
    Question::Chain { originals: frames.iter().map(original).collect(), skeleton, between, count }
}

/// Local to global, parents first.
fn global(skeleton: &Skeleton, local: &LocalPose) -> Pose {
    let mut pose = Pose::identity(skeleton.len());
    let parts = local.rotations.iter().zip(&local.positions);
    for (joint, (rotation, position)) in skeleton.joints().iter().zip(parts) {
        pose[joint.id].rotation = global_quaternion(joint, *rotation, &pose);
        pose[joint.id].position = global_position(joint, *position, &pose);
    }
    pose
}

/// Few joints, for there are many poses of them. One of the tips is no End Site.
fn small_figure(dice: &mut Dice) -> Skeleton {
    let mut orders = RotationOrder::ROTATING.to_vec();
    dice.shuffle(&mut orders);
    let mut skeleton = Skeleton::new();
    let mut add = |parent: Option<JointId>, name: &str, offset: [f32; 3]| {
        let moved = Axis::ALL.into_iter().filter(|_| parent.is_none()).map(Channel::Position);
        let turned = orders.pop().and_then(RotationOrder::axes).into_iter().flatten().map(Channel::Rotation);
        let added =
            skeleton.add_joint(parent, name, Vec3::from(offset), moved.chain(turned).collect::<Vec<_>>());
        added.expect("parents are added first, and every channel once")
    };
    let hips = add(None, "Hips", [0.0, 0.0, 0.0]);
    let chest = add(Some(hips), "Chest", [0.0, 5.0, 0.5]);
    let arm = add(Some(chest), "LeftArm", [3.0, 0.5, 0.0]);
    add(Some(arm), "LeftHand", [4.0, -1.0, 0.0]);
    let leg = add(Some(hips), "RightLeg", [-1.5, -1.0, 0.0]);
    for (parent, offset) in [(chest, [0.0, 3.0, 0.5]), (leg, [0.0, -7.0, 1.0])] {
        let added = skeleton.add_end_site(parent, "End Site", Vec3::from(offset));
        added.expect("the parent has just been added");
    }
    skeleton
}

/// Every channel goes its own way.
fn wandering(dice: &mut Dice, skeleton: &Skeleton, frames: usize) -> Motion {
    let channels: Vec<Channel> = skeleton.joints().iter().flat_map(|joint| joint.channels.clone()).collect();
    let track = |channel: &Channel| {
        let (from, scale) = match channel {
            Channel::Position(_) => (dice.angle(0.0, 5.0), 0.2),
            Channel::Rotation(_) => (dice.angle(0.0, 60.0), 4.0),
        };
        let way = wander(dice, frames).into_iter().map(move |value| from + scale * value as f32);
        way.collect::<Vec<f32>>()
    };
    let tracks: Vec<Vec<f32>> = channels.iter().map(track).collect();
    let values = (0..frames).flat_map(|frame| tracks.iter().map(move |track| track[frame])).collect();
    Motion::new(skeleton.clone(), frames, 1.0 / 30.0, values).expect("one value per channel and frame")
}
