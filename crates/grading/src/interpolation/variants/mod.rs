//! Known-wrong variants of the three functions, one misconception each.

pub(super) mod angles;
pub(super) mod frame;
pub(super) mod slerp;

use exam::Functions;
use glam::{Quat, Vec3};
use skeleton::{
    Axis, Frame, FrameCursor, InterpolationFunctions, Joint, LocalPose, Representation, RotationOrder,
    Skeleton,
};

/// The functions of the untouched template.
pub const TEMPLATE: InterpolationFunctions = InterpolationFunctions {
    interpolate_angles: |from, _, _| from,
    slerp: |from, _, _| from,
    interpolate_frame: |skeleton, from, _, _, _| LocalPose {
        rotations: vec![Quat::IDENTITY; skeleton.len()],
        positions: from.local_positions.clone(),
    },
};

/// Somebody's way through the exercise. What it says nothing about is right; part 3 calls its own parts 1 and 2.
pub(super) trait Way {
    /// Part 1.
    fn angles(from: [f32; 3], to: [f32; 3], t: f32) -> [f32; 3] {
        solutions::interpolation::interpolate_angles(from, to, t)
    }

    /// Part 2.
    fn slerp(from: Quat, to: Quat, t: f32) -> Quat {
        solutions::interpolation::slerp(from, to, t)
    }

    /// The rotation that a joint's angles make.
    fn quaternion(joint: &Joint, angles: [f32; 3]) -> Quat {
        quaternion(joint, angles)
    }

    /// The angles of each joint in one frame; nothing for a joint that is not turned.
    fn take(joint: &Joint, angles: &mut FrameCursor) -> Option<[f32; 3]> {
        (joint.rotation_order != RotationOrder::None).then(|| angles.take3())
    }

    /// The frames that the angles at both ends are taken from.
    fn ends<'a>(from: &'a Frame, to: &'a Frame) -> [&'a Frame; 2] {
        [from, to]
    }

    /// How far it is to the rotation, when it is `t` to the position.
    fn time(t: f32) -> f32 {
        t
    }

    /// With Euler angles.
    fn by_angles(joint: &Joint, from: [f32; 3], to: [f32; 3], t: f32) -> Quat {
        Self::quaternion(joint, Self::angles(from, to, t))
    }

    /// With quaternions.
    fn by_quaternions(joint: &Joint, from: [f32; 3], to: [f32; 3], t: f32) -> Quat {
        Self::slerp(Self::quaternion(joint, from), Self::quaternion(joint, to), t)
    }

    /// Which of the two is taken.
    fn representation(asked: Representation) -> Representation {
        asked
    }

    /// A joint's position.
    fn position(_: &Joint, from: Vec3, to: Vec3, t: f32) -> Vec3 {
        from.lerp(to, t.clamp(0.0, 1.0))
    }
}

/// All three functions of one who goes this way.
pub(super) fn functions<W: Way>() -> Functions {
    Functions::Interpolation(InterpolationFunctions {
        interpolate_angles: W::angles,
        slerp: W::slerp,
        interpolate_frame: interpolate_frame::<W>,
    })
}

fn interpolate_frame<W: Way>(
    skeleton: &Skeleton,
    from: &Frame,
    to: &Frame,
    t: f32,
    representation: Representation,
) -> LocalPose {
    let mut ends = W::ends(from, to).map(|frame| FrameCursor::new(&frame.angles));
    let rotation = |joint: &Joint| {
        let [from, to] = ends.each_mut().map(|angles| W::take(joint, angles));
        let (Some(from), Some(to)) = (from, to) else { return Quat::IDENTITY };
        match W::representation(representation) {
            Representation::Euler => W::by_angles(joint, from, to, W::time(t)),
            Representation::Quaternion => W::by_quaternions(joint, from, to, W::time(t)),
        }
    };
    let rotations = skeleton.joints().iter().map(rotation).collect();
    let pairs = from.local_positions.iter().zip(&to.local_positions);
    let positions =
        skeleton.joints().iter().zip(pairs).map(|(joint, (from, to))| W::position(joint, *from, *to, t));
    LocalPose { rotations, positions: positions.collect() }
}

/// The rotation that a joint's angles (degrees) make; none for a joint without angles.
pub(super) fn quaternion(joint: &Joint, angles: [f32; 3]) -> Quat {
    let Some(axes) = joint.rotation_order.axes() else { return Quat::IDENTITY };
    let turn = |axis: Axis, degrees: f32| Quat::from_axis_angle(axis.unit(), degrees.to_radians());
    axes.into_iter().zip(angles).map(|(axis, degrees)| turn(axis, degrees)).product()
}
