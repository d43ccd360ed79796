//! Forward kinematics: from a frame of angles to joints in the world.
//!
//! This is the only file that you edit, and the only one that you hand in. It holds three functions. The program
//! calls them for every joint of the skeleton, once per frame, always a parent before its children.
//!
//! - Try it: `cargo view` opens a window in which the joints move as your functions say.
//! - Check it: `cargo test -p fk` shows your points and what to do next; `cargo test -p fk part1` checks part 1 only.
//!
//! Each function is also checked by itself: use only what it is given, and keep nothing between calls.
//!
//! All axes are right-handed. Angles in a motion are in degrees. A quaternion is written (x, y, z, w), and `a * b`
//! is the rotation that does `b` first and `a` after it.

use glam::{Quat, Vec3};
#[allow(unused_imports)] // You may need all of them.
use skeleton::{Axis, FrameCursor, Joint, Pose, RotationOrder};

/// Part 1 (5 points): how a joint is turned relative to its parent.
///
/// **In:** the `joint`, and the `frame` from which every joint takes its own three angles, in degrees.
/// `frame.take3()` gives the next three and moves on, so that the next joint finds its own.
/// `joint.rotation_order` says which axes they belong to: with `Xyz` they are the angles about X, Y and Z, with
/// `Zyx` those about Z, Y and X. With `RotationOrder::None` the joint has no angles: take nothing from the frame.
///
/// **Out:** the joint's local rotation as a unit quaternion; without angles, no rotation.
///
/// Each rotation is about the joint's own axes, as the rotations before it have left them (Euler angles, not fixed
/// angles). A turn by the angle `a` about the unit axis `u` is the quaternion (u sin(a/2), cos(a/2)), where `a` is
/// in radians: degrees times π/180.
///
/// **Example.** With the order `Zyx` and the angles 90, 0, 0 the joint makes a quarter turn about Z. The quaternion is
/// (0, 0, 0.7071, 0.7071), and what pointed along X now points along Y.
pub fn local_quaternion(joint: &Joint, frame: &mut FrameCursor) -> Quat {
    // solution-begin
    let Some([first, second, third]) = joint.rotation_order.axes() else {
        return Quat::IDENTITY;
    };
    let [a, b, c] = frame.take3();
    let turn = |axis: Axis, degrees: f32| Quat::from_axis_angle(axis.unit(), degrees.to_radians());
    // Each rotation happens about axes that those to its left have already turned.
    turn(first, a) * turn(second, b) * turn(third, c)
    // solution-else
    // let _ = (joint, &frame); // Keeps the compiler quiet for now. Delete this line when you start.
    // Quat::IDENTITY
    // solution-end
}

/// Part 2 (5 points): how a joint is turned in the world.
///
/// **In:** the `joint`, its `local` rotation from part 1, and the `pose`, which holds the global transforms of all
/// joints before this one. `joint.parent` is `Some(parent)`, and then `pose[parent].rotation` is the parent's global
/// rotation. It is `None` for a root, which has no parent.
///
/// **Out:** the joint's global rotation as a unit quaternion.
///
/// You need not walk up the skeleton: the parent's rotation already combines all those above it.
///
/// **Example.** The parent is turned a quarter about Z, the joint a quarter about its own X. The joint's own X axis
/// then points along the world's Y, and its own Y axis along the world's Z: (0.5, 0.5, 0.5, 0.5).
pub fn global_quaternion(joint: &Joint, local: Quat, pose: &Pose) -> Quat {
    // solution-begin
    match joint.parent {
        Some(parent) => pose[parent].rotation * local,
        None => local,
    }
    // solution-else
    // let _ = (joint, pose); // As above.
    // local
    // solution-end
}

/// Part 3 (5 points): where a joint is in the world.
///
/// **In:** the `joint`; its `local_position`, which says how far it is from its parent, along the parent's own axes,
/// in the motion's unit; and the `pose` as in part 2: `pose[parent].position` is where the parent is. (The local
/// position is mostly `joint.offset`, but a frame can put another one in its place, and for a root it does.)
///
/// **Out:** the joint's global position, in the motion's unit.
///
/// The parent's axes are turned in the world by the parent's global rotation. `q * v` turns the vector `v` by the
/// quaternion `q`.
///
/// **Example.** The parent is at (10, 0, 0), turned a quarter about Z, and the joint is 2 along the parent's X axis.
/// That axis points along the world's Y, so the joint is at (10, 2, 0).
pub fn global_position(joint: &Joint, local_position: Vec3, pose: &Pose) -> Vec3 {
    // solution-begin
    match joint.parent {
        Some(parent) => pose[parent].position + pose[parent].rotation * local_position,
        None => local_position,
    }
    // solution-else
    // let _ = (joint, pose); // As above.
    // local_position
    // solution-end
}
