//! The figure that walks: its bones, their axes and what can move.
//!
//! The measures are those of the humanoid that runs (see the module `humanoid`), told in bones. The names are those of
//! motion-capture studios. At rest the figure faces +Z with its left at +X, the arms are stretched out to the sides, palms
//! down, and the legs stand apart by [`SPREAD`] each, turned at the hip as a whole.
//!
//! The bones of a limb lie along their own −Y axis, and where a limb is a hinge, this is its X axis. Limits are about those
//! that the American Academy of Orthopaedic Surgeons gives in "The clinical measurement of joint motion" (Greene and
//! Heckman 1994), rounded.

use glam::{DMat3, DVec3};
use skeleton::Axis::{self, X, Y, Z};
use skeleton::acclaim::{BoneData, BoneId, DegreeOfFreedom, LocalAxes, Root, Skeleton};
use skeleton::{Channel, RotationOrder};

use crate::Error;
use crate::humanoid::{BALL, LEFT_HIP, SHANK, Side, THIGH};
use crate::math::turn;

/// By how many degrees each leg stands away from the vertical at rest.
pub const SPREAD: f64 = 12.0;
/// By how many degrees the hinge of the elbow is turned about the upper arm at rest.
pub const ELBOW: f64 = -25.0;

/// A bone of the tables below. In a name, `*` stands for `l` and `r`: such a bone exists on both sides, and vectors and
/// angles are those of the left one.
struct Row {
    name: &'static str,
    parent: &'static str,
    /// From start to end at rest, in cm; of a leg as if it stood upright.
    vector: [f64; 3],
    /// The angles of `axis … XYZ`, in degrees.
    axis: [f64; 3],
    /// The axes about which the bone turns, and how far at least and at most, in degrees.
    dofs: &'static [(Axis, f64, f64)],
}

const fn row(
    name: &'static str,
    parent: &'static str,
    vector: [f64; 3],
    axis: [f64; 3],
    dofs: &'static [(Axis, f64, f64)],
) -> Row {
    Row { name, parent, vector, axis, dofs }
}

const UPRIGHT: [f64; 3] = [0.0, 0.0, SPREAD];
const FORWARD: [f64; 3] = [-90.0, 0.0, SPREAD];
const ARM_AXES: [f64; 3] = [180.0, ELBOW, -90.0];
const HAND_AXES: [f64; 3] = [0.0, 90.0, 90.0];

const LEG: [Row; 5] = [
    row("*hipjoint", "root", LEFT_HIP.to_array(), [0.0; 3], &[]),
    row(
        "*femur",
        "*hipjoint",
        [0.0, -THIGH, 0.0],
        UPRIGHT,
        &[(X, -120.0, 30.0), (Y, -45.0, 45.0), (Z, -45.0, 30.0)],
    ),
    row("*tibia", "*femur", [0.0, -SHANK, 0.0], UPRIGHT, &[(X, -5.0, 135.0)]),
    row("*foot", "*tibia", BALL.to_array(), FORWARD, &[(X, -30.0, 50.0), (Y, -35.0, 25.0)]),
    row("*toes", "*foot", [0.0, -1.2, 7.4], FORWARD, &[(X, -75.0, 40.0)]),
];

const TRUNK: [Row; 6] = [
    row(
        "lowerback",
        "root",
        [0.0, 14.0, -1.5],
        [0.0; 3],
        &[(X, -25.0, 60.0), (Y, -30.0, 30.0), (Z, -25.0, 25.0)],
    ),
    row(
        "upperback",
        "lowerback",
        [0.0, 14.0, -0.5],
        [0.0; 3],
        &[(X, -10.0, 30.0), (Y, -20.0, 20.0), (Z, -20.0, 20.0)],
    ),
    row(
        "thorax",
        "upperback",
        [0.0, 14.2, 1.5],
        [0.0; 3],
        &[(X, -10.0, 30.0), (Y, -20.0, 20.0), (Z, -20.0, 20.0)],
    ),
    row(
        "lowerneck",
        "thorax",
        [0.0, 7.5, 0.5],
        [0.0; 3],
        &[(X, -25.0, 45.0), (Y, -40.0, 40.0), (Z, -25.0, 25.0)],
    ),
    row(
        "upperneck",
        "lowerneck",
        [0.0, 8.2, 1.2],
        [0.0; 3],
        &[(X, -25.0, 45.0), (Y, -40.0, 40.0), (Z, -25.0, 25.0)],
    ),
    row(
        "head",
        "upperneck",
        [0.0, 19.4, 1.0],
        [0.0; 3],
        &[(X, -25.0, 45.0), (Y, -40.0, 40.0), (Z, -25.0, 25.0)],
    ),
];

const ARM: [Row; 7] = [
    row("*clavicle", "thorax", [18.0, 1.2, -2.5], [0.0; 3], &[(Y, -20.0, 15.0), (Z, -5.0, 30.0)]),
    row(
        "*humerus",
        "*clavicle",
        [32.6, 0.0, 0.0],
        ARM_AXES,
        &[(X, -90.0, 90.0), (Y, -90.0, 90.0), (Z, -60.0, 180.0)],
    ),
    row("*radius", "*humerus", [17.1, 0.0, 0.0], ARM_AXES, &[(X, -5.0, 150.0)]),
    row("*wrist", "*radius", [8.5, 0.0, 0.0], HAND_AXES, &[(Y, -90.0, 90.0)]),
    row("*hand", "*wrist", [9.2, 0.0, 1.0], HAND_AXES, &[(X, -70.0, 80.0), (Z, -30.0, 20.0)]),
    row("*fingers", "*hand", [9.7, 0.0, 0.0], HAND_AXES, &[(X, 0.0, 90.0)]),
    row("*thumb", "*wrist", [5.6, -1.4, 5.2], [-90.0, 47.0, 0.0], &[(X, -45.0, 45.0), (Z, -45.0, 45.0)]),
];

/// The skeleton: a root and 30 bones.
///
/// # Errors
///
/// When the tables above contradict each other.
pub fn figure() -> Result<Skeleton, Error> {
    let mut skeleton = Skeleton::new(Root::default())?;
    skeleton.name = String::from("walker");
    let limbs = [
        (Side::Left, &LEG[..]),
        (Side::Right, &LEG),
        (Side::Left, &TRUNK),
        (Side::Left, &ARM),
        (Side::Right, &ARM),
    ];
    for (side, rows) in limbs {
        let leg = if rows.len() == LEG.len() { turn(Z, SPREAD) } else { DMat3::IDENTITY };
        for row in rows {
            let parent = bone_name(row.parent, side);
            let parent = skeleton.find(&parent).ok_or(Error::UnknownBone(parent))?.id;
            add(&mut skeleton, parent, row, side, leg)?;
        }
    }
    Ok(skeleton)
}

/// `*femur` on the left is `lfemur`.
pub fn bone_name(name: &str, side: Side) -> String {
    name.replace('*', if side == Side::Left { "l" } else { "r" })
}

fn add(skeleton: &mut Skeleton, parent: BoneId, row: &Row, side: Side, leg: DMat3) -> Result<(), Error> {
    // The hip joint is on the pelvis and does not stand apart.
    let stance = if row.parent == "root" { DMat3::IDENTITY } else { leg };
    let vector = side.mirror(stance * DVec3::from_array(row.vector));
    let length = libm::round(vector.length() * 1e4) / 1e4;
    let direction =
        (vector / vector.length()).to_array().map(|part| (libm::round(part * 1e6) / 1e6 + 0.0) as f32);
    // Turns about Y and Z go the other way on the other side: least and most change places.
    let dof = |&(axis, low, high): &(Axis, f64, f64)| {
        let [one, other] = [low, high].map(|limit| side.mirror_angles([limit; 3])[axis.index()] as f32);
        DegreeOfFreedom { channel: Channel::Rotation(axis), low: one.min(other), high: one.max(other) }
    };
    skeleton.add_bone(
        parent,
        BoneData {
            name: bone_name(row.name, side),
            direction: direction.into(),
            length: length as f32,
            axis: LocalAxes {
                angles: side.mirror_angles(row.axis).map(|angle| (angle + 0.0) as f32),
                order: RotationOrder::Zyx,
            },
            dofs: row.dofs.iter().map(dof).collect(),
        },
    )?;
    Ok(())
}
