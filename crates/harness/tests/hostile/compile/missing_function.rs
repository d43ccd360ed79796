//! One of the three functions is gone.
//!
//! place: alone
//! expect: does-not-compile "global_position"
//! quick: yes

use glam::Quat;
use skeleton::{FrameCursor, Joint, Pose};
pub fn local_quaternion(_: &Joint, _: &mut FrameCursor) -> Quat {
    Quat::IDENTITY
}
pub fn global_quaternion(_: &Joint, local: Quat, _: &Pose) -> Quat {
    local
}
