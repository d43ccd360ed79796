//! Part 2.

use std::marker::PhantomData;

use glam::{EulerRot, Mat3, Quat, Vec3, Vec4};

use super::{Way, angles, quaternion};
use crate::fk::variants::{Exact, Pi};

/// What each makes of the angles of a bone in two postures.
macro_rules! ways {
    ($($(#[$doc:meta])* $name:ident($from:ident, $to:ident, $t:ident) $body:expr;)*) => {
        $(
            $(#[$doc])*
            pub struct $name;

            impl Way for $name {
                fn blend_angles($from: [f32; 3], $to: [f32; 3], $t: f32) -> [f32; 3] {
                    $body
                }
            }
        )*
    };
}

ways! {
    /// A straight line from number to number.
    StraightAngles(from, to, t) [0, 1, 2].map(|axis| from[axis] + t * (to[axis] - from[axis]));

    /// The same, each angle the shorter way round.
    ShorterAngles(from, to, t) [0, 1, 2].map(|axis| {
        let way = (to[axis] - from[axis] + 180.0).rem_euclid(360.0) - 180.0;
        from[axis] + t * way
    });

    /// An arrow that is turned and becomes longer or shorter.
    ArrowOfAngles(from, to, t) Vec3::from(from).slerp(Vec3::from(to), t).to_array();

    /// Those of the first posture.
    FirstAngles(from, _to, _t) from;

    /// Those of the second posture.
    SecondAngles(_from, to, _t) to;

    /// Those of the posture that is nearer.
    NearerAngles(from, to, t) if t < 0.5 { from } else { to };
}

/// Right, but for the number that somebody takes for π when quaternions are made of angles, when angles are made of
/// quaternions, or both.
pub struct ShortPi<P, const INTO: bool, const OUT: bool>(PhantomData<P>);

impl<P: Pi, const INTO: bool, const OUT: bool> Way for ShortPi<P, INTO, OUT> {
    fn quaternion(angles: [f32; 3]) -> Quat {
        quaternion(if INTO { angles.map(|degrees| degrees * (P::PI / Exact::PI)) } else { angles })
    }

    fn angles(rotation: Quat) -> [f32; 3] {
        let angles = angles(rotation);
        if OUT { angles.map(|degrees| degrees * (Exact::PI / P::PI)) } else { angles }
    }
}

/// A straight line, brought back to length 1.
pub struct StraightLine;

impl Way for StraightLine {
    fn slerp(from: Quat, to: Quat, t: f32) -> Quat {
        from.lerp(to, t)
    }
}

/// The formula without a look at the dot product.
pub struct AsTheyCome;

impl Way for AsTheyCome {
    fn slerp(from: Quat, to: Quat, t: f32) -> Quat {
        let angle = from.dot(to).clamp(-1.0, 1.0).acos();
        if angle.sin() < 1e-4 {
            return from.lerp(to, t);
        }
        (from * ((1.0 - t) * angle).sin() + to * (t * angle).sin()) / angle.sin()
    }
}

/// Three numbers that are no components of a quaternion, as x, y and z of one.
fn packed<const W: u8, const RADIANS: bool, const NORMALIZED: bool>(angles: [f32; 3]) -> Quat {
    let [x, y, z] = if RADIANS { angles.map(f32::to_radians) } else { angles };
    let q = Quat::from_xyzw(x, y, z, f32::from(W));
    if NORMALIZED { q.normalize() } else { q }
}

/// A slerp like that of Eigen, for C++: where the dot product is not below 1, it is a straight line, and stays as long
/// as it is.
fn slerp_of_any_length(from: Quat, to: Quat, t: f32) -> Quat {
    let dot = from.dot(to);
    let (first, second) = if dot.abs() >= 1.0 - f32::EPSILON {
        (1.0 - t, t)
    } else {
        let angle = dot.abs().acos();
        (((1.0 - t) * angle).sin() / angle.sin(), (t * angle).sin() / angle.sin())
    };
    let second = if dot < 0.0 { -second } else { second };
    Quat::from_vec4(Vec4::from(from) * first + Vec4::from(to) * second)
}

/// Puts the angles into quaternions, and takes x, y and z out again when they have been interpolated: by glam's slerp, or
/// by one that `KEEPS` their length.
pub struct PackedAndUnpacked<const W: u8, const RADIANS: bool, const NORMALIZED: bool, const KEEPS: bool>;

impl<const W: u8, const RADIANS: bool, const NORMALIZED: bool, const KEEPS: bool> Way
    for PackedAndUnpacked<W, RADIANS, NORMALIZED, KEEPS>
{
    fn quaternion(angles: [f32; 3]) -> Quat {
        packed::<W, RADIANS, NORMALIZED>(angles)
    }

    fn slerp(from: Quat, to: Quat, t: f32) -> Quat {
        if KEEPS { slerp_of_any_length(from, to, t) } else { from.slerp(to, t) }
    }

    fn angles(rotation: Quat) -> [f32; 3] {
        let numbers = rotation.xyz().to_array();
        if RADIANS { numbers.map(f32::to_degrees) } else { numbers }
    }
}

/// Puts the angles into quaternions, and makes angles of the result as it should be done.
pub struct PackedForSlerp<const W: u8, const RADIANS: bool, const NORMALIZED: bool>;

impl<const W: u8, const RADIANS: bool, const NORMALIZED: bool> Way
    for PackedForSlerp<W, RADIANS, NORMALIZED>
{
    fn quaternion(angles: [f32; 3]) -> Quat {
        packed::<W, RADIANS, NORMALIZED>(angles)
    }
}

/// Interpolates quaternions, and takes x, y and z of the result for angles: as they are, in radians, as the sines of half
/// the angles, or as parts of half a turn. Quaternions that come `BY_MATRICES` can have another sign.
pub struct ComponentsAsAngles<const READ_AS: u8, const BY_MATRICES: bool>;

impl<const READ_AS: u8, const BY_MATRICES: bool> Way for ComponentsAsAngles<READ_AS, BY_MATRICES> {
    fn quaternion(angles: [f32; 3]) -> Quat {
        let rotation = quaternion(angles);
        if BY_MATRICES { Quat::from_mat3(&Mat3::from_quat(rotation)) } else { rotation }
    }

    fn angles(rotation: Quat) -> [f32; 3] {
        let numbers = rotation.xyz().to_array();
        match READ_AS {
            0 => numbers,
            1 => numbers.map(f32::to_degrees),
            3 => numbers.map(|part| part * 180.0),
            _ => numbers.map(|sine| 2.0 * sine.clamp(-1.0, 1.0).asin().to_degrees()),
        }
    }
}

/// Takes three angles for the axis times the angle of one rotation: when a quaternion is made of them, when they are made
/// of a quaternion, or both.
pub struct RotationVector<const INTO: bool, const OUT: bool>;

impl<const INTO: bool, const OUT: bool> Way for RotationVector<INTO, OUT> {
    fn quaternion(angles: [f32; 3]) -> Quat {
        if INTO {
            Quat::from_scaled_axis(Vec3::from(angles.map(f32::to_radians)))
        } else {
            quaternion(angles)
        }
    }

    fn angles(rotation: Quat) -> [f32; 3] {
        if OUT { rotation.to_scaled_axis().to_array().map(f32::to_degrees) } else { angles(rotation) }
    }
}

/// The order in which somebody multiplies the rotations about the three axes.
fn order(number: u8) -> EulerRot {
    match number {
        0 => EulerRot::XYZ,
        1 => EulerRot::XZY,
        2 => EulerRot::YXZ,
        3 => EulerRot::YZX,
        4 => EulerRot::ZXY,
        _ => EulerRot::ZYX,
    }
}

/// The places of X, Y and Z in such an order.
fn places(number: u8) -> [usize; 3] {
    [[0, 1, 2], [0, 2, 1], [1, 0, 2], [2, 0, 1], [1, 2, 0], [2, 1, 0]][usize::from(number)]
}

/// Every angle about its own axis, multiplied in another order on the way into quaternions and out of them.
pub struct Ordered<const INTO: u8, const OUT: u8>;

impl<const INTO: u8, const OUT: u8> Way for Ordered<INTO, OUT> {
    fn quaternion(angles: [f32; 3]) -> Quat {
        let mut inputs = [0.0; 3];
        for (angle, place) in angles.into_iter().zip(places(INTO)) {
            inputs[place] = angle.to_radians();
        }
        Quat::from_euler(order(INTO), inputs[0], inputs[1], inputs[2])
    }

    fn angles(rotation: Quat) -> [f32; 3] {
        let (a, b, c) = rotation.to_euler(order(OUT));
        places(OUT).map(|place| [a, b, c][place].to_degrees())
    }
}

/// The order of ZYX, with the angles about X and Z in each other's place on the way into quaternions or out of them. Who
/// exchanges them on both ways is right again.
pub struct Exchanged<const INTO: bool>;

impl<const INTO: bool> Way for Exchanged<INTO> {
    fn quaternion([x, y, z]: [f32; 3]) -> Quat {
        quaternion(if INTO { [z, y, x] } else { [x, y, z] })
    }

    fn angles(rotation: Quat) -> [f32; 3] {
        let [x, y, z] = angles(rotation);
        if INTO { [x, y, z] } else { [z, y, x] }
    }
}

/// Hands degrees to functions that want radians, or takes radians for degrees, or both.
pub struct DegreesAndRadians<const INTO: bool, const OUT: bool>;

impl<const INTO: bool, const OUT: bool> Way for DegreesAndRadians<INTO, OUT> {
    fn quaternion(angles: [f32; 3]) -> Quat {
        quaternion(if INTO { angles.map(f32::to_degrees) } else { angles })
    }

    fn angles(rotation: Quat) -> [f32; 3] {
        let angles = angles(rotation);
        if OUT { angles.map(f32::to_radians) } else { angles }
    }
}

/// The same with the angles in another order.
pub struct OrderedDegrees<const ORDER: u8, const INTO: bool, const OUT: bool>;

impl<const ORDER: u8, const INTO: bool, const OUT: bool> Way for OrderedDegrees<ORDER, INTO, OUT> {
    fn quaternion(angles: [f32; 3]) -> Quat {
        Ordered::<ORDER, ORDER>::quaternion(if INTO { angles.map(f32::to_degrees) } else { angles })
    }

    fn angles(rotation: Quat) -> [f32; 3] {
        let angles = Ordered::<ORDER, ORDER>::angles(rotation);
        if OUT { angles.map(f32::to_radians) } else { angles }
    }
}

/// Counts from the second posture to the first.
pub struct Backwards<const ANGLES: bool, const TRANSLATIONS: bool>;

impl<const ANGLES: bool, const TRANSLATIONS: bool> Way for Backwards<ANGLES, TRANSLATIONS> {
    fn time(t: f32) -> f32 {
        if ANGLES { 1.0 - t } else { t }
    }

    fn translation(_: usize, from: Vec3, to: Vec3, t: f32) -> Vec3 {
        if TRANSLATIONS { to.lerp(from, t) } else { from.lerp(to, t) }
    }
}

/// Translations are those of the first posture (0) or of the second one (1), or there are none (2).
pub struct TranslationsStay<const AT: usize>;

impl<const AT: usize> Way for TranslationsStay<AT> {
    fn translation(_: usize, from: Vec3, to: Vec3, _: f32) -> Vec3 {
        [from, to, Vec3::ZERO][AT]
    }
}

/// Translations are arrows that are turned and become longer or shorter.
pub struct TranslationsOnAnArc;

impl Way for TranslationsOnAnArc {
    fn translation(_: usize, from: Vec3, to: Vec3, t: f32) -> Vec3 {
        from.slerp(to, t)
    }
}

/// Only the first bone's translation is blended, and the others are as in `TranslationsStay`.
pub struct OnlyTheRootMoves<const ELSEWHERE: usize>;

impl<const ELSEWHERE: usize> Way for OnlyTheRootMoves<ELSEWHERE> {
    fn translation(bone: usize, from: Vec3, to: Vec3, t: f32) -> Vec3 {
        if bone == 0 { from.lerp(to, t) } else { [from, to, Vec3::ZERO][ELSEWHERE] }
    }
}
