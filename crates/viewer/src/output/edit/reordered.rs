//! The same motion with its angles in another order.

use inbetween::InbetweenClip;
use parser::angles::angles_of;
use skeleton::{Axis, Channel, Frame, Joint, Motion, Representation, RotationOrder, Skeleton, SkeletonError};

/// The same motion, where every joint with three rotation channels has them in another order: in every frame every joint is
/// turned as before, by other angles. The first frame's angles are within half a turn, and all others go on from there.
///
/// # Errors
///
/// When the skeleton's joints do not make a skeleton: never, for one that is one.
pub fn reordered(motion: &Motion, order: RotationOrder) -> Result<Motion, SkeletonError> {
    let Some(axes) = order.axes() else { return Ok(motion.clone()) };
    let skeleton = with_channels(motion.skeleton(), |joint| {
        let mut axes = axes.iter();
        let other = |channel: &Channel| match channel {
            Channel::Rotation(_) if turns(joint).count() == 3 => {
                axes.next().map_or(*channel, |axis| Channel::Rotation(*axis))
            }
            _ => *channel,
        };
        joint.channels.iter().map(other).collect()
    })?;

    let frames: Vec<Frame> = (0..motion.frame_count()).map(|index| motion.frame(index)).collect();
    let clip = InbetweenClip::new(motion.skeleton(), &frames, Representation::Quaternion);
    let mut values = motion.values().to_vec();
    let mut nears = vec![[0.0; 3]; skeleton.len()];
    for (index, row) in values.chunks_exact_mut(skeleton.channel_count().max(1)).enumerate() {
        let rotations = clip.local(index).rotations;
        let mut column = 0;
        for (joint, near) in skeleton.joints().iter().zip(&mut nears) {
            if turns(joint).count() == 3 {
                *near = angles_of(rotations[joint.id.0], &axes, *near);
                for ((at, _), angle) in turns(joint).zip(*near) {
                    row[column + at] = angle as f32;
                }
            }
            column += joint.channels.len();
        }
    }
    let other = Motion::new(skeleton, motion.frame_count(), motion.frame_time(), values);
    Ok(other.expect("there are as many values as before"))
}

/// The same joints with other channels.
fn with_channels(
    skeleton: &Skeleton,
    channels: impl Fn(&Joint) -> Vec<Channel>,
) -> Result<Skeleton, SkeletonError> {
    let mut other = Skeleton::new();
    for joint in skeleton.joints() {
        match joint.parent {
            Some(parent) if joint.is_end_site => {
                other.add_end_site(parent, joint.name.clone(), joint.offset)?
            }
            parent => other.add_joint(parent, joint.name.clone(), joint.offset, channels(joint))?,
        };
    }
    Ok(other)
}

/// The rotation channels of a joint: their places among its channels, and their axes.
pub(crate) fn turns(joint: &Joint) -> impl Iterator<Item = (usize, Axis)> + '_ {
    joint.channels.iter().enumerate().filter_map(|(at, channel)| match channel {
        Channel::Rotation(axis) => Some((at, *axis)),
        Channel::Position(_) => None,
    })
}

#[cfg(test)]
mod tests {
    use skeleton::{Pose, pose_frame};

    use super::*;

    #[test]
    fn every_pose_stays_and_no_angle_jumps() {
        for name in ["dance", "arm"] {
            let path = format!("{}/../../data/{name}.bvh", env!("CARGO_MANIFEST_DIR"));
            let motion = parser::bvh::read_file(path).unwrap().motion;
            for order in RotationOrder::ROTATING {
                let other = reordered(&motion, order).unwrap();
                let orders = other.skeleton().joints().iter().map(|joint| joint.rotation_order);
                assert!(orders.filter(|own| *own != RotationOrder::None).all(|own| own == order));
                let (mut now, mut then) = (Pose::default(), Pose::default());
                for index in 0..motion.frame_count() {
                    pose_frame(motion.skeleton(), &motion.frame(index), &solutions::FK, &mut then);
                    pose_frame(other.skeleton(), &other.frame(index), &solutions::FK, &mut now);
                    for (now, then) in now.transforms().iter().zip(then.transforms()) {
                        assert!(now.position.distance(then.position) < 1e-4 * motion.skeleton().extent());
                    }
                }
                let angles = |index: usize| other.frame(index).angles;
                for index in 1..other.frame_count() {
                    let pairs = angles(index - 1).into_iter().zip(angles(index));
                    assert!(pairs.into_iter().all(|(before, now)| (before - now).abs() < 180.5));
                }
            }
            assert_eq!(reordered(&motion, RotationOrder::None).unwrap(), motion);
        }
    }
}
