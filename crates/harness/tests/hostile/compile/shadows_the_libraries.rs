//! Defines modules that are called like the libraries.
//!
//! place: alone
//! expect: does-not-compile

mod glam {
    pub struct Quat;
    pub struct Vec3;
}
mod skeleton {
    pub struct Joint;
    pub struct FrameCursor;
    pub struct Pose;
}
pub fn local_quaternion(_: &skeleton::Joint, _: &mut skeleton::FrameCursor) -> glam::Quat {
    glam::Quat
}
pub fn global_quaternion(_: &skeleton::Joint, local: glam::Quat, _: &skeleton::Pose) -> glam::Quat {
    local
}
pub fn global_position(_: &skeleton::Joint, local: glam::Vec3, _: &skeleton::Pose) -> glam::Vec3 {
    local
}
