//! Where bones are.

use glam::{Quat, Vec3};
use proptest::prelude::*;
use skeleton::acclaim::{BoneData, BoneId, DegreeOfFreedom, LocalAxes, Posture, Root, Skeleton};
use skeleton::{Axis, Channel, RotationOrder};

/// Where each bone ends: each turned about the world's axes against its rest pose. It starts where its parent ends.
pub fn ends(skeleton: &Skeleton, posture: &Posture) -> Vec<Vec3> {
    let mut placed: Vec<(Quat, Vec3)> = Vec::new();
    for bone in skeleton.bones() {
        let (above, start) = bone.parent.map_or((Quat::IDENTITY, Vec3::ZERO), |parent| placed[parent.0]);
        let angles = posture.angles[bone.id.0];
        let turn = |axis: Axis| Quat::from_axis_angle(axis.unit(), angles[axis.index()].to_radians());
        let own = bone.rotation_order.axes().into_iter().flatten().map(turn).product::<Quat>();
        let turned = above * bone.axis_rotation * own * bone.axis_rotation.inverse();
        placed.push((turned, start + turned * bone.rest_vector() + posture.translations[bone.id.0]));
    }
    placed.into_iter().map(|(_, end)| end).collect()
}

/// The skeleton's extent, or 1 if it has none.
pub fn measure(skeleton: &Skeleton) -> f32 {
    let extent = skeleton.extent();
    if extent > 0.0 { extent } else { 1.0 }
}

pub fn any_angles() -> impl Strategy<Value = [f32; 3]> {
    let angle = prop_oneof![-400f32..400.0, prop::sample::select(vec![0.0, 90.0, -90.0, 180.0])];
    prop::array::uniform3(angle)
}

pub fn any_order() -> impl Strategy<Value = RotationOrder> {
    prop::sample::select(RotationOrder::ROTATING.to_vec())
}

fn any_axes() -> impl Strategy<Value = LocalAxes> {
    let turned = (any_angles(), any_order()).prop_map(|(angles, order)| LocalAxes { angles, order });
    prop_oneof![Just(LocalAxes::WORLD), turned]
}

/// Some rotations, in any order.
pub fn any_rotations() -> impl Strategy<Value = Vec<Channel>> {
    let all = Axis::ALL.map(Channel::Rotation).to_vec();
    (Just(all).prop_shuffle(), 0usize..=3).prop_map(|(all, count)| all[..count].to_vec())
}

/// Some rotations and translations, in any order.
fn any_channels() -> impl Strategy<Value = Vec<Channel>> {
    let all = [Axis::ALL.map(Channel::Position), Axis::ALL.map(Channel::Rotation)].concat();
    (Just(all).prop_shuffle(), 0usize..=6).prop_map(|(all, count)| all[..count].to_vec())
}

fn any_bone(
    channels: impl Strategy<Value = Vec<Channel>>,
) -> impl Strategy<Value = (prop::sample::Index, BoneData)> {
    let dofs = channels.prop_map(|channels| channels.into_iter().map(DegreeOfFreedom::unlimited).collect());
    (any::<prop::sample::Index>(), prop::array::uniform3(-1f32..1.0), 0f32..5.0, any_axes(), dofs).prop_map(
        |(parent, direction, length, axis, dofs)| {
            let direction = Vec3::from_array(direction).normalize_or(Vec3::Y);
            (parent, BoneData { name: String::new(), direction, length, axis, dofs })
        },
    )
}

/// A skeleton whose bones turn about axes of their own, and do not move otherwise.
pub fn any_skeleton() -> impl Strategy<Value = Skeleton> {
    skeleton_of(any_bone(any_rotations()))
}

/// The same, with bones that are moved, too.
pub fn any_moving_skeleton() -> impl Strategy<Value = Skeleton> {
    skeleton_of(any_bone(any_channels()))
}

fn skeleton_of(
    bone: impl Strategy<Value = (prop::sample::Index, BoneData)>,
) -> impl Strategy<Value = Skeleton> {
    let order = (prop::array::uniform3(-9f32..9.0), any_axes(), any_rotations()).prop_map(
        |(position, orientation, rotations)| {
            let order = Axis::ALL.map(Channel::Position).into_iter().chain(rotations).collect();
            Root { order, orientation, position: Vec3::from_array(position) }
        },
    );
    (order, prop::collection::vec(bone, 0..10)).prop_map(|(root, plan)| {
        let mut skeleton = Skeleton::new(root).expect("a root");
        for (parent, bone) in plan {
            let name = format!("bone{}", skeleton.len());
            let parent = BoneId(parent.index(skeleton.len()));
            skeleton.add_bone(parent, BoneData { name, ..bone }).expect("a bone");
        }
        skeleton
    })
}
