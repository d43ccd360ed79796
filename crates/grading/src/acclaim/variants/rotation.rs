//! Part 1. Right is the product of three rotations: the parent's, the bone's axes at rest, and the angles'.

use glam::{Quat, Vec3};
use skeleton::Axis;
use skeleton::acclaim::Bone;

use crate::fk::variants::{Exact, Pi};

use Axis::{X, Y, Z};

/// The product of the three rotations by these angles, in radians.
fn zyx([x, y, z]: [f32; 3]) -> Quat {
    Quat::from_rotation_z(z) * Quat::from_rotation_y(y) * Quat::from_rotation_x(x)
}

fn turn(angles: [f32; 3]) -> Quat {
    zyx(angles.map(f32::to_radians))
}

/// Right, but for the number that someone takes for π.
pub fn by_pi<P: Pi>(bone: &Bone, angles: [f32; 3], parent: Quat) -> Quat {
    parent * bone.rot_parent_current * zyx(angles.map(|degrees| degrees * P::PI / 180.0))
}

fn right(bone: &Bone, angles: [f32; 3], parent: Quat) -> Quat {
    by_pi::<Exact>(bone, angles, parent)
}

/// What each makes of the bone's axes at rest, its angles (degrees), and its parent's rotation.
macro_rules! products {
    ($($(#[$doc:meta])* $name:ident($bone:pat, $angles:pat, $parent:pat) = $product:expr;)*) => {
        $(
            $(#[$doc])*
            pub fn $name($bone: &Bone, $angles: [f32; 3], $parent: Quat) -> Quat {
                $product
            }
        )*
    };
}

products! {
    rest_left_out(_, angles, parent) = parent * turn(angles);
    rest_after_angles(bone, angles, parent) = parent * turn(angles) * bone.rot_parent_current;
    rest_before_parent(bone, angles, parent) = bone.rot_parent_current * parent * turn(angles);
    rest_inverted(bone, angles, parent) = parent * bone.rot_parent_current.inverse() * turn(angles);
    /// The axes against the world's, as if the parent's were the world's.
    world_axes(bone, angles, parent) = parent * bone.axis_rotation * turn(angles);
    rest_taken_back(bone, angles, parent) = {
        parent * bone.rot_parent_current * turn(angles) * bone.rot_parent_current.inverse()
    };
    fixed_is_its_parent(bone, angles, parent) = {
        if bone.dofs.is_empty() { parent } else { right(bone, angles, parent) }
    };
    fixed_is_not_turned(bone, angles, parent) = {
        if bone.dofs.is_empty() { Quat::IDENTITY } else { right(bone, angles, parent) }
    };

    parent_left_out(bone, angles, _) = bone.rot_parent_current * turn(angles);
    world_axes_alone(bone, angles, _) = bone.axis_rotation * turn(angles);
    angles_alone(_, angles, _) = turn(angles);
    own_times_parent(bone, angles, parent) = bone.rot_parent_current * turn(angles) * parent;
    reversed(bone, angles, parent) = turn(angles) * bone.rot_parent_current * parent;
    angles_in_front(bone, angles, parent) = turn(angles) * parent * bone.rot_parent_current;
    parent_inverted(bone, angles, parent) = parent.inverse() * bone.rot_parent_current * turn(angles);

    angles_times_parent(_, angles, parent) = turn(angles) * parent;

    /// The three angles as one rotation's axis, times its angle.
    rotation_vector(bone, angles, parent) = {
        parent * bone.rot_parent_current * Quat::from_scaled_axis(Vec3::from(angles.map(f32::to_radians)))
    };

    angles_left_out(bone, _, parent) = parent * bone.rot_parent_current;
    degrees_as_radians(bone, angles, parent) = parent * bone.rot_parent_current * zyx(angles);
    to_degrees(bone, angles, parent) = parent * bone.rot_parent_current * zyx(angles.map(f32::to_degrees));
    to_radians_twice(bone, angles, parent) = {
        parent * bone.rot_parent_current * turn(angles.map(f32::to_radians))
    };
    not_halved(bone, angles, parent) = {
        parent * bone.rot_parent_current * turn(angles.map(|angle| 2.0 * angle))
    };
    angles_negated(bone, angles, parent) = parent * bone.rot_parent_current * turn(angles.map(|angle| -angle));
    angles_inverted(bone, angles, parent) = parent * bone.rot_parent_current * turn(angles).inverse();

    inverse(bone, angles, parent) = right(bone, angles, parent).inverse();
    /// Turned back from the bone's own axes: a rotation of what is written in the world's axes.
    against_rest_pose(bone, angles, parent) = right(bone, angles, parent) * bone.axis_rotation.inverse();
    /// The same by a formula for parents that are turned back too.
    conjugated(bone, angles, parent) = {
        parent * bone.axis_rotation * turn(angles) * bone.axis_rotation.inverse()
    };

    root_axes_left_out(bone, angles, parent) = {
        if bone.is_root() { turn(angles) } else { right(bone, angles, parent) }
    };
    root_is_not_turned(bone, angles, parent) = {
        if bone.is_root() { Quat::IDENTITY } else { right(bone, angles, parent) }
    };
    root_keeps_its_axes(bone, angles, parent) = {
        if bone.is_root() { bone.rot_parent_current } else { right(bone, angles, parent) }
    };
}

/// The axes in all orders. The last one is right.
const ORDERS: [[Axis; 3]; 6] = [[X, Y, Z], [X, Z, Y], [Y, X, Z], [Y, Z, X], [Z, X, Y], [Z, Y, X]];

/// Multiplies in one of the [`ORDERS`]. Of `TAKEN`, which is one of them too, the first axis gets the first angle, and
/// so on: 0 is right.
pub fn ordered<const ORDER: usize, const TAKEN: usize>(bone: &Bone, angles: [f32; 3], parent: Quat) -> Quat {
    ordered_radians::<ORDER, TAKEN>(bone, angles.map(f32::to_radians), parent)
}

/// The same with the angles for radians, whatever they are.
pub fn ordered_radians<const ORDER: usize, const TAKEN: usize>(
    bone: &Bone,
    angles: [f32; 3],
    parent: Quat,
) -> Quat {
    let mut of_axis = [0.0; 3];
    for (axis, angle) in ORDERS[TAKEN].into_iter().zip(angles) {
        of_axis[axis.index()] = angle;
    }
    let turn = |axis: Axis| Quat::from_axis_angle(axis.unit(), of_axis[axis.index()]);
    parent * bone.rot_parent_current * ORDERS[ORDER].into_iter().map(turn).product::<Quat>()
}

/// The three numbers as x, y, z of a quaternion with this w, in degrees or radians.
pub fn packed<const W: u8, const RADIANS: bool>(bone: &Bone, angles: [f32; 3], parent: Quat) -> Quat {
    let [x, y, z] = if RADIANS { angles.map(f32::to_radians) } else { angles };
    parent * bone.rot_parent_current * Quat::from_xyzw(x, y, z, f32::from(W))
}

/// The same, made a unit quaternion where that can be done.
pub fn packed_normalized<const W: u8, const RADIANS: bool>(
    bone: &Bone,
    angles: [f32; 3],
    parent: Quat,
) -> Quat {
    packed::<W, RADIANS>(bone, angles, parent).normalize()
}
