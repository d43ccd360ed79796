//! Answers with what is no number.
//!
//! place: instead of local_quaternion, global_quaternion, global_position
//! expect: graded 0; part1 wrong; part2 wrong; part3 wrong
//! quick: yes

pub fn local_quaternion(joint: &Joint, frame: &mut FrameCursor) -> Quat {
    right_local_quaternion(joint, frame) * f32::NAN
}
pub fn global_quaternion(joint: &Joint, local: Quat, pose: &Pose) -> Quat {
    right_global_quaternion(joint, local, pose) * f32::NAN
}
pub fn global_position(joint: &Joint, local_position: Vec3, pose: &Pose) -> Vec3 {
    right_global_position(joint, local_position, pose) * f32::NAN
}
