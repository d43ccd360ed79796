//! From bones to joints.

use glam::{Quat, Vec3};
use skeleton::acclaim::{self, Bone, BoneId, Motion, Posture};
use skeleton::{Axis, Channel, JointId, RotationOrder, Skeleton};

use super::ConvertError;
use super::names::Names;
use crate::angles::{angles_of, rotation_of};

/// The same motion of joints, as BVH has it, with `frame_time` seconds from one frame to the next (a motion of bones says
/// nothing about time; 1/120 is usual).
///
/// Every bone becomes a joint at its start, and a bone on which nothing hangs gets an End Site. At rest the joints' axes
/// are the world's: where a bone's own axes are turned against them, its angles become others, in the order Z, Y, X,
/// without leaps from frame to frame (until one is more than 100 000°, and loses its whole turns). A bone without dofs
/// becomes a joint without channels. Lengths stay as they are.
///
/// The end of a bone that has translations among its dofs is not always in the same place. What hangs there has position
/// channels, which say where it is instead of the offset; where nothing hangs, a joint without rotations stands for the end.
///
/// # Errors
///
/// None that a motion of bones is known to cause: what joints are built of was checked when the bones were.
pub fn to_joints(motion: &Motion, frame_time: f64) -> Result<skeleton::Motion, ConvertError> {
    let bones = depth_first(motion.skeleton());
    let skeleton = joints(motion, &bones)?;
    let mut values = Vec::with_capacity(skeleton.channel_count().saturating_mul(motion.frame_count()));
    let mut posture = Posture::default();
    let mut last = vec![[0.0_f64; 3]; bones.len()];
    // How each bone is turned against its rest pose, and where it ends, as seen from where it starts.
    let (mut turned, mut ends) = (vec![Quat::IDENTITY; bones.len()], vec![Vec3::ZERO; bones.len()]);
    for frame in 0..motion.frame_count() {
        motion.read_posture(frame, &mut posture);
        for bone in &bones {
            let id = bone.id.0;
            let (angles, translation) = (posture.angles[id], posture.translations[id]);
            let above = bone.parent.and_then(|parent| motion.skeleton().get(parent));
            match above {
                None => values.extend(translation.to_array()),
                Some(parent) if is_moved(parent) => values.extend(ends[parent.id.0].to_array()),
                Some(_) => {}
            }
            let turn = in_world_axes(bone, angles);
            let last = &mut last[id];
            if let Some(axes) = order(motion, bone).axes() {
                *last = if is_turned(bone) {
                    angles_of(turn, &axes, *last)
                } else {
                    axes.map(|axis| angles[axis.index()].into())
                };
                values.extend(last.map(|angle| angle as f32));
            }
            turned[id] = above.map_or(Quat::IDENTITY, |parent| turned[parent.id.0]) * turn;
            if is_moved(bone) {
                ends[id] = bone.rest_vector() + turned[id].inverse() * translation;
                if bone.child.is_none() {
                    values.extend(ends[id].to_array());
                }
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
    let mut names = Names::default();
    bones.iter().for_each(|bone| drop(names.give(&bone.name)));
    let positions = |moves: bool| Axis::ALL.into_iter().filter(move |_| moves).map(Channel::Position);
    let mut skeleton = Skeleton::new();
    let mut ids: Vec<Option<JointId>> = vec![None; bones.len()];
    for bone in bones {
        let rotations = order(motion, bone).axes().into_iter().flatten().map(Channel::Rotation);
        let (parent, offset, moves) = match bone.parent.and_then(|parent| motion.skeleton().get(parent)) {
            Some(parent) => (ids[parent.id.0], parent.rest_vector(), is_moved(parent)),
            None => (None, motion.skeleton().position(), true),
        };
        let channels: Vec<Channel> = positions(moves).chain(rotations).collect();
        let mut id = skeleton.add_joint(parent, bone.name.clone(), offset, channels)?;
        ids[bone.id.0] = Some(id);
        if bone.child.is_some() || bone.is_root() {
            continue;
        }
        let mut to_end = bone.rest_vector();
        if is_moved(bone) {
            let name = names.give(&format!("{}_end", bone.name));
            id = skeleton.add_joint(Some(id), name, to_end, positions(true).collect::<Vec<_>>())?;
            to_end = Vec3::ZERO;
        }
        skeleton.add_end_site(id, "End Site", to_end)?;
    }
    Ok(skeleton)
}

/// Whether a bone other than the root has translations among its dofs.
fn is_moved(bone: &Bone) -> bool {
    !bone.is_root() && bone.dofs.iter().any(|dof| matches!(dof.channel, Channel::Position(_)))
}

/// Whether a bone's own axes are not the world's.
fn is_turned(bone: &Bone) -> bool {
    bone.axis.angles != [0.0; 3]
}

/// The order of a joint's rotation channels: the bone's own, as long as its axes are the world's. A bone that only moves has
/// none.
fn order(motion: &Motion, bone: &Bone) -> RotationOrder {
    let is_rotation = |channel: &Channel| matches!(channel, Channel::Rotation(_));
    let listed = bone.dofs.iter().any(|dof| is_rotation(&dof.channel));
    // A motion can have all three rotations for a bone whose dofs are translations.
    let turns = listed || motion.columns().channels(bone.id).iter().any(is_rotation);
    match bone.rotation_order {
        _ if !turns && !bone.is_root() => RotationOrder::None,
        RotationOrder::None => RotationOrder::Zyx,
        _ if is_turned(bone) => RotationOrder::Zyx,
        order => order,
    }
}

/// A rotation by `angles` about the bone's own axes, as one about the world's.
fn in_world_axes(bone: &Bone, angles: [f32; 3]) -> Quat {
    let axes = bone.rotation_order.axes();
    let own = axes.map_or(Quat::IDENTITY, |axes| rotation_of(&axes, axes.map(|axis| angles[axis.index()])));
    let c = bone.axis_rotation;
    (c * own * c.inverse()).normalize()
}
