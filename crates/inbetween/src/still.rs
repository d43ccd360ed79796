//! Where a motion stands still.

use glam::{Quat, Vec3};
use skeleton::Representation;

use crate::InbetweenClip;
use crate::turn::shorter_way;

/// Each of the angles of a joint may be off by so many degrees.
const ANGLE: f32 = 0.0002;
/// A rotation may be off by so many degrees.
const ROTATION: f32 = 0.0005;
/// A position may be off by so many times the skeleton's extent.
const POSITION: f32 = 1e-6;

/// For each frame the number of the stretch that it belongs to. All frames of a stretch are as its first one, within
/// the tolerances above.
pub(crate) fn stretches(clip: &InbetweenClip) -> Vec<usize> {
    let extent = clip.skeleton.extent();
    let tolerance = if extent.is_finite() { extent * POSITION } else { 0.0 };
    let mut first = 0;
    let mut stretch = 0;
    let stretch_of = |frame| {
        if !are_same(clip, first, frame, tolerance) {
            first = frame;
            stretch += 1;
        }
        stretch
    };
    (0..clip.frame_count).map(stretch_of).collect()
}

fn are_same(clip: &InbetweenClip, first: usize, frame: usize, tolerance: f32) -> bool {
    let of = |frame: usize, width: usize| frame * width..(frame + 1) * width;
    let joints = clip.skeleton.len();
    let positions = || clip.positions[of(first, joints)].iter().zip(&clip.positions[of(frame, joints)]);
    let rotations = || clip.rotations[of(first, joints)].iter().zip(&clip.rotations[of(frame, joints)]);
    let angles = || {
        let [first, frame] = [first, frame].map(|frame| clip.angles[of(frame, clip.turning)].as_flattened());
        first.iter().zip(frame)
    };
    positions().all(|(a, b)| is_same_position(*a, *b, tolerance))
        && match clip.representation {
            Representation::Euler => angles().all(|(a, b)| is_same_angle(*a, *b)),
            Representation::Quaternion => rotations().all(|(a, b)| is_same_rotation(*a, *b)),
        }
}

fn is_same_position(a: Vec3, b: Vec3, tolerance: f32) -> bool {
    let digits = 4.0 * f32::EPSILON * a.length();
    a.to_array().map(f32::to_bits) == b.to_array().map(f32::to_bits)
        || a.distance(b) <= tolerance.max(if digits.is_finite() { digits } else { 0.0 })
}

fn is_same_angle(a: f32, b: f32) -> bool {
    // Of the remainders, because a difference to something huge is nothing but rounding.
    a.to_bits() == b.to_bits() || shorter_way(b % 360.0 - a % 360.0).abs() <= ANGLE
}

fn is_same_rotation(a: Quat, b: Quat) -> bool {
    // Half the angle is the distance between the two as vectors, as long as it is small. `q` and `-q` are the same.
    let distance = ROTATION.to_radians() / 2.0;
    let nearest = (a - b).length_squared().min((a + b).length_squared());
    a.to_array().map(f32::to_bits) == b.to_array().map(f32::to_bits) || nearest <= distance * distance
}
