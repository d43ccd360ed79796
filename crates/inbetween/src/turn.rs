//! How one joint turns from one keyframe to the next.

use glam::{Quat, Vec4};
use skeleton::{Axis, RotationOrder};

use crate::lanes::{Positions, Rotations, cosine, sine_ratio};

/// The rotation that three angles in degrees make.
pub(crate) fn quaternion(order: RotationOrder, angles: [f32; 3]) -> Quat {
    let Some([first, second, third]) = order.axes() else { return Quat::IDENTITY };
    let turn = |axis: Axis, degrees: f32| Quat::from_axis_angle(axis.unit(), degrees.to_radians());
    turn(first, angles[0]) * turn(second, angles[1]) * turn(third, angles[2])
}

/// The same difference of two angles in degrees, from −180 to 180.
#[inline]
pub(crate) fn shorter_way(degrees: f32) -> f32 {
    // Taking the remainder is slow, and mostly changes nothing.
    let degrees = if degrees.abs() < 360.0 { degrees } else { degrees % 360.0 };
    if degrees > 180.0 {
        degrees - 360.0
    } else if degrees < -180.0 {
        degrees + 360.0
    } else {
        degrees
    }
}

/// Half of each of a joint's three angles: what its quaternion is made of.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Halves {
    sines: [f32; 3],
    cosines: [f32; 3],
}

impl Halves {
    /// Of angles in degrees.
    pub(crate) fn of(angles: [f32; 3]) -> Halves {
        let pairs = angles.map(|angle| (angle.to_radians() * 0.5).sin_cos());
        Halves { sines: pairs.map(|pair| pair.0), cosines: pairs.map(|pair| pair.1) }
    }
}

/// How a joint turns, with everything prepared that is the same in all frames of a gap.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Turn {
    /// It has no angles.
    Not,
    /// Each angle by itself, the shorter way round.
    Angles {
        axes: [usize; 3],
        /// 1 for X, Y, Z and what follows from it by beginning with another one; −1 for the other orders.
        sign: f32,
        from: Halves,
        /// Half of how far each angle has to go, in radians: from −π/2 to π/2.
        way: [f32; 3],
    },
    /// About one axis, the shorter way round.
    Arc {
        from: Quat,
        to: Quat,
        /// The square of the angle between the two as vectors, in radians: at most (π/2)².
        square: f32,
    },
}

impl Turn {
    /// Between angles in degrees; `halves` are those of `from`.
    pub(crate) fn angles(order: RotationOrder, from: [f32; 3], halves: Halves, to: [f32; 3]) -> Turn {
        let Some(axes) = order.axes() else { return Turn::Not };
        let axes = axes.map(Axis::index);
        let sign = if (axes[0] + 1) % 3 == axes[1] { 1.0 } else { -1.0 };
        let way = std::array::from_fn(|axis| shorter_way(to[axis] - from[axis]).to_radians() * 0.5);
        Turn::Angles { axes, sign, from: halves, way }
    }

    /// Between unit quaternions.
    pub(crate) fn arc(from: Quat, to: Quat) -> Turn {
        let dot = from.dot(to);
        let (to, cosine) = if dot < 0.0 { (-to, -dot) } else { (to, dot) };
        let angle = cosine.min(1.0).acos();
        // With θ for the angle and r(x) for sin(x) / x, the share of `to` is sin(t θ) / sin θ = t r(t θ) / r(θ),
        // which is no division by nearly 0 where θ is nearly 0. What all frames divide by is taken out here.
        let ratio = sine_ratio(Vec4::splat(angle * angle)).x;
        Turn::Arc { from: from / ratio, to: to / ratio, square: angle * angle }
    }

    /// The rotations at each `t` from 0 to 1; `None` where the joint is not turned.
    #[inline]
    pub(crate) fn at(&self, t: Vec4) -> Option<Rotations> {
        match *self {
            Turn::Not => None,
            Turn::Arc { from, to, square } => {
                let share = |t: Vec4| t * sine_ratio(t * t * square);
                Some(Rotations::sum(from, share(1.0 - t), to, share(t)))
            }
            Turn::Angles { axes, sign, from, way } => {
                let [(s1, c1), (s2, c2), (s3, c3)] = std::array::from_fn(|axis| {
                    // sin(a + b) and cos(a + b), where a is half of the first keyframe's angle.
                    let angle = t * way[axis];
                    let square = angle * angle;
                    let (sine, cosine) = (angle * sine_ratio(square), cosine(square));
                    let (s, c) = (from.sines[axis], from.cosines[axis]);
                    (cosine * s + sine * c, cosine * c - sine * s)
                });
                // The product of the three rotations, each about one axis, written out.
                let (ss, sc, cs, cc) = (s1 * s2, s1 * c2, c1 * s2, c1 * c2);
                let s3_signed = s3 * sign;
                let mut vector = [Vec4::ZERO; 3];
                vector[axes[0]] = sc * c3 + cs * s3_signed;
                vector[axes[1]] = cs * c3 - sc * s3_signed;
                vector[axes[2]] = cc * s3 + ss * c3 * sign;
                let [x, y, z] = vector;
                Some(Rotations { vector: Positions { x, y, z }, scalar: cc * c3 - ss * s3_signed })
            }
        }
    }
}
