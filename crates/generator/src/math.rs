//! Rotations, curves and small helpers in double precision, the same on every system.
//!
//! The sine of the standard library may differ in its last bit from one system to the next, so all functions that are
//! not exactly defined come from the crate `libm`. Right-handed axes, column vectors, angles in degrees.

use glam::{DMat3, DVec3};
use skeleton::Axis;

/// The sine of an angle in degrees.
pub fn sin(degrees: f64) -> f64 {
    libm::sin(degrees.to_radians())
}

/// The cosine of an angle in degrees.
pub fn cos(degrees: f64) -> f64 {
    libm::cos(degrees.to_radians())
}

/// The angle in degrees whose cosine is `value`; values outside −1 to 1 count as −1 or 1.
pub fn acos(value: f64) -> f64 {
    libm::acos(value.clamp(-1.0, 1.0)).to_degrees()
}

/// The angle in degrees, −180 to 180, at which the point (x, y) stands.
pub fn atan2(y: f64, x: f64) -> f64 {
    libm::atan2(y, x).to_degrees()
}

/// The rotation by `degrees` about one axis.
pub fn turn(axis: Axis, degrees: f64) -> DMat3 {
    let (s, c) = (sin(degrees), cos(degrees));
    match axis {
        Axis::X => DMat3::from_cols(DVec3::X, DVec3::new(0.0, c, s), DVec3::new(0.0, -s, c)),
        Axis::Y => DMat3::from_cols(DVec3::new(c, 0.0, -s), DVec3::Y, DVec3::new(s, 0.0, c)),
        Axis::Z => DMat3::from_cols(DVec3::new(c, s, 0.0), DVec3::new(-s, c, 0.0), DVec3::Z),
    }
}

/// The product of three turns, the first leftmost: intrinsic Euler angles in degrees.
pub fn from_euler(axes: [Axis; 3], angles: [f64; 3]) -> DMat3 {
    turn(axes[0], angles[0]) * turn(axes[1], angles[1]) * turn(axes[2], angles[2])
}

/// The Euler angles in degrees of a rotation, about three different axes, first leftmost.
///
/// Of all triples that mean this rotation it takes the one nearest to `near`, so that a movement gives continuous
/// angles, beyond ±180° too.
///
/// With the axes i, j, k in cyclic order the product has sin b at (i, k), −sin a cos b at (j, k), cos a cos b at
/// (k, k), −cos b sin c at (i, j) and cos b cos c at (i, i); in the other order the sines change sign (Diebel 2006,
/// "Representing attitude: Euler angles, unit quaternions, and rotation vectors"). A second triple is a + 180°,
/// 180° − b, c + 180°.
pub fn to_euler(rotation: DMat3, axes: [Axis; 3], near: [f64; 3]) -> [f64; 3] {
    let [i, j, k] = axes.map(Axis::index);
    let sign = if (i + 1) % 3 == j { 1.0 } else { -1.0 };
    let at = |row: usize, column: usize| rotation.col(column)[row];
    let sine = sign * at(i, k);
    let cosine = libm::sqrt(at(i, i) * at(i, i) + at(i, j) * at(i, j));
    let first = [atan2(-sign * at(j, k), at(k, k)), atan2(sine, cosine), atan2(-sign * at(i, j), at(i, i))];
    let second = [first[0] + 180.0, 180.0 - first[1], first[2] + 180.0];
    let [first, second] = [first, second].map(|angles| {
        let mut angles = angles;
        for (angle, near) in angles.iter_mut().zip(near) {
            *angle = nearest_turn(*angle, near);
        }
        angles
    });
    let distance = |angles: [f64; 3]| -> f64 { (0..3).map(|n| (angles[n] - near[n]).abs()).sum() };
    if distance(first) <= distance(second) { first } else { second }
}

/// `angle` plus so many full turns that it comes nearest to `near`.
pub fn nearest_turn(angle: f64, near: f64) -> f64 {
    angle - 360.0 * libm::round((angle - near) / 360.0)
}

/// `angle` brought into −180° to 180°, as recorded motions often store it.
pub fn wrap(angle: f64) -> f64 {
    nearest_turn(angle, 0.0)
}

/// From `a` at `t` = 0 to `b` at `t` = 1, in a straight line.
pub fn lerp(a: f64, b: f64, t: f64) -> f64 {
    a + (b - a) * t
}

/// From 0 at `t` ≤ 0 to 1 at `t` ≥ 1, with no speed and no acceleration at both ends.
pub fn smooth(t: f64) -> f64 {
    let t = t.clamp(0.0, 1.0);
    t * t * t * (t * (6.0 * t - 15.0) + 10.0)
}

/// A slow, smooth, repeatable wobble about zero, mostly between −1 and 1; `time` in seconds.
///
/// It stands for the small differences between one stride and the next. Every `which` is a wobble of its own: four
/// waves whose frequencies have no common period, with starting points from multiples of the golden ratio.
pub fn wobble(which: u32, time: f64) -> f64 {
    const FREQUENCIES: [f64; 4] = [0.13, 0.29, 0.47, 0.71];
    const GOLDEN: f64 = 0.618_033_988_749_895;
    let waves = FREQUENCIES.iter().enumerate().map(|(n, frequency)| {
        let start = (f64::from(which) * 4.0 + n as f64) * GOLDEN;
        sin(360.0 * (frequency * time + start))
    });
    waves.sum::<f64>() / 2.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use skeleton::RotationOrder;

    proptest! {
        #[test]
        fn angles_survive_the_way_through_a_rotation(
            order in 0..6_usize, a in -400.0..400.0, b in -400.0..400.0, c in -400.0..400.0,
        ) {
            let axes = RotationOrder::ROTATING[order].axes().expect("three axes");
            let rotation = from_euler(axes, [a, b, c]);
            // Near themselves the angles come back as they were, but where two axes fall together.
            let found = to_euler(rotation, axes, [a, b, c]);
            prop_assert!(from_euler(axes, found).abs_diff_eq(rotation, 1e-9));
            if cos(b).abs() > 1e-3 {
                for (found, angle) in found.into_iter().zip([a, b, c]) {
                    prop_assert!((found - angle).abs() < 1e-6, "{found} for {angle}");
                }
            }
        }

        #[test]
        fn a_wrapped_angle_is_the_same_direction_within_half_a_turn(angle in -2000.0..2000.0) {
            let wrapped = wrap(angle);
            prop_assert!(wrapped.abs() <= 180.0);
            prop_assert!((sin(wrapped) - sin(angle)).abs() < 1e-9 && (cos(wrapped) - cos(angle)).abs() < 1e-9);
        }
    }

    #[test]
    fn turns_are_counter_clockwise() {
        assert!((turn(Axis::X, 90.0) * DVec3::Y).abs_diff_eq(DVec3::Z, 1e-12));
        assert!((turn(Axis::Y, 90.0) * DVec3::Z).abs_diff_eq(DVec3::X, 1e-12));
        assert!((turn(Axis::Z, 90.0) * DVec3::X).abs_diff_eq(DVec3::Y, 1e-12));
    }
}
