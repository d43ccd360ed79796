//! Random motions.
#![allow(dead_code, clippy::unwrap_used)] // Every test file uses its own part of this.

use glam::Vec3;
use proptest::collection::vec;
use proptest::prelude::*;
use skeleton::{Axis, Channel, Frame, JointId, Motion, Skeleton};

pub fn frames(motion: &Motion) -> Vec<Frame> {
    (0..motion.frame_count()).map(|index| motion.frame(index)).collect()
}

/// Joints of all rotation orders and of none, with position channels or without, below any joint before them or below
/// none; End Sites below some.
pub fn motion(frames: std::ops::Range<usize>) -> impl Strategy<Value = Motion> {
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
