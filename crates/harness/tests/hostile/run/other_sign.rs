//! Answers with the negative quaternion, which is the same rotation. That is right.
//!
//! place: instead of local_quaternion, global_quaternion
//! expect: graded 15

pub fn local_quaternion(joint: &Joint, frame: &mut FrameCursor) -> Quat {
    -right_local_quaternion(joint, frame)
}
pub fn global_quaternion(joint: &Joint, local: Quat, pose: &Pose) -> Quat {
    -right_global_quaternion(joint, local, pose)
}
