//! One of the three functions gives back something else.
//!
//! place: alone
//! expect: does-not-compile "mismatched types"

use glam::{Quat, Vec3};
use skeleton::{FrameCursor, Joint, Pose};
pub fn local_quaternion(_: &Joint, _: &mut FrameCursor) -> Vec3 {
    Vec3::ZERO
}
pub fn global_quaternion(_: &Joint, local: Quat, _: &Pose) -> Quat {
    local
}
pub fn global_position(_: &Joint, local_position: Vec3, _: &Pose) -> Vec3 {
    local_position
}
