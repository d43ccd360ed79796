//! Takes a million angles for each joint.
//!
//! place: instead of local_quaternion
//! expect: graded

pub fn local_quaternion(joint: &Joint, frame: &mut FrameCursor) -> Quat {
    let turn = right_local_quaternion(joint, frame);
    for _ in 0..100_000 {
        frame.take3();
    }
    turn
}
