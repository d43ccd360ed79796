//! The legs of the walker, by inverse kinematics.

use glam::{DMat3, DVec3};
use skeleton::Axis;

use super::figure::{SPREAD, bone_name};
use super::pelvis::Pelvis;
use super::recorder::{BoneRecorder, ORDER};
use super::steps::{Place, Steps};
use crate::Error;
use crate::humanoid::{SHANK, Side, THIGH};
use crate::math::{from_euler, to_euler, turn};
use crate::two_bones::Bend;

/// Sets one leg of the pose; `time` in seconds.
///
/// The hip has three dofs, the knee one and the ankle two: just as many as it takes to put a foot into any place, turned
/// in any way. The knee points where it must so that the ankle needs no third.
///
/// # Errors
///
/// When the skeleton is not the figure.
pub fn set(
    pose: &mut BoneRecorder,
    steps: &Steps,
    pelvis: &Pelvis,
    side: Side,
    time: f64,
) -> Result<(), Error> {
    let place = steps.at(side, time);
    let leg = Leg::reaching(pelvis.hip(side), &place);
    // At rest the leg stands apart; its axes do so with it.
    let rest = turn(Axis::Z, side.sign() * SPREAD);
    let name = |bone: &str| bone_name(bone, side);
    pose.set_rotation(&name("*femur"), pelvis.rotation.transpose() * leg.thigh * rest.transpose())?;
    pose.set_angles(&name("*tibia"), [leg.knee, 0.0, 0.0])?;
    // The foot's own Y points back, along −Z of the leg.
    let [roll, _, flexion] = leg.ankle;
    pose.set_angles(&name("*foot"), [flexion, -roll, 0.0])?;
    pose.set_angles(&name("*toes"), [place.toes, 0.0, 0.0])
}

struct Leg {
    /// The global rotation of a thigh that points down along its own −Y.
    thigh: DMat3,
    /// The bend of the knee, in degrees.
    knee: f64,
    /// The angles of the foot against the shank about Z, Y and X, in degrees; the one about Y is zero.
    ankle: [f64; 3],
}

impl Leg {
    /// The leg from a hip joint to a foot.
    fn reaching(hip: DVec3, place: &Place) -> Leg {
        // By how much the ankle would have to turn about Y falls nearly as the knee turns.
        let mut heading = place.heading;
        let mut leg = Leg::with_knee(hip, place, heading);
        for _ in 0..40 {
            heading += leg.ankle[1];
            leg = Leg::with_knee(hip, place, heading);
        }
        leg
    }

    /// The leg whose knee points as near as possible to `heading`, in degrees about Y.
    fn with_knee(hip: DVec3, place: &Place, heading: f64) -> Leg {
        let foot = from_euler([Axis::Y, Axis::X, Axis::Z], [place.heading, place.pitch, 0.0]);
        let bend = Bend::reaching(hip, place.ankle, [THIGH, SHANK], turn(Axis::Y, heading) * DVec3::X);
        let thigh = bend.upper_rotation(-1.0);
        let shank = thigh * turn(Axis::X, bend.degrees);
        let ankle = to_euler(shank.transpose() * foot, ORDER, [0.0; 3]);
        Leg { thigh, knee: bend.degrees, ankle }
    }
}
