//! From bones to joints.

use glam::{Quat, Vec3};
use skeleton::acclaim::{self, Bone, BoneId, Motion, Posture};
use skeleton::{Axis, Channel, JointId, RotationOrder, Skeleton};

use super::ConvertError;
use super::euler::{rotation, zyx_near};

/// The same motion of joints, as BVH has it, with `frame_time` seconds from one frame to the next (a motion of bones says
/// nothing about time; 1/120 is usual).
///
/// Every bone becomes a joint at its start, and a bone on which nothing hangs gets an End Site. At rest the joints' axes
/// are the world's: where a bone's own axes are turned against them, its angles become others, in the order Z, Y, X,
/// without leaps from frame to frame. A bone without dofs becomes a joint without channels. Lengths stay as they are.
///
/// # Errors
///
/// When a bone other than the root is moved and not only turned.
pub fn to_joints(motion: &Motion, frame_time: f64) -> Result<skeleton::Motion, ConvertError> {
    let bones = depth_first(motion.skeleton());
    let skeleton = joints(motion, &bones)?;
    let mut values = Vec::with_capacity(skeleton.channel_count().saturating_mul(motion.frame_count()));
    let mut posture = Posture::default();
    let mut last = vec![[0.0; 3]; motion.skeleton().len()];
    for frame in 0..motion.frame_count() {
        motion.read_posture(frame, &mut posture);
        for bone in &bones {
            let translation = posture.translations[bone.id.0];
            if bone.is_root() {
                values.extend(translation.to_array());
            } else if translation != Vec3::ZERO {
                return Err(ConvertError::MovedBone { bone: bone.name.clone(), frame: frame + 1 });
            }
            let last = &mut last[bone.id.0];
            if let Some(axes) = order(bone).axes() {
                let angles = posture.angles[bone.id.0];
                *last = if is_turned(bone) {
                    zyx_near(in_world_axes(bone, angles), *last)
                } else {
                    axes.map(|axis| angles[axis.index()])
                };
                values.extend(*last);
            }
        }
    }
    Ok(skeleton::Motion::new(skeleton, motion.frame_count(), frame_time, values)?)
}

/// The root and all bones, each in front of those that hang on it, and these in front of its siblings: the order of joints in
/// BVH.
pub fn depth_first(skeleton: &acclaim::Skeleton) -> Vec<&Bone> {
    let mut bones = Vec::with_capacity(skeleton.len());
    let mut next = vec![BoneId::ROOT];
    while let Some(bone) = next.pop().and_then(|id| skeleton.get(id)) {
        bones.push(bone);
        next.extend(bone.sibling);
        next.extend(bone.child);
    }
    bones
}

fn joints(motion: &Motion, bones: &[&Bone]) -> Result<Skeleton, ConvertError> {
    let mut skeleton = Skeleton::new();
    let mut ids: Vec<Option<JointId>> = vec![None; bones.len()];
    for bone in bones {
        let rotations = order(bone).axes().into_iter().flatten().map(Channel::Rotation);
        let (parent, offset, positions) = match bone.parent.and_then(|parent| motion.skeleton().get(parent)) {
            Some(parent) => (ids[parent.id.0], parent.rest_vector(), &[][..]),
            None => (None, motion.skeleton().position(), &Axis::ALL[..]),
        };
        let channels: Vec<Channel> =
            positions.iter().copied().map(Channel::Position).chain(rotations).collect();
        let id = skeleton.add_joint(parent, bone.name.clone(), offset, channels)?;
        ids[bone.id.0] = Some(id);
        if bone.child.is_none() && !bone.is_root() {
            skeleton.add_end_site(id, "End Site", bone.rest_vector())?;
        }
    }
    Ok(skeleton)
}

/// Whether a bone's own axes are not the world's.
fn is_turned(bone: &Bone) -> bool {
    bone.axis.angles != [0.0; 3]
}

/// The order of a joint's rotation channels: the bone's own, as long as its axes are the world's.
fn order(bone: &Bone) -> RotationOrder {
    match bone.rotation_order {
        RotationOrder::None if !bone.is_root() => RotationOrder::None,
        RotationOrder::None => RotationOrder::Zyx,
        _ if is_turned(bone) => RotationOrder::Zyx,
        order => order,
    }
}

/// A rotation by `angles` about the bone's own axes, as one about the world's.
fn in_world_axes(bone: &Bone, angles: [f32; 3]) -> Quat {
    let c = bone.axis_rotation;
    (c * rotation(bone.rotation_order, angles) * c.inverse()).normalize()
}
