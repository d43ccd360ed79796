//! Interpolation: from two frames to all the frames between them.
//!
//! This is the only file that you edit, and the only one that you hand in. It holds three functions. The program
//! calls the third for every frame between two keyframes; the first two are yours to call there.
//!
//! - Try it: `cargo view --exercise interpolation` shows the frames that your functions make beside the original ones.
//! - Check it: `cargo test -p interpolation` shows your points and what to do next;
//!   `cargo test -p interpolation part1` checks part 1 only.
//!
//! `t` says how far it is from the first to the second: 0 is the first, 1 is the second, 0.5 is half-way. A `t` below 0
//! counts as 0, and one above 1 as 1.
//!
//! Angles are in degrees. A quaternion is written (x, y, z, w), and `a * b` is the rotation that does `b` first and
//! `a` after it. `q` and `-q` are the same rotation.

use glam::Quat;
#[allow(unused_imports)] // You may need all of them.
use glam::Vec3;
#[allow(unused_imports)]
use skeleton::{Axis, Frame, FrameCursor, Joint, LocalPose, Representation, RotationOrder, Skeleton};

/// Part 1 (5 points): between two sets of Euler angles.
///
/// **In:** the three angles of a joint in one frame and in another one, in degrees, in the same order; and `t`.
///
/// **Out:** the three angles at `t`, in degrees. Each angle goes by itself, evenly, and the shorter way round: from 170 to
/// −170 there are 20 degrees to go and not 340. Angles of a motion can be larger than 360; 10 and 730 are the same
/// direction. Which full turn your result is in does not matter: 180 is as good as −180.
///
/// **Example.** From (170, 0, 30) to (−170, 10, 30), half-way: (180, 5, 30).
pub fn interpolate_angles(from: [f32; 3], to: [f32; 3], t: f32) -> [f32; 3] {
    // solution-begin
    let t = t.clamp(0.0, 1.0);
    std::array::from_fn(|axis| from[axis] + t * shorter_way(to[axis] - from[axis]))
    // solution-else
    // let _ = (to, t); // Keeps the compiler quiet for now. Delete this line when you start.
    // from
    // solution-end
}

// solution-begin
/// The same difference of two angles in degrees, from −180 to 180.
fn shorter_way(degrees: f32) -> f32 {
    // All angles that an `f32` can hold leave a remainder; taking off 360 again and again would not end.
    let degrees = degrees % 360.0;
    if degrees > 180.0 {
        degrees - 360.0
    } else if degrees < -180.0 {
        degrees + 360.0
    } else {
        degrees
    }
}

// solution-end
/// Part 2 (5 points): between two rotations.
///
/// **In:** two unit quaternions and `t`.
///
/// **Out:** the rotation at `t` as a unit quaternion: about one axis, at an even speed, the shorter way round.
///
/// Write it yourself, without the `slerp` of glam. With θ the angle between the two as vectors of four numbers
/// (cos θ is their dot product), it is
///
/// (sin((1 − t) θ) · from + sin(t θ) · to) / sin θ.
///
/// Two things need care. Of the two ways round, the shorter one is that between quaternions whose dot product is not
/// negative. And two quaternions that are nearly the same have a sin θ of nearly 0: divide by something else.
///
/// **Example.** From no rotation to a quarter turn about Z, a third of the way: 30 degrees about Z,
/// (0, 0, 0.2588, 0.9659).
pub fn slerp(from: Quat, to: Quat, t: f32) -> Quat {
    // solution-begin
    let t = t.clamp(0.0, 1.0);
    let dot = from.dot(to);
    let (to, cosine) = if dot < 0.0 { (-to, -dot) } else { (to, dot) };
    if cosine > 0.9995 {
        // So close together a straight line is as even as the formula: it is off by less than a millionth.
        return (from * (1.0 - t) + to * t).normalize();
    }
    let angle = cosine.acos();
    ((from * ((1.0 - t) * angle).sin() + to * (t * angle).sin()) / angle.sin()).normalize()
    // solution-else
    // let _ = (to, t); // As above.
    // from
    // solution-end
}

/// Part 3 (5 points): between two frames, all joints.
///
/// **In:** the skeleton; two frames of its motion; `t`; and the `representation`, which says what of each rotation is
/// interpolated. In a [`Frame`], `local_positions` holds a position for every joint, and `angles` three angles for every
/// joint that has any: `FrameCursor::new(&frame.angles)` hands them out, as in forward kinematics.
///
/// **Out:** for every joint and End Site, in the order of `skeleton.joints()`,
/// - its local rotation. With `Representation::Euler` interpolate the three angles (part 1) and make a quaternion of the
///   result; with `Representation::Quaternion` make a quaternion of the angles of each frame and interpolate these
///   (part 2). A joint whose rotation order is `None` has no angles and is not turned;
/// - its local position, on the straight line between those of the two frames, in both representations. This is what
///   moves the root.
///
/// The quaternion of three angles is part 1 of forward kinematics: take yours, or glam's `Quat::from_euler`.
///
/// **Example.** With the angles (0, 0, 0) and (90, 0, 0) in the order `Zyx`, half-way, both representations turn by 45
/// degrees about Z. With all three angles different they do not agree.
pub fn interpolate_frame(
    skeleton: &Skeleton,
    from: &Frame,
    to: &Frame,
    t: f32,
    representation: Representation,
) -> LocalPose {
    // solution-begin
    let (mut angles_from, mut angles_to) = (FrameCursor::new(&from.angles), FrameCursor::new(&to.angles));
    let rotation = |joint: &Joint| {
        if joint.rotation_order == RotationOrder::None {
            return Quat::IDENTITY;
        }
        let (from, to) = (angles_from.take3(), angles_to.take3());
        match representation {
            Representation::Euler => quaternion(joint, interpolate_angles(from, to, t)),
            Representation::Quaternion => slerp(quaternion(joint, from), quaternion(joint, to), t),
        }
    };
    let rotations = skeleton.joints().iter().map(rotation).collect();
    let pairs = from.local_positions.iter().zip(&to.local_positions);
    let positions = pairs.map(|(from, to)| from.lerp(*to, t.clamp(0.0, 1.0))).collect();
    LocalPose { rotations, positions }
    // solution-else
    // let _ = (to, t, representation); // As above.
    // let rotations = vec![Quat::IDENTITY; skeleton.len()];
    // LocalPose { rotations, positions: from.local_positions.clone() }
    // solution-end
}
// solution-begin

/// The rotation that a joint's angles (degrees) make.
fn quaternion(joint: &Joint, angles: [f32; 3]) -> Quat {
    let Some(axes) = joint.rotation_order.axes() else { return Quat::IDENTITY };
    let turn = |axis: Axis, degrees: f32| Quat::from_axis_angle(axis.unit(), degrees.to_radians());
    let [first, second, third] = axes;
    turn(first, angles[0]) * turn(second, angles[1]) * turn(third, angles[2])
}
// solution-end
