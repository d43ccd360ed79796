//! Answers with infinities.
//!
//! place: instead of local_quaternion, global_quaternion, global_position
//! expect: graded 0; part1 wrong; part2 wrong; part3 wrong

pub fn local_quaternion(joint: &Joint, frame: &mut FrameCursor) -> Quat {
    right_local_quaternion(joint, frame) * f32::INFINITY
}
pub fn global_quaternion(joint: &Joint, local: Quat, pose: &Pose) -> Quat {
    right_global_quaternion(joint, local, pose) * f32::INFINITY
}
pub fn global_position(_: &Joint, _: Vec3, _: &Pose) -> Vec3 {
    Vec3::new(f32::INFINITY, f32::NEG_INFINITY, f32::MAX)
}
