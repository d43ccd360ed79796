//! Inverse kinematics of the leg: the joint angles that bring the foot where it should be.
//!
//! A leg has two bones of fixed length between the hip and the ankle. Where both ends are given, the knee's angle
//! follows from the law of cosines, and only the direction in which the knee points is free.

use glam::{DMat3, DVec3};
use skeleton::Axis;

use crate::Error;
use crate::humanoid::{ANKLE_HEIGHT, BALL, BALL_HEIGHT, HEEL, SHANK, Side, THIGH};
use crate::math::{acos, from_euler, to_euler, turn};
use crate::recorder::Recorder;

/// Where a foot is: the ankle's position in cm, and the foot's global rotation.
#[derive(Clone, Copy, Debug)]
pub struct Foot {
    /// The ankle's global position.
    pub ankle: DVec3,
    /// The foot's global rotation.
    pub rotation: DMat3,
    /// The toes' angle about X against the foot, in degrees; negative is bent upwards.
    pub toes: f64,
}

impl Foot {
    /// A foot that stands on level ground. `ball` is the ball of the foot when the sole lies flat; `heading` is the
    /// direction of the toes (degrees about Y, 0 is +Z).
    ///
    /// With a positive `pitch` (degrees) the heel is raised: the foot turns about its ball and the toes stay flat. With
    /// a negative one the toes are raised: the foot turns about its heel.
    pub fn standing(ball: DVec3, heading: f64, pitch: f64) -> Foot {
        let rotation = turn(Axis::Y, heading) * turn(Axis::X, pitch);
        let flat_ankle = ball - turn(Axis::Y, heading) * BALL;
        if pitch >= 0.0 {
            Foot { ankle: ball - rotation * BALL, rotation, toes: -pitch }
        } else {
            let heel = flat_ankle + turn(Axis::Y, heading) * HEEL;
            Foot { ankle: heel - rotation * HEEL, rotation, toes: 0.0 }
        }
    }
}

/// The angles of a leg in degrees: thigh and foot about X, Y and Z in this order, knee and toes about X.
///
/// A thigh swung forward, a foot or toes bent up towards the shin are negative; a bent knee is positive.
#[derive(Clone, Copy, Debug, Default)]
pub struct LegAngles {
    /// The thigh against the pelvis.
    pub thigh: [f64; 3],
    /// The shank against the thigh.
    pub knee: f64,
    /// The foot against the shank.
    pub foot: [f64; 3],
    /// The toes against the foot.
    pub toes: f64,
}

impl LegAngles {
    /// The angles that put the foot in its place. `hip` is the hip joint's global position, `pelvis` the pelvis's
    /// global rotation; the knee points as near as possible to `knee_heading` (degrees about Y).
    ///
    /// A foot out of reach is reached for with a leg that is not quite straight.
    pub fn reaching(hip: DVec3, pelvis: DMat3, foot: Foot, knee_heading: f64) -> LegAngles {
        let to_ankle = foot.ankle - hip;
        let distance = to_ankle.length().min(0.9995 * (THIGH + SHANK));
        let down = to_ankle.normalize();
        // The knee's axis: at right angles to the line from hip to ankle, as near as possible to the wanted one.
        let wanted = turn(Axis::Y, knee_heading) * DVec3::X;
        let axis = (wanted - wanted.dot(down) * down).normalize();
        let forward = down.cross(axis);
        let corner =
            |a: f64, b: f64, opposite: f64| acos((a * a + b * b - opposite * opposite) / (2.0 * a * b));
        let at_hip = corner(THIGH, distance, SHANK).to_radians();
        let knee = 180.0 - corner(THIGH, SHANK, distance);
        let along = libm::cos(at_hip) * down + libm::sin(at_hip) * forward;
        let thigh = DMat3::from_cols(axis, -along, axis.cross(-along));
        let shank = thigh * turn(Axis::X, knee);
        LegAngles {
            thigh: to_euler(pelvis.transpose() * thigh, Axis::ALL, [0.0; 3]),
            knee,
            foot: to_euler(shank.transpose() * foot.rotation, Axis::ALL, [0.0; 3]),
            toes: foot.toes,
        }
    }

    /// Sets the leg of the pose on one side.
    ///
    /// # Errors
    ///
    /// When the skeleton is not the humanoid.
    pub fn set(&self, pose: &mut Recorder, side: Side) -> Result<(), Error> {
        pose.set_rotation(&side.joint("UpLeg"), from_euler(Axis::ALL, self.thigh))?;
        pose.set_angles(&side.joint("Leg"), [self.knee, 0.0, 0.0])?;
        pose.set_rotation(&side.joint("Foot"), from_euler(Axis::ALL, self.foot))?;
        pose.set_angles(&side.joint("ToeBase"), [self.toes, 0.0, 0.0])
    }

    /// All eight angles, thigh first.
    pub fn to_array(self) -> [f64; 8] {
        let ([a, b, c], [d, e, f]) = (self.thigh, self.foot);
        [a, b, c, self.knee, d, e, f, self.toes]
    }

    /// The reverse of [`LegAngles::to_array`].
    pub fn from_array([a, b, c, knee, d, e, f, toes]: [f64; 8]) -> LegAngles {
        LegAngles { thigh: [a, b, c], knee, foot: [d, e, f], toes }
    }
}

/// The ball of a foot that stands flat with its ankle above the ground point (x, z).
pub fn ball_below(x: f64, z: f64, heading: f64) -> DVec3 {
    DVec3::new(x, ANKLE_HEIGHT, z) + turn(Axis::Y, heading) * BALL
}
const _: f64 = BALL_HEIGHT;
