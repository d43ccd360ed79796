//! Part 2. Right is the parent's end, and from there the turned bone and the translation.

use glam::{Quat, Vec3};
use skeleton::acclaim::Bone;

/// From start to end along the world's axes.
fn way(bone: &Bone, rotation: Quat) -> Vec3 {
    rotation * own_way(bone)
}

/// From start to end along the bone's own axes.
fn own_way(bone: &Bone) -> Vec3 {
    bone.length * bone.local_direction
}

/// Starts where it should, and ends as each says.
macro_rules! ends {
    ($($(#[$doc:meta])* $name:ident($bone:pat, $rotation:pat, $parent_end:ident, $translation:pat) = $end:expr;)*) => {
        $(
            $(#[$doc])*
            pub fn $name(
                $bone: &Bone,
                $rotation: Quat,
                $parent_end: Vec3,
                $translation: Vec3,
            ) -> (Vec3, Vec3) {
                ($parent_end, $end)
            }
        )*
    };
}

ends! {
    length_left_out(bone, rotation, from, moved) = from + rotation * bone.local_direction + moved;
    world_direction(bone, rotation, from, moved) = from + rotation * bone.rest_vector() + moved;
    not_rotated(bone, _, from, moved) = from + own_way(bone) + moved;
    as_at_rest(bone, _, from, moved) = from + bone.rest_vector() + moved;
    inverse(bone, rotation, from, moved) = from + rotation.inverse() * own_way(bone) + moved;
    from_the_left_only(bone, rotation, from, moved) = from + (rotation * pure(own_way(bone))).xyz() + moved;
    from_the_right_only(bone, rotation, from, moved) = from + (pure(own_way(bone)) * rotation).xyz() + moved;
    length_twice(bone, rotation, from, moved) = from + bone.length * way(bone, rotation) + moved;
    rest_again(bone, rotation, from, moved) = from + rotation * (bone.rot_parent_current * own_way(bone)) + moved;
    rest_in_front(bone, rotation, from, moved) = from + bone.rot_parent_current * way(bone, rotation) + moved;
    backwards(bone, rotation, from, moved) = from - way(bone, rotation) + moved;
    bone_left_out(_, _, from, moved) = from + moved;

    /// The bone and its translation begin at the origin.
    parent_end_not_added(bone, rotation, from, moved) = way(bone, rotation) + moved;
    parent_end_rotated(bone, rotation, from, moved) = rotation * (from + own_way(bone)) + moved;
    all_rotated(bone, rotation, from, moved) = rotation * (from + own_way(bone) + moved);

    translation_left_out(bone, rotation, from, _) = from + way(bone, rotation);
    translation_rotated(bone, rotation, from, moved) = from + rotation * (own_way(bone) + moved);
    translation_subtracted(bone, rotation, from, moved) = from + way(bone, rotation) - moved;
}

fn pure(v: Vec3) -> Quat {
    Quat::from_xyzw(v.x, v.y, v.z, 0.0)
}

/// As if every bone lay along the same one of its axes: 0, 1, 2.
pub fn along_an_axis<const AXIS: usize>(
    bone: &Bone,
    rotation: Quat,
    from: Vec3,
    moved: Vec3,
) -> (Vec3, Vec3) {
    (from, from + rotation * (bone.length * Vec3::AXES[AXIS]) + moved)
}

pub fn start_moved(bone: &Bone, rotation: Quat, from: Vec3, moved: Vec3) -> (Vec3, Vec3) {
    (from + moved, from + moved + way(bone, rotation))
}

pub fn start_moved_instead(bone: &Bone, rotation: Quat, from: Vec3, moved: Vec3) -> (Vec3, Vec3) {
    (from + moved, from + way(bone, rotation))
}

pub fn start_at_origin(bone: &Bone, rotation: Quat, from: Vec3, moved: Vec3) -> (Vec3, Vec3) {
    (Vec3::ZERO, from + way(bone, rotation) + moved)
}

pub fn start_at_translation(bone: &Bone, rotation: Quat, from: Vec3, moved: Vec3) -> (Vec3, Vec3) {
    (moved, from + way(bone, rotation) + moved)
}

pub fn exchanged(bone: &Bone, rotation: Quat, from: Vec3, moved: Vec3) -> (Vec3, Vec3) {
    (from + way(bone, rotation) + moved, from)
}

pub fn root_at_translation(bone: &Bone, rotation: Quat, from: Vec3, moved: Vec3) -> (Vec3, Vec3) {
    if bone.is_root() { (moved, moved) } else { (from, from + way(bone, rotation) + moved) }
}
