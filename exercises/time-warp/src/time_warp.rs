//! Time warping: the same motion, slower or faster.
//!
//! This is the only file that you edit, and the only one that you hand in. It holds three functions. The third makes a
//! motion with another number of frames; the first two are yours to call there.
//!
//! - Try it: `cargo view --exercise time-warp` opens a window in which a walk stands beside what your functions make of it.
//! - Check it: `cargo test -p time-warp` shows your points and what to do next; `cargo test -p time-warp part1` checks part 1
//!   only.
//!
//! A posture holds, for every bone, three angles about its own X, Y and Z axis in degrees, and a translation. The
//! rotation that the angles stand for is Rz Ry Rx. A quaternion is written (x, y, z, w).

#[allow(unused_imports)] // You may need all of them.
use glam::{EulerRot, Quat, Vec3};
use skeleton::acclaim::{Between, Posture};

/// Part 1 (5 points): where a frame of the new motion is in the old one.
///
/// **In:** the `new_frame`, counted from 0; how many frames the old motion has (at least one), and how many the new one
/// is to have.
///
/// **Out:** the old frames before and after that place, and `t`: how far it is from the one to the other, 0 at the frame
/// before and 1 at the frame after.
///
/// The place is `new_frame` × old count / new count, mostly not a whole number. Where it is one, that frame is both, and `t`
/// is 0. There is no frame after the last one: where the frame after would be that, it is the last one, too. Frames
/// that are there and a `t` that name the same place in another way are just as right.
///
/// A count of several million must not make the place inexact.
///
/// **Example.** From 4 frames to 8: the new frame 3 is at 1.5, between the old frames 1 and 2, with `t` = 0.5. The new frame
/// 7 is at 3.5; the last old frame is 3, so it is the frame before and the frame after.
pub fn old_position(new_frame: usize, old_count: usize, new_count: usize) -> Between {
    let _ = (old_count, new_count); // Keeps the compiler quiet for now. Delete this line when you start.
    Between { before: new_frame, after: new_frame, t: 0.0 }
}

/// Part 2 (5 points): between two postures.
///
/// **In:** two postures of the same bones, and `t`: 0 is the first, 1 is the second.
///
/// **Out:** the posture at `t`. Translations go straight from the one to the other. Rotations go the shorter way round, about
/// one axis, at an even speed.
///
/// Euler angles cannot be interpolated like that: make a quaternion of the angles, interpolate (`a.slerp(b, t)`), and
/// make angles of the result again. A quaternion's x, y and z are no angles. `Quat::from_euler` and `to_euler` with
/// `EulerRot::ZYX` take and give the angles about Z, Y and X, in this order, in radians. Different angles can stand for the same
/// rotation: which of them you return does not matter.
///
/// **Example.** Between the angles (0, 0, 0) and (0, 0, 90), half-way: (0, 0, 45).
pub fn blend(from: &Posture, to: &Posture, t: f32) -> Posture {
    let _ = (to, t); // As above.
    from.clone()
}

/// Part 3 (5 points): the whole motion with another number of frames.
///
/// **In:** the postures of the old motion, frame after frame, and how many frames the new one is to have.
///
/// **Out:** the postures of the new motion, as many as that. A motion without any frame cannot be warped: it stays without.
///
/// **Example.** From 3 frames to 6: the new frames 0, 2 and 4 are the old frames 0, 1 and 2; those between are blended, and
/// frame 5 is the last old frame once more.
pub fn warp(postures: &[Posture], new_count: usize) -> Vec<Posture> {
    let _ = new_count; // As above.
    postures.to_vec()
}
