//! Keyframes: from all frames of a motion to the few that matter.
//!
//! This is the only file that you edit, and the only one that you hand in. It holds three functions. Each is given what
//! the one before it computes, so that you can write and check them in any order.
//!
//! - Try it: in `cargo view --exercise keyframes` your functions choose the keyframes, and the frames between them are
//!   interpolated.
//! - Check it: `cargo test -p keyframes` shows your points and what to do next; `cargo test -p keyframes part1` checks
//!   part 1 only.
//!
//! Frames are counted from 0. At first every frame is a keyframe. A frame that is no longer one is interpolated between
//! the nearest keyframes before and after it, and is then a little off: that is its error. Keep nothing between calls.

#[allow(unused_imports)] // You may need all of them.
use skeleton::{FrameErrors, Joint, JointId, Pose, RemovalCosts, Skeleton};

/// Part 1 (5 points): how far an interpolated pose is from the original one.
///
/// **In:** the `skeleton`, and two poses of it. `pose[joint.id].position` is where a joint is.
///
/// **Out:** the sum, over all tips, of the squared distance between where the tip is in one pose and in the other.
///
/// A tip is an End Site (`joint.is_end_site`), and also a joint that no other joint hangs on: some files leave End Sites
/// out. Other joints do not count.
///
/// Square in `f32` or in `f64` as you like. The sum is an `f64`, because over a long motion many small numbers are added
/// to a large one.
///
/// **Example.** One of two tips is off by 3 along X and 4 along Y, the other is in its place: the error is 25.
pub fn pose_error(skeleton: &Skeleton, original: &Pose, interpolated: &Pose) -> f64 {
    let _ = (skeleton, original, interpolated); // Keeps the compiler quiet for now. Delete this line when you start.
    0.0
}

/// Part 2 (5 points): what it costs to remove a keyframe.
///
/// **In:** the keyframe `frame`, and the keyframes next to it: `before` < `frame` < `after`. `errors.between(start, end, i)`
/// is the error (part 1) of frame `i` when it is interpolated between the keyframes `start` and `end`.
///
/// **Out:** by how much the accumulated error, the sum over all frames, grows when `frame` is no keyframe any more.
///
/// Then not only `frame` itself is interpolated. All frames from `before` to `after` are, and those between the old
/// keyframes now in another way than up to now.
///
/// **Example.** With the keyframes 2, 3, 4, removing 3 costs `errors.between(2, 4, 3)`. With the keyframes 2, 4, 5,
/// removing 4 costs `errors.between(2, 5, 3) + errors.between(2, 5, 4) - errors.between(2, 4, 3)`.
pub fn removal_cost(before: usize, frame: usize, after: usize, errors: &FrameErrors) -> f64 {
    let _ = (before, frame, after, errors); // As above.
    0.0
}

/// Part 3 (5 points): which frames stay keyframes.
///
/// **In:** how many frames the motion has, how many keyframes are wanted, and `costs.of(before, frame, after)`: what it
/// costs to remove the keyframe `frame` while its neighbours are `before` and `after` (part 2).
///
/// **Out:** the keyframes that stay, in ascending order.
///
/// Begin with all frames. As long as there are more than `count`, remove the one that costs least, and of several that cost
/// the same the earliest. The first and the last frame always stay, even when `count` is 0 or 1. When there
/// are no more than `count` frames, all stay.
///
/// Mind that a removal changes what it would cost to remove the keyframes next to it.
///
/// **Example.** Of 5 frames 3 are to stay. At first removing 1, 2, 3 costs 4, 1, 2: frame 2 goes. The neighbours of 1 are now
/// 0 and 3, those of 3 are 1 and 4, and it costs 6 and 7: frame 1 goes. There remain 0, 3, 4.
pub fn reduce(frame_count: usize, count: usize, costs: &RemovalCosts) -> Vec<usize> {
    let _ = (count, costs); // As above.
    (0..frame_count).collect()
}
