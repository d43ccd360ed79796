//! Never comes back from any of the three functions.
//!
//! place: instead of local_quaternion, global_quaternion, global_position
//! expect: graded 0; part1 timed-out; part2 timed-out; part3 timed-out

pub fn local_quaternion(_: &Joint, _: &mut FrameCursor) -> Quat {
    loop {}
}
pub fn global_quaternion(_: &Joint, _: Quat, _: &Pose) -> Quat {
    loop {}
}
pub fn global_position(_: &Joint, _: Vec3, _: &Pose) -> Vec3 {
    loop {}
}
