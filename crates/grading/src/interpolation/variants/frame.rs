//! Part 3.

use std::marker::PhantomData;

use glam::{Quat, Vec3};
use skeleton::{Axis, Frame, FrameCursor, Joint, Representation, RotationOrder};

use super::{Way, angles, quaternion};
use crate::fk::variants::{Exact, Pi, local};

/// The rotation of angles is part 1 of forward kinematics, and the same goes wrong.
macro_rules! converted_by {
    ($($(#[$doc:meta])* $name:ident $(<const $order:ident: u8>)? = $function:path;)*) => {
        $(
            $(#[$doc])*
            pub struct $name $(<const $order: u8>)?;

            impl $(<const $order: u8>)? Way for $name $(<$order>)? {
                fn quaternion(joint: &Joint, angles: [f32; 3]) -> Quat {
                    $function(joint, &mut FrameCursor::new(&angles))
                }
            }
        )*
    };
}

converted_by! {
    /// Sine and cosine of degrees.
    DegreesAsRadians = local::degrees_as_radians;
    /// The last angle first.
    Reversed = local::reversed::<Exact>;
    /// All joints as if they had one order.
    TakenAs<const ORDER: u8> = local::always_taken_as::<Exact, ORDER>;
    /// The same, with the last angle first.
    TakenReversedAs<const ORDER: u8> = local::always_reversed::<Exact, ORDER>;
    /// Every angle about its own axis, multiplied in one order.
    MultipliedAs<const ORDER: u8> = local::always_multiplied::<Exact, ORDER>;
    /// As if every joint's angles were those about X, Y and Z.
    TakenAsXyz = local::taken_as_xyz::<Exact>;
    /// As if the angles had to be sorted first.
    SortedByAxis = local::sorted_by_axis::<Exact>;
}

/// Right, but for a π with few digits.
pub struct ShortPi<P>(PhantomData<P>);

impl<P: Pi> Way for ShortPi<P> {
    fn quaternion(joint: &Joint, angles: [f32; 3]) -> Quat {
        local::right::<P>(joint, &mut FrameCursor::new(&angles))
    }
}

/// The three numbers as x, y and z of a quaternion, whatever they mean.
fn packed<const W: u8, const RADIANS: bool, const NORMALIZED: bool>(angles: [f32; 3]) -> Quat {
    let [x, y, z] = if RADIANS { angles.map(f32::to_radians) } else { angles };
    let q = Quat::from_xyzw(x, y, z, f32::from(W));
    if NORMALIZED { q.normalize() } else { q }
}

/// Puts the angles into quaternions in both representations. Interpolated angles come as they are, or `WITHIN` ±180
/// degrees.
pub struct Packed<const W: u8, const RADIANS: bool, const NORMALIZED: bool, const WITHIN: bool>;

impl<const W: u8, const RADIANS: bool, const NORMALIZED: bool, const WITHIN: bool> Way
    for Packed<W, RADIANS, NORMALIZED, WITHIN>
{
    fn quaternion(_: &Joint, angles: [f32; 3]) -> Quat {
        packed::<W, RADIANS, NORMALIZED>(angles)
    }

    fn by_angles(joint: &Joint, from: [f32; 3], to: [f32; 3], t: f32) -> Quat {
        let between = Self::angles(from, to, t);
        Self::quaternion(joint, if WITHIN { between.map(angles::half_turn) } else { between })
    }
}

/// Puts the angles into quaternions for slerp only.
pub struct PackedForSlerp<const W: u8, const RADIANS: bool, const NORMALIZED: bool>;

impl<const W: u8, const RADIANS: bool, const NORMALIZED: bool> Way
    for PackedForSlerp<W, RADIANS, NORMALIZED>
{
    fn by_quaternions(_: &Joint, from: [f32; 3], to: [f32; 3], t: f32) -> Quat {
        let [from, to] = [from, to].map(packed::<W, RADIANS, NORMALIZED>);
        Self::slerp(from, to, t)
    }
}

/// Puts the angles into quaternions, and takes them out again when they have been interpolated.
pub struct PackedAndUnpacked<const W: u8, const NORMALIZED: bool>;

impl<const W: u8, const NORMALIZED: bool> Way for PackedAndUnpacked<W, NORMALIZED> {
    fn by_quaternions(joint: &Joint, from: [f32; 3], to: [f32; 3], t: f32) -> Quat {
        let [from, to] = [from, to].map(packed::<W, false, NORMALIZED>);
        quaternion(joint, Self::slerp(from, to, t).xyz().to_array())
    }
}

/// The same with a slerp for which numbers so large count as nearly parallel: it gives a straight line of the angles,
/// or of their negatives, which may be taken for the shorter way.
pub struct PackedStraight<const UNPACKED: bool, const SHORTER: bool>;

impl<const UNPACKED: bool, const SHORTER: bool> Way for PackedStraight<UNPACKED, SHORTER> {
    fn by_quaternions(joint: &Joint, from: [f32; 3], to: [f32; 3], t: f32) -> Quat {
        let [from, to] = [from, to].map(packed::<0, false, false>);
        let to = if SHORTER && from.dot(to) < 0.0 { -to } else { to };
        let between = from * (1.0 - t) + to * t;
        if UNPACKED { quaternion(joint, between.xyz().to_array()) } else { between }
    }
}

/// Interpolates quaternions, and takes x, y and z of the result for angles.
pub struct ComponentsAsAngles<const RADIANS: bool, const BY_AXIS: bool>;

impl<const RADIANS: bool, const BY_AXIS: bool> Way for ComponentsAsAngles<RADIANS, BY_AXIS> {
    fn by_quaternions(joint: &Joint, from: [f32; 3], to: [f32; 3], t: f32) -> Quat {
        let between = Self::slerp(quaternion(joint, from), quaternion(joint, to), t);
        let angles = between.xyz().to_array();
        let angles = if RADIANS { angles.map(f32::to_degrees) } else { angles };
        let axes = joint.rotation_order.axes().filter(|_| BY_AXIS).unwrap_or(Axis::ALL);
        quaternion(joint, axes.map(|axis| angles[axis.index()]))
    }
}

/// Always the one representation, whichever was asked for.
pub struct Always<const EULER: bool>;

impl<const EULER: bool> Way for Always<EULER> {
    fn representation(_: Representation) -> Representation {
        if EULER { Representation::Euler } else { Representation::Quaternion }
    }
}

/// Each of the two for the other.
pub struct Exchanged;

impl Way for Exchanged {
    fn representation(asked: Representation) -> Representation {
        match asked {
            Representation::Euler => Representation::Quaternion,
            Representation::Quaternion => Representation::Euler,
        }
    }
}

/// Interpolates angles not by part 1 but this way.
pub struct OtherAngles<W>(PhantomData<W>);

impl<W: Way> Way for OtherAngles<W> {
    fn by_angles(joint: &Joint, from: [f32; 3], to: [f32; 3], t: f32) -> Quat {
        quaternion(joint, W::angles(from, to, t))
    }
}

/// Interpolates quaternions not by part 2 but this way.
pub struct OtherSlerp<W>(PhantomData<W>);

impl<W: Way> Way for OtherSlerp<W> {
    fn by_quaternions(joint: &Joint, from: [f32; 3], to: [f32; 3], t: f32) -> Quat {
        W::slerp(quaternion(joint, from), quaternion(joint, to), t)
    }
}

/// Takes the angles of both ends from the same frame.
pub struct OneFrame<const SECOND: bool>;

impl<const SECOND: bool> Way for OneFrame<SECOND> {
    fn ends<'a>(from: &'a Frame, to: &'a Frame) -> [&'a Frame; 2] {
        [if SECOND { to } else { from }; 2]
    }
}

/// Counts from the second frame to the first.
pub struct Backwards<const ROTATIONS: bool, const POSITIONS: bool>;

impl<const ROTATIONS: bool, const POSITIONS: bool> Way for Backwards<ROTATIONS, POSITIONS> {
    fn time(t: f32) -> f32 {
        if ROTATIONS { 1.0 - t } else { t }
    }

    fn position(_: &Joint, from: Vec3, to: Vec3, t: f32) -> Vec3 {
        if POSITIONS { to.lerp(from, t) } else { from.lerp(to, t) }
    }
}

/// Reads the angles without moving on.
pub struct NeverMoves;

impl Way for NeverMoves {
    fn take(joint: &Joint, angles: &mut FrameCursor) -> Option<[f32; 3]> {
        rotates(joint).then(|| angles.peek3())
    }
}

fn rotates(joint: &Joint) -> bool {
    joint.rotation_order != RotationOrder::None
}

/// Leaves the third angle to the next joint.
pub struct OneShort;

impl Way for OneShort {
    fn take(joint: &Joint, angles: &mut FrameCursor) -> Option<[f32; 3]> {
        rotates(joint).then(|| [angles.take(), angles.take(), angles.peek3()[0]])
    }
}

/// Takes angles for joints that have none, End Sites among them or not, and may turn the joints by them.
pub struct TakesOnNone<const END_SITES: bool, const TURNS: bool>;

impl<const END_SITES: bool, const TURNS: bool> Way for TakesOnNone<END_SITES, TURNS> {
    fn take(joint: &Joint, angles: &mut FrameCursor) -> Option<[f32; 3]> {
        let takes = rotates(joint) || END_SITES || !joint.is_end_site;
        takes.then(|| angles.take3()).filter(|_| rotates(joint) || TURNS)
    }

    fn quaternion(joint: &Joint, angles: [f32; 3]) -> Quat {
        let turned = Joint { rotation_order: RotationOrder::Xyz, ..joint.clone() };
        quaternion(if rotates(joint) { joint } else { &turned }, angles)
    }
}

/// Positions are those of one frame.
pub struct PositionsStay<const SECOND: bool>;

impl<const SECOND: bool> Way for PositionsStay<SECOND> {
    fn position(_: &Joint, from: Vec3, to: Vec3, _: f32) -> Vec3 {
        if SECOND { to } else { from }
    }
}

/// Positions are the skeleton's own.
pub struct Offsets;

impl Way for Offsets {
    fn position(joint: &Joint, _: Vec3, _: Vec3, _: f32) -> Vec3 {
        joint.offset
    }
}

/// Interpolates the position of the roots, or of the first of them, and takes those of all others from `ELSEWHERE`: the
/// first frame, the second one, or the skeleton.
pub struct OnlyRoots<const FIRST: bool, const ELSEWHERE: u8>;

impl<const FIRST: bool, const ELSEWHERE: u8> Way for OnlyRoots<FIRST, ELSEWHERE> {
    fn position(joint: &Joint, from: Vec3, to: Vec3, t: f32) -> Vec3 {
        if joint.is_root() && (!FIRST || joint.id.0 == 0) {
            return from.lerp(to, t);
        }
        [from, to, joint.offset][usize::from(ELSEWHERE)]
    }
}
