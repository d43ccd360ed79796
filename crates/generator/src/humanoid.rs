//! The humanoid that runs and dances: its joints and its measures.
//!
//! It is 175 cm tall. Segment lengths are the fractions of body height of Drillis and Contini (1966, "Body segment
//! parameters"), as printed in Winter (2009, "Biomechanics and Motor Control of Human Movement", figure 4.1): thigh
//! 0.245, shank 0.246, ankle above the sole 0.039, foot 0.152, upper arm 0.186, forearm 0.146, hand 0.108. Where the
//! joints of trunk, collar and hand stand is our own estimate within the heights given there.
//!
//! At rest it stands in a T: Y up, facing +Z, its left at +X, arms stretched out to the sides, palms down. The unit
//! is the centimetre.

use glam::{DVec3, Vec3};
use skeleton::{Axis, Channel, JointId, Skeleton, SkeletonError};

/// From hip joint to knee, in cm.
pub const THIGH: f64 = 42.9;
/// From knee to ankle, in cm.
pub const SHANK: f64 = 43.05;
/// From the ankle down to the sole, in cm.
pub const ANKLE_HEIGHT: f64 = 6.8;
/// From the ball of the foot, where the toes bend, down to the sole, in cm.
pub const BALL_HEIGHT: f64 = 2.0;
/// The hind end of the sole, seen from the ankle, in cm.
pub const HEEL: DVec3 = DVec3::new(0.0, -ANKLE_HEIGHT, -6.0);
/// The ball of the foot, seen from the ankle, in cm.
pub const BALL: DVec3 = DVec3::new(0.0, BALL_HEIGHT - ANKLE_HEIGHT, 13.2);
/// The left hip joint, seen from the joint `Hips`, in cm.
pub const LEFT_HIP: DVec3 = DVec3::new(8.9, -5.0, 0.0);

/// The left or the right half of the body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// At +X when facing +Z.
    Left,
    /// At −X when facing +Z.
    Right,
}

impl Side {
    /// Both sides.
    pub const BOTH: [Side; 2] = [Side::Left, Side::Right];

    /// 1 on the left, −1 on the right: mirrors X positions, and angles about Y and Z.
    pub fn sign(self) -> f64 {
        match self {
            Side::Left => 1.0,
            Side::Right => -1.0,
        }
    }

    /// A left-hand point of the body on this side.
    pub fn mirror(self, left: DVec3) -> DVec3 {
        DVec3::new(left.x * self.sign(), left.y, left.z)
    }

    /// The angles about X, Y and Z that do on this side what `left` does on the left.
    pub fn mirror_angles(self, left: [f64; 3]) -> [f64; 3] {
        [left[0], left[1] * self.sign(), left[2] * self.sign()]
    }

    /// The full joint name, for example `LeftFoot` for `Foot`.
    pub fn joint(self, name: &str) -> String {
        format!("{self:?}{name}")
    }
}

/// A joint of the table below. In a name, `*` stands for `Left` and `Right`: such a joint exists on both sides, and
/// offsets are those of the left one, in cm.
struct Bone {
    name: &'static str,
    parent: &'static str,
    offset: [f64; 3],
    /// Where the End Site stands, if the joint is the last of its limb.
    tip: Option<[f64; 3]>,
}

const fn bone(name: &'static str, parent: &'static str, offset: [f64; 3]) -> Bone {
    Bone { name, parent, offset, tip: None }
}

const fn last(name: &'static str, parent: &'static str, offset: [f64; 3], tip: [f64; 3]) -> Bone {
    Bone { name, parent, offset, tip: Some(tip) }
}

const LEG: [Bone; 4] = [
    bone("*UpLeg", "Hips", LEFT_HIP.to_array()),
    bone("*Leg", "*UpLeg", [0.0, -THIGH, 0.0]),
    bone("*Foot", "*Leg", [0.0, -SHANK, 0.0]),
    last("*ToeBase", "*Foot", BALL.to_array(), [0.0, -1.2, 7.4]),
];

const TRUNK: [Bone; 5] = [
    bone("Spine", "Hips", [0.0, 6.3, -1.0]),
    bone("Spine1", "Spine", [0.0, 12.0, -0.5]),
    bone("Spine2", "Spine1", [0.0, 12.0, 0.5]),
    bone("Neck", "Spine2", [0.0, 19.0, 0.5]),
    last("Head", "Neck", [0.0, 9.0, 1.2], [0.0, 19.0, 2.0]),
];

const ARM: [Bone; 7] = [
    bone("*Shoulder", "Spine2", [2.5, 13.5, 1.5]),
    bone("*Arm", "*Shoulder", [15.8, -0.8, -2.0]),
    bone("*ForeArm", "*Arm", [32.6, 0.0, 0.0]),
    bone("*Hand", "*ForeArm", [25.6, 0.0, 0.0]),
    last("*HandThumb1", "*Hand", [3.0, -0.8, 3.0], [4.6, -0.6, 3.2]),
    bone("*HandIndex1", "*Hand", [9.2, 0.0, 1.0]),
    last("*HandIndex2", "*HandIndex1", [4.4, 0.0, 0.0], [5.3, 0.0, 0.0]),
];

/// The humanoid's skeleton: 28 joints and 7 End Sites. `order` gives the three rotation axes of each joint, first
/// leftmost, from its name. Only the root `Hips` has position channels, in front of its rotations.
///
/// # Errors
///
/// When `order` names an axis twice.
pub fn skeleton(order: impl Fn(&str) -> [Axis; 3]) -> Result<Skeleton, SkeletonError> {
    let rotations = |name: &str| order(name).map(Channel::Rotation);
    let mut skeleton = Skeleton::new();
    let root = [Axis::ALL.map(Channel::Position), rotations("Hips")].concat();
    skeleton.add_joint(None, "Hips", Vec3::ZERO, root)?;
    let limbs = [
        (Side::Left, &LEG[..]),
        (Side::Right, &LEG),
        (Side::Left, &TRUNK),
        (Side::Left, &ARM),
        (Side::Right, &ARM),
    ];
    for (side, bones) in limbs {
        let sided = |name: &str| name.replace('*', &side.joint(""));
        let point = |left: [f64; 3]| side.mirror(DVec3::from_array(left)).as_vec3();
        for bone in bones {
            let name = sided(bone.name);
            let parent = named(&skeleton, &sided(bone.parent));
            let id = skeleton.add_joint(parent, &name, point(bone.offset), rotations(&name))?;
            if let Some(tip) = bone.tip {
                skeleton.add_end_site(id, "End Site", point(tip))?;
            }
        }
    }
    Ok(skeleton)
}

/// The joint with this name.
fn named(skeleton: &Skeleton, name: &str) -> Option<JointId> {
    skeleton.joints().iter().find(|joint| joint.name == name).map(|joint| joint.id)
}
