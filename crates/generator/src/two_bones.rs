//! Inverse kinematics of two bones: how a limb bends so that its far end is where it should be.

use glam::{DMat3, DVec3};

use crate::math::{acos, cos, sin};

/// A bent limb of two bones.
#[derive(Clone, Copy, Debug)]
pub struct Bend {
    /// The axis of the joint between the bones: a unit vector.
    pub axis: DVec3,
    /// The direction of the upper bone: a unit vector.
    pub upper: DVec3,
    /// The angle in degrees by which the lower bone is turned against the upper one, about `axis`; 0 is straight.
    pub degrees: f64,
}

impl Bend {
    /// The limb from `start` to `end` with bones of the given lengths. Its joint bends about an axis as near as
    /// possible to `wanted_axis`, which must not point along the limb.
    ///
    /// Three sides give a triangle, and the law of cosines its angles. An end out of reach is reached for with a
    /// limb that is not quite straight.
    pub fn reaching(start: DVec3, end: DVec3, [upper, lower]: [f64; 2], wanted_axis: DVec3) -> Bend {
        let line = (end - start).normalize();
        let distance = (end - start).length().min(0.9995 * (upper + lower));
        let axis = (wanted_axis - wanted_axis.dot(line) * line).normalize();
        let corner =
            |a: f64, b: f64, opposite: f64| acos((a * a + b * b - opposite * opposite) / (2.0 * a * b));
        let at_start = corner(upper, distance, lower);
        let direction = cos(at_start) * line + sin(at_start) * line.cross(axis);
        Bend { axis, upper: direction, degrees: 180.0 - corner(upper, lower, distance) }
    }

    /// The global rotation of an upper bone that rests along `along` (+1 for +Y, −1 for −Y) and bends about its X
    /// axis.
    pub fn upper_rotation(&self, along: f64) -> DMat3 {
        let y = along * self.upper;
        DMat3::from_cols(self.axis, y, self.axis.cross(y))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::turn;
    use proptest::prelude::*;
    use skeleton::Axis;

    proptest! {
        #[test]
        fn the_limb_ends_where_it_should(
            distance in 10.0..69.0, heading in 0.0..360.0, height in -80.0..80.0,
            upper in 35.0..40.0, lower in 35.0..40.0,
        ) {
            let line = turn(Axis::Y, heading) * turn(Axis::X, height) * DVec3::Z;
            let wanted_axis = turn(Axis::Y, heading + 20.0) * DVec3::X;
            let (start, end) = (DVec3::new(1.0, 2.0, 3.0), DVec3::new(1.0, 2.0, 3.0) + line * distance);
            let bend = Bend::reaching(start, end, [upper, lower], wanted_axis);
            for along in [1.0, -1.0] {
                let first = bend.upper_rotation(along);
                let second = first * turn(Axis::X, bend.degrees);
                let reached = start + first * DVec3::Y * (along * upper) + second * DVec3::Y * (along * lower);
                prop_assert!(reached.abs_diff_eq(end, 1e-6), "{reached} for {end}");
                prop_assert!((first.determinant() - 1.0).abs() < 1e-9);
            }
            prop_assert!(bend.degrees >= 0.0 && bend.axis.dot(wanted_axis) > 0.0);
        }
    }

    #[test]
    fn an_end_out_of_reach_is_reached_for() {
        let bend = Bend::reaching(DVec3::ZERO, DVec3::new(0.0, -500.0, 0.0), [40.0, 40.0], DVec3::X);
        assert!(bend.degrees > 0.0 && bend.degrees < 5.0);
        assert!(bend.upper.dot(DVec3::NEG_Y) > 0.999);
    }
}
