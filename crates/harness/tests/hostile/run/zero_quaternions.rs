//! Answers with quaternions that are no rotation, and near which everything might seem to be.
//!
//! place: instead of local_quaternion, global_quaternion
//! expect: graded 5; part1 wrong; part2 wrong

pub fn local_quaternion(joint: &Joint, frame: &mut FrameCursor) -> Quat {
    right_local_quaternion(joint, frame) * 0.0
}
pub fn global_quaternion(joint: &Joint, local: Quat, pose: &Pose) -> Quat {
    right_global_quaternion(joint, local, pose) * 0.0
}
