//! From the angles that a file's channels hold to a rotation, and back.
//!
//! Many sets of angles make the same rotation: every angle can have whole turns more or less, three angles have a second
//! way to the same end, and in a gimbal lock, with the first and the third axis in one line, only the sum or the
//! difference of two angles matters. Of all these sets the one is taken that is nearest to the angles of the frame before,
//! so that curves of angles go on without a jump.

use std::f64::consts::{PI, TAU};

use glam::Quat;
use skeleton::Axis;

/// Beside larger angles than this, in degrees, an `f32` does not hold hundredths of a degree: whole turns are taken off.
const LARGEST: f64 = 1e5;

/// The share of a unit quaternion below which it says nothing: the rounding errors of an `f32`, and a little more.
const NOISE: f64 = 1e-6;

/// The rotation that `angles` (in degrees) about `axes` make: one turn after the other, each about axes that the turns before
/// it have moved.
pub fn rotation_of(axes: &[Axis], angles: impl IntoIterator<Item = f32>) -> Quat {
    let turn = |(axis, angle): (&Axis, f32)| Quat::from_axis_angle(axis.unit(), angle.to_radians());
    axes.iter().zip(angles).map(turn).product()
}

/// The angles in degrees, one for each of the rotation channels `axes` (at most three, each axis once), that make
/// `rotation`, as [`rotation_of`] does.
///
/// With three channels there are always such angles. With fewer there may be none: then those that come closest.
/// `near` are the angles to stay close to, in degrees; those of more than 100 000° lose whole turns. What has no channel is 0.
pub fn angles_of(rotation: Quat, axes: &[Axis], near: [f64; 3]) -> [f64; 3] {
    let q = Parts::of(rotation);
    let near = near.map(f64::to_radians);
    let angles = match *axes {
        [] => [0.0; 3],
        [i] => [q.one_angle(i, near), 0.0, 0.0],
        [i, j] => q.two_angles([i, j], near),
        [i, j, k, ..] => q.three_angles([i, j, k], near),
    };
    angles.map(f64::to_degrees)
}

/// How far `angles` about `axes`, as [`angles_of`] gives them, are from making `rotation`: an angle in degrees, from 0 to 180.
pub fn distance(rotation: Quat, axes: &[Axis], angles: [f64; 3]) -> f64 {
    let mut rest = Parts::of(rotation);
    // Turned back, the last turn first, nothing should be left.
    for (axis, angle) in axes.iter().zip(angles).rev() {
        rest = rest.times_turn(*axis, -angle.to_radians());
    }
    let [x, y, z] = rest.xyz;
    (2.0 * f64::hypot(f64::hypot(x, y), z).atan2(rest.w.abs())).to_degrees()
}

/// The four numbers of a unit quaternion.
#[derive(Clone, Copy, Debug)]
struct Parts {
    w: f64,
    xyz: [f64; 3],
}

impl Parts {
    fn of(rotation: Quat) -> Parts {
        let [x, y, z, w] = rotation.to_array().map(f64::from);
        let length = (x * x + y * y + z * z + w * w).sqrt();
        Parts { w: w / length, xyz: [x, y, z].map(|part| part / length) }
    }

    fn times_turn(self, axis: Axis, angle: f64) -> Parts {
        let (sine, cosine) = (angle / 2.0).sin_cos();
        let (i, j, k) = (axis.index(), (axis.index() + 1) % 3, (axis.index() + 2) % 3);
        let mut xyz = [0.0; 3];
        xyz[i] = self.xyz[i] * cosine + self.w * sine;
        xyz[j] = self.xyz[j] * cosine + self.xyz[k] * sine;
        xyz[k] = self.xyz[k] * cosine - self.xyz[j] * sine;
        Parts { w: self.w * cosine - self.xyz[i] * sine, xyz }
    }

    /// The turn about one axis that comes closest.
    fn one_angle(self, axis: Axis, near: [f64; 3]) -> f64 {
        let (half, length) = direction(self.xyz[axis.index()], self.w);
        if length < NOISE { near[0] } else { unwound(2.0 * half, near[0]) }
    }

    /// The turns about two axes, one after the other, that come closest.
    ///
    /// With a and b the halves of the two angles, the quaternion of both turns has the parts cos a cos b, sin a cos b, cos a
    /// sin b and ± sin a sin b. Its dot product with this one is the larger the closer the two are; as a sum of cosines of
    /// a + b and a − b it is largest where each of these is largest by itself.
    fn two_angles(self, [first, second]: [Axis; 2], near: [f64; 3]) -> [f64; 3] {
        let third = 3 - first.index() - second.index();
        let (x, y) = (self.xyz[first.index()], self.xyz[second.index()]);
        let z = sign(first, second) * self.xyz[third];
        let (sum, sum_length) = direction(x + y, self.w - z);
        let (difference, difference_length) = direction(x - y, self.w + z);
        let halves = Halves { sum, sum_length, difference, difference_length };
        let [a, b] = halves.near([near[0], near[1]]);
        [unwound(a, near[0]), unwound(b, near[1]), 0.0]
    }

    /// The turns about three axes, one after the other. `second` first tells how far the first and the third axis are from
    /// being in one line; what is left of the quaternion then holds half the sum and half the difference of the other two.
    fn three_angles(self, [first, second, third]: [Axis; 3], near: [f64; 3]) -> [f64; 3] {
        let sign = sign(first, second);
        let (x, y, z) = (self.xyz[first.index()], self.xyz[second.index()], sign * self.xyz[third.index()]);
        let (sum, sum_length) = direction(x + z, self.w + y);
        let (difference, difference_length) = direction(x - z, self.w - y);
        let halves = Halves { sum, sum_length, difference, difference_length };
        let middle = 2.0 * sum_length.atan2(difference_length) - PI / 2.0;

        let [a, c] = halves.near([near[0], sign * near[2]]);
        let one_way = [a, middle, sign * c];
        let other_way = [a + PI, PI - middle, sign * (c + PI)];
        let [one_way, other_way] =
            [one_way, other_way].map(|angles| std::array::from_fn(|at| unwound(angles[at], near[at])));
        if way(one_way, near) <= way(other_way, near) { one_way } else { other_way }
    }
}

/// Half the sum and half the difference of two angles, and how much the quaternion says of each.
#[derive(Clone, Copy, Debug)]
struct Halves {
    sum: f64,
    sum_length: f64,
    difference: f64,
    difference_length: f64,
}

impl Halves {
    /// The two angles. Of what the quaternion does not say, what comes closest to `near`.
    fn near(self, near: [f64; 2]) -> [f64; 2] {
        let (near_sum, near_difference) = ((near[0] + near[1]) / 2.0, (near[0] - near[1]) / 2.0);
        let half_turns = |angle: f64, near: f64| angle + PI * ((near - angle) / PI).round();
        let (sum, difference) = match (self.sum_length < NOISE, self.difference_length < NOISE) {
            (false, false) => (self.sum, self.difference),
            // When one of the two is free, both signs of the other's part of the quaternion are the same rotation.
            (true, _) => (near_sum, half_turns(self.difference, near_difference)),
            (_, true) => (half_turns(self.sum, near_sum), near_difference),
        };
        [sum + difference, sum - difference]
    }
}

/// 1 when the third axis is the cross product of the first and the second, −1 when it is the opposite.
fn sign(first: Axis, second: Axis) -> f64 {
    if (first.index() + 1) % 3 == second.index() { 1.0 } else { -1.0 }
}

/// The angle of the direction with this sine and cosine, of any length, and its length.
fn direction(sine: f64, cosine: f64) -> (f64, f64) {
    (sine.atan2(cosine), (sine * sine + cosine * cosine).sqrt())
}

/// The same angle with as many whole turns as bring it closest to `near`. Both in radians.
fn unwound(angle: f64, near: f64) -> f64 {
    let closest = |near: f64| angle + TAU * ((near - angle) / TAU).round();
    let unwound = closest(near);
    if unwound.abs() <= LARGEST.to_radians() { unwound } else { closest(0.0) }
}

/// How far it is from one set of angles to another.
fn way(from: [f64; 3], to: [f64; 3]) -> f64 {
    from.iter().zip(to).map(|(from, to)| (from - to).powi(2)).sum()
}

#[cfg(test)]
mod tests;
