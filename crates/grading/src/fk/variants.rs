//! Known-wrong variants of the three functions, one misconception each.

use std::f32::consts::PI;

use glam::{Quat, Vec3};
use skeleton::{Axis, FkFunctions, FrameCursor, Joint, JointId, Pose, RotationOrder, Transform};

/// The functions of the untouched template.
pub const TEMPLATE: FkFunctions = FkFunctions {
    local_quaternion: |_, _| Quat::IDENTITY,
    global_quaternion: |_, local, _| local,
    global_position: |_, local_position, _| local_position,
};

/// What someone takes for π.
pub(crate) trait Pi {
    const PI: f32;
}

macro_rules! pi {
    ($(#[$doc:meta] $name:ident = $value:expr;)*) => {
        $(
            #[$doc]
            pub(crate) struct $name;

            impl Pi for $name {
                #[allow(clippy::approx_constant)] // Being approximate is what they are for.
                const PI: f32 = $value;
            }
        )*
    };
}

pi! {
    /// As exact as the type allows.
    Exact = PI;
    /// The original handout's.
    TwoDecimals = 3.14;
    /// Cut off.
    ThreeDecimals = 3.141;
    /// Rounded.
    ThreeRounded = 3.142;
    /// Cut off one later.
    FourDecimals = 3.1415;
    /// Archimedes'.
    Fraction = 22.0 / 7.0;
}

/// Part 1.
pub(crate) mod local {
    use super::*;

    /// Takes the three angles as degrees and lets `make` work on axes and radians; NONE is not turned.
    fn from_frame<P: Pi>(
        joint: &Joint,
        frame: &mut FrameCursor,
        make: impl Fn([Axis; 3], [f32; 3]) -> Quat,
    ) -> Quat {
        match joint.rotation_order.axes() {
            None => Quat::IDENTITY,
            Some(axes) => make(axes, frame.take3().map(|degrees| degrees * P::PI / 180.0)),
        }
    }

    fn turn(axis: Axis, radians: f32) -> Quat {
        Quat::from_axis_angle(axis.unit(), radians)
    }

    fn in_order(axes: [Axis; 3], angles: [f32; 3]) -> Quat {
        turn(axes[0], angles[0]) * turn(axes[1], angles[1]) * turn(axes[2], angles[2])
    }

    pub fn right<P: Pi>(joint: &Joint, frame: &mut FrameCursor) -> Quat {
        from_frame::<P>(joint, frame, in_order)
    }

    pub fn degrees_as_radians(joint: &Joint, frame: &mut FrameCursor) -> Quat {
        from_frame::<Exact>(joint, frame, |axes, angles| in_order(axes, angles.map(f32::to_degrees)))
    }

    pub fn not_halved<P: Pi>(joint: &Joint, frame: &mut FrameCursor) -> Quat {
        from_frame::<P>(joint, frame, |axes, angles| in_order(axes, angles.map(|angle| 2.0 * angle)))
    }

    pub fn negated<P: Pi>(joint: &Joint, frame: &mut FrameCursor) -> Quat {
        from_frame::<P>(joint, frame, |axes, angles| in_order(axes, angles.map(|angle| -angle)))
    }

    pub fn reversed<P: Pi>(joint: &Joint, frame: &mut FrameCursor) -> Quat {
        from_frame::<P>(joint, frame, |[a, b, c], [x, y, z]| in_order([c, b, a], [z, y, x]))
    }

    /// The orders as numbers, for functions that come once per order.
    const fn order<const ORDER: u8>() -> [Axis; 3] {
        use Axis::{X, Y, Z};
        [[X, Y, Z], [X, Z, Y], [Y, X, Z], [Y, Z, X], [Z, X, Y], [Z, Y, X]][ORDER as usize]
    }

    /// Every joint's angles are taken in the same order.
    pub fn always_taken_as<P: Pi, const ORDER: u8>(joint: &Joint, frame: &mut FrameCursor) -> Quat {
        from_frame::<P>(joint, frame, |_, angles| in_order(order::<ORDER>(), angles))
    }

    /// The angles are taken as x, y, z and then multiplied in the joint's order.
    pub fn taken_as_xyz<P: Pi>(joint: &Joint, frame: &mut FrameCursor) -> Quat {
        from_frame::<P>(joint, frame, |axes, angles| in_order(axes, axes.map(|axis| angles[axis.index()])))
    }

    /// The angles are sorted by axis, as if the order said nothing about which comes first, and then used in the order.
    pub fn sorted_by_axis<P: Pi>(joint: &Joint, frame: &mut FrameCursor) -> Quat {
        from_frame::<P>(joint, frame, |axes, angles| {
            in_order(axes, Axis::ALL.map(|axis| angle_about(axis, axes, angles)))
        })
    }

    /// The angles are taken as x, y, z, and every joint is multiplied as if they came in the reverse of this order.
    pub fn always_reversed<P: Pi, const ORDER: u8>(joint: &Joint, frame: &mut FrameCursor) -> Quat {
        from_frame::<P>(joint, frame, |_, [x, y, z]| in_order(order::<ORDER>(), [z, y, x]))
    }

    /// The angles belong to the right axes, and all joints are multiplied in the same order.
    pub fn always_multiplied<P: Pi, const ORDER: u8>(joint: &Joint, frame: &mut FrameCursor) -> Quat {
        from_frame::<P>(joint, frame, |axes, angles| {
            let axes_now = order::<ORDER>();
            in_order(axes_now, axes_now.map(|axis| angle_about(axis, axes, angles)))
        })
    }

    fn angle_about(axis: Axis, axes: [Axis; 3], angles: [f32; 3]) -> f32 {
        axes.into_iter().zip(angles).find(|(own, _)| *own == axis).map_or(0.0, |(_, angle)| angle)
    }

    fn w_to_front(q: Quat) -> Quat {
        Quat::from_xyzw(q.w, q.x, q.y, q.z)
    }

    pub fn w_first<P: Pi>(joint: &Joint, frame: &mut FrameCursor) -> Quat {
        from_frame::<P>(joint, frame, |axes, angles| w_to_front(in_order(axes, angles)))
    }

    pub fn w_first_in_factors<P: Pi>(joint: &Joint, frame: &mut FrameCursor) -> Quat {
        from_frame::<P>(joint, frame, |[a, b, c], [x, y, z]| {
            w_to_front(turn(a, x)) * w_to_front(turn(b, y)) * w_to_front(turn(c, z))
        })
    }

    /// The three numbers as x, y, z of a quaternion with this w, in degrees or radians, as they come or by axis.
    pub fn packed<const W: u8, const RADIANS: bool, const BY_AXIS: bool>(
        joint: &Joint,
        frame: &mut FrameCursor,
    ) -> Quat {
        from_frame::<Exact>(joint, frame, |axes, angles| {
            let angles = if RADIANS { angles } else { angles.map(f32::to_degrees) };
            let [x, y, z] =
                if BY_AXIS { Axis::ALL.map(|axis| angle_about(axis, axes, angles)) } else { angles };
            Quat::from_xyzw(x, y, z, f32::from(W))
        })
    }

    /// The half angle in one of sine and cosine only, for one axis (0, 1, 2) or for all (3).
    pub fn half_in_one<P: Pi, const SINE: bool, const AXIS: usize>(
        joint: &Joint,
        frame: &mut FrameCursor,
    ) -> Quat {
        let factor = |axis: Axis, angle: f32| {
            if AXIS < 3 && axis.index() != AXIS {
                return turn(axis, angle);
            }
            let (sine, cosine) = if SINE { (angle / 2.0, angle) } else { (angle, angle / 2.0) };
            let v = axis.unit() * sine.sin();
            Quat::from_xyzw(v.x, v.y, v.z, cosine.cos())
        };
        from_frame::<P>(joint, frame, |[a, b, c], [x, y, z]| factor(a, x) * factor(b, y) * factor(c, z))
    }

    pub fn moves_on_none(joint: &Joint, frame: &mut FrameCursor) -> Quat {
        if joint.rotation_order == RotationOrder::None {
            frame.take3();
        }
        right::<Exact>(joint, frame)
    }

    /// As if NONE were an order like the others.
    pub fn turns_on_none(joint: &Joint, frame: &mut FrameCursor) -> Quat {
        let axes = joint.rotation_order.axes().unwrap_or(Axis::ALL);
        in_order(axes, frame.take3().map(f32::to_radians))
    }

    /// A joint without angles need not be an End Site.
    pub fn moves_on_none_but_not_on_end_sites(joint: &Joint, frame: &mut FrameCursor) -> Quat {
        if joint.is_end_site { Quat::IDENTITY } else { turns_on_none(joint, frame) }
    }

    pub fn never_moves(joint: &Joint, frame: &mut FrameCursor) -> Quat {
        right::<Exact>(joint, &mut frame.clone())
    }

    pub fn takes_two(joint: &Joint, frame: &mut FrameCursor) -> Quat {
        let q = right::<Exact>(joint, &mut frame.clone());
        if joint.rotation_order != RotationOrder::None {
            frame.take();
            frame.take();
        }
        q
    }
}

/// Part 2. Each function is for joints with a parent; roots are right.
pub(super) mod rotation {
    use super::*;

    fn below_root(joint: &Joint, local: Quat, pose: &Pose, make: impl Fn(Quat) -> Quat) -> Quat {
        joint.parent.map_or(local, |parent| make(pose[parent].rotation))
    }

    pub fn swapped(joint: &Joint, local: Quat, pose: &Pose) -> Quat {
        below_root(joint, local, pose, |parent| local * parent)
    }

    pub fn parent_only(joint: &Joint, local: Quat, pose: &Pose) -> Quat {
        below_root(joint, local, pose, |parent| parent)
    }

    pub fn parent_twice(joint: &Joint, local: Quat, pose: &Pose) -> Quat {
        below_root(joint, local, pose, |parent| parent * parent * local)
    }

    pub fn parent_on_both_sides(joint: &Joint, local: Quat, pose: &Pose) -> Quat {
        below_root(joint, local, pose, |parent| parent * local * parent)
    }

    pub fn parent_squared(joint: &Joint, local: Quat, pose: &Pose) -> Quat {
        below_root(joint, local, pose, |parent| parent * parent)
    }

    pub fn sum(joint: &Joint, local: Quat, pose: &Pose) -> Quat {
        below_root(joint, local, pose, |parent| parent + local)
    }

    pub fn sum_normalized(joint: &Joint, local: Quat, pose: &Pose) -> Quat {
        below_root(joint, local, pose, |parent| (parent + local).normalize())
    }

    /// Unlike the normalised sum, this takes the shorter way where the two point apart.
    pub fn blend(joint: &Joint, local: Quat, pose: &Pose) -> Quat {
        below_root(joint, local, pose, |parent| parent.lerp(local, 0.5))
    }

    pub fn inverse(joint: &Joint, local: Quat, pose: &Pose) -> Quat {
        below_root(joint, local, pose, |parent| parent.inverse() * local)
    }

    pub fn inverse_behind(joint: &Joint, local: Quat, pose: &Pose) -> Quat {
        below_root(joint, local, pose, |parent| local * parent.inverse())
    }

    pub fn previous(joint: &Joint, local: Quat, pose: &Pose) -> Quat {
        joint.parent.map_or(local, |_| pose[before(joint)].rotation * local)
    }

    pub fn root_forgotten(joint: &Joint, local: Quat, pose: &Pose) -> Quat {
        joint.parent.map_or(Quat::IDENTITY, |parent| pose[parent].rotation * local)
    }

    pub fn root_twice(joint: &Joint, local: Quat, pose: &Pose) -> Quat {
        joint.parent.map_or(local * local, |parent| pose[parent].rotation * local)
    }
}

/// Part 3. Each function but those about the root is for joints with a parent; roots are right. With `OFFSET` it takes
/// the joint's offset where it should take the local position.
pub(super) mod position {
    use super::*;

    fn below_root<const OFFSET: bool>(
        joint: &Joint,
        local: Vec3,
        pose: &Pose,
        make: impl Fn(Transform, Vec3) -> Vec3,
    ) -> Vec3 {
        let bone = if OFFSET { joint.offset } else { local };
        joint.parent.map_or(local, |parent| make(pose[parent], bone))
    }

    pub fn own_rotation<const OFFSET: bool>(joint: &Joint, local: Vec3, pose: &Pose) -> Vec3 {
        below_root::<OFFSET>(joint, local, pose, |parent, bone| {
            parent.position + pose[joint.id].rotation * bone
        })
    }

    pub fn not_rotated<const OFFSET: bool>(joint: &Joint, local: Vec3, pose: &Pose) -> Vec3 {
        below_root::<OFFSET>(joint, local, pose, |parent, bone| parent.position + bone)
    }

    pub fn parent_not_added<const OFFSET: bool>(joint: &Joint, local: Vec3, pose: &Pose) -> Vec3 {
        below_root::<OFFSET>(joint, local, pose, |parent, bone| parent.rotation * bone)
    }

    pub fn parent_rotated_too<const OFFSET: bool>(joint: &Joint, local: Vec3, pose: &Pose) -> Vec3 {
        below_root::<OFFSET>(joint, local, pose, |parent, bone| parent.rotation * (parent.position + bone))
    }

    pub fn inverse<const OFFSET: bool>(joint: &Joint, local: Vec3, pose: &Pose) -> Vec3 {
        below_root::<OFFSET>(joint, local, pose, |parent, bone| {
            parent.position + parent.rotation.inverse() * bone
        })
    }

    fn pure(v: Vec3) -> Quat {
        Quat::from_xyzw(v.x, v.y, v.z, 0.0)
    }

    pub fn from_the_left_only<const OFFSET: bool>(joint: &Joint, local: Vec3, pose: &Pose) -> Vec3 {
        below_root::<OFFSET>(joint, local, pose, |parent, bone| {
            parent.position + (parent.rotation * pure(bone)).xyz()
        })
    }

    pub fn from_the_right_only<const OFFSET: bool>(joint: &Joint, local: Vec3, pose: &Pose) -> Vec3 {
        below_root::<OFFSET>(joint, local, pose, |parent, bone| {
            parent.position + (pure(bone) * parent.rotation).xyz()
        })
    }

    pub fn previous(joint: &Joint, local: Vec3, pose: &Pose) -> Vec3 {
        let before = pose[before(joint)];
        below_root::<false>(joint, local, pose, |_, bone| before.position + before.rotation * bone)
    }

    /// The joint's own position has not been computed yet: it is the origin.
    pub fn own_transform<const OFFSET: bool>(joint: &Joint, local: Vec3, pose: &Pose) -> Vec3 {
        let own = pose[joint.id];
        below_root::<OFFSET>(joint, local, pose, |_, bone| own.position + own.rotation * bone)
    }

    pub fn always_offset(joint: &Joint, local: Vec3, pose: &Pose) -> Vec3 {
        below_root::<true>(joint, local, pose, |parent, bone| parent.position + parent.rotation * bone)
    }

    pub fn root_at_offset(joint: &Joint, local: Vec3, pose: &Pose) -> Vec3 {
        joint.parent.map_or(joint.offset, |parent| pose[parent].position + pose[parent].rotation * local)
    }

    pub fn root_at_origin(joint: &Joint, local: Vec3, pose: &Pose) -> Vec3 {
        joint.parent.map_or(Vec3::ZERO, |parent| pose[parent].position + pose[parent].rotation * local)
    }
}

/// The joint that was visited just before.
fn before(joint: &Joint) -> JointId {
    JointId(joint.id.0.saturating_sub(1))
}
