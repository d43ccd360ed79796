//! The three functions are there, but nobody else may call them.
//!
//! place: alone
//! expect: does-not-compile "private"

mod hidden {
    use glam::{Quat, Vec3};
    use skeleton::{FrameCursor, Joint, Pose};
    pub(super) fn local_quaternion(_: &Joint, _: &mut FrameCursor) -> Quat {
        Quat::IDENTITY
    }
    pub(super) fn global_quaternion(_: &Joint, local: Quat, _: &Pose) -> Quat {
        local
    }
    pub(super) fn global_position(_: &Joint, local_position: Vec3, _: &Pose) -> Vec3 {
        local_position
    }
}
use hidden::{global_position, global_quaternion, local_quaternion};
