//! When two answers are the same, and how they differ when they are not.

use glam::{Quat, Vec3};

use crate::Difference;

/// Two rotations are the same when the angle between them is at most this, in degrees.
pub const ROTATION_TOLERANCE: f64 = 0.01;

/// A quaternion is a rotation when its length differs from 1 by at most this.
const LENGTH_TOLERANCE: f32 = 1e-3;

/// Two positions are the same when their distance is at most this, times the size of the skeleton.
pub const POSITION_TOLERANCE: f32 = 1e-4;

/// Whether two quaternions do the same, and if not, how they differ. q and −q are the same rotation. Where the expected
/// one is no rotation itself (a known-wrong answer), their components are compared.
pub(crate) fn between_rotations(expected: Quat, got: Quat) -> Option<Difference> {
    between_rotations_within(ROTATION_TOLERANCE, expected, got)
}

/// The same with another tolerance, in degrees.
pub(crate) fn between_rotations_within(tolerance: f64, expected: Quat, got: Quat) -> Option<Difference> {
    let between = if !got.is_finite() {
        NOT_A_NUMBER.to_owned()
    } else if (expected.length() - 1.0).abs() > LENGTH_TOLERANCE || !expected.is_finite() {
        let apart = (expected - got).length().min((expected + got).length());
        if apart <= 1e-4 * expected.length().max(1.0) {
            return None;
        }
        format!("{apart:.4} in length")
    } else if (got.length() - 1.0).abs() > LENGTH_TOLERANCE {
        format!("a rotation has the length 1, this one has {:.4}", got.length())
    } else {
        let degrees = angle_between(expected, got);
        if degrees <= tolerance {
            return None;
        }
        format!("{degrees:.2}°")
    };
    Some(Difference { got: quaternion(got), expected: quaternion(expected), between })
}

/// The angle of the rotation from `a` to `b`, in degrees, from 0 to 180. By the arc tangent in double precision: the
/// arc cosine of a dot product cannot tell small angles from zero.
pub fn angle_between(a: Quat, b: Quat) -> f64 {
    let [ax, ay, az, aw] = a.to_array().map(f64::from);
    let [bx, by, bz, bw] = b.to_array().map(f64::from);
    let w = aw * bw + ax * bx + ay * by + az * bz;
    let x = aw * bx - ax * bw - ay * bz + az * by;
    let y = aw * by - ay * bw - az * bx + ax * bz;
    let z = aw * bz - az * bw - ax * by + ay * bx;
    2.0 * (x * x + y * y + z * z).sqrt().atan2(w.abs()).to_degrees()
}

/// Whether two positions are the same in a skeleton of this size, and if not, how they differ.
pub(crate) fn between_positions(expected: Vec3, got: Vec3, size: f32) -> Option<Difference> {
    let distance = expected.distance(got);
    if distance <= POSITION_TOLERANCE * size {
        return None;
    }
    let between =
        if got.is_finite() { format!("{distance:.3} (file's unit)") } else { NOT_A_NUMBER.to_owned() };
    Some(Difference { got: vector(got), expected: vector(expected), between })
}

pub(crate) const NOT_A_NUMBER: &str = "yours is not a number (NaN) or infinite: look for a division by zero";

/// An answer to another question than the one that was asked.
pub(crate) fn not_comparable() -> Option<Difference> {
    let text = |text: &str| text.to_owned();
    Some(Difference {
        got: text("an answer to another question"),
        expected: text("an answer"),
        between: text("-"),
    })
}

/// `1 frame`, `2 frames`: `what` is the word for one of them, whose plural ends in s.
pub(crate) fn counted(count: usize, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}

/// (x, y, z, w) with four decimals.
pub(crate) fn quaternion(q: Quat) -> String {
    format!("({:.4}, {:.4}, {:.4}, {:.4})", q.x, q.y, q.z, q.w)
}

/// (x, y, z) with three decimals.
pub(crate) fn vector(v: Vec3) -> String {
    format!("({:.3}, {:.3}, {:.3})", v.x, v.y, v.z)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A turn by so many degrees, in f32 as students have it.
    fn turn(degrees: f32) -> Quat {
        Quat::from_axis_angle(Vec3::new(2.0, -1.0, 3.0).normalize(), degrees.to_radians())
    }

    #[test]
    fn a_quaternion_and_its_negative_are_the_same_rotation() {
        for degrees in [0.0, 1.0, 90.0, 179.0, 180.0, 270.0] {
            assert_eq!(between_rotations(turn(degrees), -turn(degrees)), None, "{degrees}");
        }
    }

    #[test]
    fn rotations_differ_from_a_hundredth_of_a_degree_on() {
        for degrees in [0.0, 30.0, 120.0] {
            assert_eq!(between_rotations(turn(degrees), turn(degrees + 0.009)), None, "{degrees}");
            assert!(between_rotations(turn(degrees), turn(degrees + 0.011)).is_some(), "{degrees}");
        }
    }

    #[test]
    fn the_angle_between_is_right_from_small_to_large() {
        for degrees in [0.001_f32, 0.1, 10.0, 90.0, 179.0] {
            let measured = angle_between(turn(20.0), turn(20.0 + degrees));
            assert!((measured - f64::from(degrees)).abs() < 2e-5, "{degrees}: {measured}");
        }
    }

    #[test]
    fn a_rotation_has_the_length_1() {
        assert_eq!(between_rotations(turn(50.0), turn(50.0) * 1.0005), None);
        let difference = between_rotations(turn(50.0), turn(50.0) * 1.002).unwrap();
        assert_eq!(difference.between, "a rotation has the length 1, this one has 1.0020");
        assert!(between_rotations(Quat::IDENTITY, Quat::from_xyzw(0.0, 0.0, 0.0, 0.0)).is_some());
    }

    #[test]
    fn what_is_not_a_number_is_never_right() {
        let nan = Quat::from_xyzw(f32::NAN, 0.0, 0.0, 1.0);
        assert_eq!(between_rotations(turn(1.0), nan).unwrap().between, NOT_A_NUMBER);
        let difference = between_positions(Vec3::ZERO, Vec3::new(0.0, f32::INFINITY, 0.0), 1.0);
        assert_eq!(difference.unwrap().between, NOT_A_NUMBER);
        assert!(between_positions(Vec3::ZERO, Vec3::NAN, f32::MAX).is_some());
    }

    #[test]
    fn positions_differ_from_a_ten_thousandth_of_the_size_on() {
        for size in [0.01, 1.0, 170.0] {
            let off = |parts: f32| Vec3::new(0.0, parts * size, 0.0);
            assert_eq!(between_positions(Vec3::ZERO, off(0.9e-4), size), None, "{size}");
            assert!(between_positions(Vec3::ZERO, off(1.1e-4), size).is_some(), "{size}");
        }
    }
}
