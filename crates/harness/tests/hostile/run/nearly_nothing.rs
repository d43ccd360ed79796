//! Answers with numbers so small that they are nearly none: a direction, but no unit length.
//!
//! place: instead of local_quaternion, global_quaternion
//! expect: graded 5; part1 wrong; part2 wrong

pub fn local_quaternion(joint: &Joint, frame: &mut FrameCursor) -> Quat {
    right_local_quaternion(joint, frame) * f32::MIN_POSITIVE * 0.001
}
pub fn global_quaternion(joint: &Joint, local: Quat, pose: &Pose) -> Quat {
    right_global_quaternion(joint, local, pose) * f32::MIN_POSITIVE * 0.001
}
