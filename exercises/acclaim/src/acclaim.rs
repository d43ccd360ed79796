//! Acclaim forward kinematics: from a posture to bones in the world.
//!
//! This is the only file that you edit, and the only one that you hand in. It holds three functions. Each is checked by
//! itself, so that you can write and check them in any order.
//!
//! - Try it: `cargo view --exercise acclaim` opens a window in which the bones of a walk move as your functions say.
//! - Check it: `cargo test -p acclaim` shows your points and what to do next; `cargo test -p acclaim part1` checks part 1
//!   only.
//!
//! All axes are right-handed. Angles are in degrees. A quaternion is written (x, y, z, w), and `a * b` is the rotation
//! that does `b` first and `a` after it. Keep nothing between calls.

use glam::{Quat, Vec3};
#[allow(unused_imports)] // You may need all of them.
use skeleton::acclaim::{Bone, BoneId, Skeleton, Visitor};

/// Part 1 (5 points): how a bone is turned in the world.
///
/// **In:** the `bone`; its three `angles` about its own X, Y and Z axis, in degrees (zero where the bone cannot turn); and
/// the rotation of its `parent` in the world.
///
/// **Out:** the rotation that turns the bone's own axes into the world's, as a unit quaternion.
///
/// Every bone has axes of its own, already turned against its parent's when nothing moves:
/// `bone.rot_parent_current` is that rotation. Starting from the parent's axes, one goes to the bone's axes at rest, and from
/// there the angles turn on. Of the three turns X happens first and Z last: their product is Rz Ry Rx.
///
/// For the root the parent is the world, which is not turned: the same formula holds.
///
/// **Example.** The parent is turned a quarter about Z, the bone's axes at rest are its parent's, and its angles are
/// (90, 0, 0). Its own X axis then points along the world's Y, and its own Y axis along the world's Z:
/// (0.5, 0.5, 0.5, 0.5).
pub fn bone_rotation(bone: &Bone, angles: [f32; 3], parent: Quat) -> Quat {
    let _ = (bone, angles, parent); // Keeps the compiler quiet for now. Delete this line when you start.
    Quat::IDENTITY
}

/// Part 2 (5 points): where a bone starts and where it ends.
///
/// **In:** the `bone`; its `rotation` in the world from part 1; where its parent ends, in the world; and the bone's
/// `translation`, by which its end is moved along the world's axes (zero for nearly all bones).
///
/// **Out:** the start and the end, in the world, in the file's unit.
///
/// A bone starts where its parent ends. From there it goes `bone.length` along the bone's direction, which is written down
/// twice: `bone.local_direction` in the bone's own axes, `bone.direction` in the world's, as long as nothing has moved.
///
/// The root has no length and no direction: all of these are zero. It has no parent either: `parent_end` is where the motion
/// puts the figure, and its `translation` is zero. It needs no special case.
///
/// **Example.** The parent ends at (10, 0, 0). The bone is 2 long, points along its own X axis, and is turned a quarter
/// about Z. It starts at (10, 0, 0) and ends at (10, 2, 0).
pub fn bone_ends(bone: &Bone, rotation: Quat, parent_end: Vec3, translation: Vec3) -> (Vec3, Vec3) {
    let _ = (bone, rotation, translation); // As above.
    (parent_end, parent_end)
}

/// Part 3 (5 points): all bones, one after the other.
///
/// **In:** the `skeleton`, a `bone` of it, and a `visitor`. `visitor.visit(bone)` works out where a bone is, by parts 1 and
/// 2, and needs the bone's parent to be visited before.
///
/// **Out:** nothing. When the function is done, the bone and everything that hangs on it, however far down, has been visited
/// once, and nothing else. A parent comes before its children. In which order siblings come makes no difference.
///
/// `bone.child` is the first of the bones that hang on a bone, and `sibling` of that one is the next; both are
/// `Some(id)` or `None`, and `skeleton[id]` is the bone. The function may call itself. The program calls it with the
/// root, and with other bones too when it checks this part.
///
/// **Example.** On the root hang `lfemur` and `lowerback`, and on `lfemur` hangs `ltibia`. Called with the root, the function
/// can visit the bones in the order root, lfemur, ltibia, lowerback. Called with `lfemur`, it visits lfemur and ltibia.
pub fn visit_bones(skeleton: &Skeleton, bone: &Bone, visitor: &mut Visitor) {
    let _ = skeleton; // As above.
    visitor.visit(bone);
}
