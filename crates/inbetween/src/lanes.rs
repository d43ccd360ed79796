//! Four frames at a time: each number of a rotation or a position for all of them side by side, in one [`Vec4`].

use std::ops::{Add, Mul};

use glam::{Quat, Vec3, Vec4};

/// How many frames are posed at a time.
pub(crate) const LANES: usize = 4;

/// Four rotations, as quaternions.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rotations {
    pub(crate) vector: Positions,
    pub(crate) scalar: Vec4,
}

/// Four positions.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Positions {
    pub(crate) x: Vec4,
    pub(crate) y: Vec4,
    pub(crate) z: Vec4,
}

impl Rotations {
    /// Not turned.
    pub(crate) const IDENTITY: Rotations =
        Rotations { vector: Positions { x: Vec4::ZERO, y: Vec4::ZERO, z: Vec4::ZERO }, scalar: Vec4::ONE };

    /// `first` and `second`, each times its own factor.
    #[inline]
    pub(crate) fn sum(first: Quat, by: Vec4, second: Quat, by_second: Vec4) -> Rotations {
        let sum = |first: f32, second: f32| by * first + by_second * second;
        Rotations {
            vector: Positions {
                x: sum(first.x, second.x),
                y: sum(first.y, second.y),
                z: sum(first.z, second.z),
            },
            scalar: sum(first.w, second.w),
        }
    }

    /// The rotation of one frame.
    #[inline]
    pub(crate) fn lane(self, lane: usize) -> Quat {
        let Positions { x, y, z } = self.vector;
        Quat::from_xyzw(x[lane], y[lane], z[lane], self.scalar[lane])
    }
}

impl Positions {
    /// On the way from `from` along `way`.
    #[inline]
    pub(crate) fn along(from: Vec3, way: Vec3, t: Vec4) -> Positions {
        Positions { x: t * way.x + from.x, y: t * way.y + from.y, z: t * way.z + from.z }
    }

    #[inline]
    fn cross(self, other: Positions) -> Positions {
        Positions {
            x: self.y * other.z - self.z * other.y,
            y: self.z * other.x - self.x * other.z,
            z: self.x * other.y - self.y * other.x,
        }
    }

    /// The position of one frame.
    #[inline]
    pub(crate) fn lane(self, lane: usize) -> Vec3 {
        Vec3::new(self.x[lane], self.y[lane], self.z[lane])
    }
}

impl Add for Positions {
    type Output = Positions;

    #[inline]
    fn add(self, other: Positions) -> Positions {
        Positions { x: self.x + other.x, y: self.y + other.y, z: self.z + other.z }
    }
}

impl Mul<Vec4> for Positions {
    type Output = Positions;

    #[inline]
    fn mul(self, factor: Vec4) -> Positions {
        Positions { x: self.x * factor, y: self.y * factor, z: self.z * factor }
    }
}

/// The rotation that does `other` first.
impl Mul for Rotations {
    type Output = Rotations;

    #[inline]
    fn mul(self, other: Rotations) -> Rotations {
        let (a, b) = (self.vector, other.vector);
        Rotations {
            vector: b * self.scalar + a * other.scalar + a.cross(b),
            scalar: self.scalar * other.scalar - (a.x * b.x + a.y * b.y + a.z * b.z),
        }
    }
}

/// Turns four positions.
impl Mul<Positions> for Rotations {
    type Output = Positions;

    #[inline]
    fn mul(self, position: Positions) -> Positions {
        let half = self.vector.cross(position);
        let twice = half + half;
        position + twice * self.scalar + self.vector.cross(twice)
    }
}

/// sin(x) / x from the square of x, for x from −π/2 to π/2: its Taylor series, off by less than 4e-8.
#[inline]
pub(crate) fn sine_ratio(square: Vec4) -> Vec4 {
    series(square, [1.0, -6.0, 120.0, -5_040.0, 362_880.0, -39_916_800.0])
}

/// cos(x) from the square of x, for x from −π/2 to π/2: its Taylor series, off by less than 1e-8.
#[inline]
pub(crate) fn cosine(square: Vec4) -> Vec4 {
    series(square, [1.0, -2.0, 24.0, -720.0, 40_320.0, -3_628_800.0, 479_001_600.0])
}

/// The sum of the powers of `x`, each divided by its own divisor.
#[inline]
fn series<const TERMS: usize>(x: Vec4, divisors: [f32; TERMS]) -> Vec4 {
    divisors.into_iter().rev().fold(Vec4::ZERO, |sum, divisor| sum * x + 1.0 / divisor)
}
