//! Gives the first answer again and again.
//!
//! place: instead of local_quaternion
//! expect: graded 10; part1 wrong

static FIRST: std::sync::OnceLock<Quat> = std::sync::OnceLock::new();

pub fn local_quaternion(joint: &Joint, frame: &mut FrameCursor) -> Quat {
    let turn = right_local_quaternion(joint, frame);
    *FIRST.get_or_init(|| turn)
}
