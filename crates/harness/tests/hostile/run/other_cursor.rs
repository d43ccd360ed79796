//! Puts a cursor of its own in the place of the one that it is given.
//!
//! place: instead of local_quaternion
//! expect: graded 14; part1 partly-right

pub fn local_quaternion(joint: &Joint, frame: &mut FrameCursor) -> Quat {
    let turn = right_local_quaternion(joint, frame);
    *frame = FrameCursor::new(&[1.0, 2.0, 3.0]);
    turn
}
