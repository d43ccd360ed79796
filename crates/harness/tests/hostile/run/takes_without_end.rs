//! Takes angles as long as it gets any, and it always gets some.
//!
//! place: instead of local_quaternion
//! expect: graded 10; part1 timed-out

pub fn local_quaternion(_: &Joint, frame: &mut FrameCursor) -> Quat {
    loop {
        frame.take3();
    }
}
