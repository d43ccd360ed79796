//! The leg: where a foot stands, and the joint angles that bring it there.

use glam::{DMat3, DVec3};
use skeleton::Axis;

use crate::Error;
use crate::humanoid::{BALL, HEEL, SHANK, Side, THIGH};
use crate::math::{from_euler, to_euler, turn};
use crate::recorder::Recorder;
use crate::spline::Spline;
use crate::two_bones::Bend;

/// Where a foot is.
#[derive(Clone, Copy, Debug)]
pub struct Foot {
    /// The ankle's global position, in cm.
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
    /// With a positive `pitch` (degrees) the heel is raised: the foot turns about its ball and the toes stay flat.
    /// With a negative one the toes are raised: the foot turns about its heel.
    pub fn standing(ball: DVec3, heading: f64, pitch: f64) -> Foot {
        let flat = turn(Axis::Y, heading);
        let rotation = flat * turn(Axis::X, pitch);
        if pitch >= 0.0 {
            Foot { ankle: ball - rotation * BALL, rotation, toes: -pitch }
        } else {
            let heel = ball + flat * (HEEL - BALL);
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

/// Points through which one angle of a swinging leg passes: (part of the swing, 0 to 1; degrees).
pub type Knots = Vec<(f64, f64)>;

impl LegAngles {
    /// The angles that put the foot in its place. `hip` is the hip joint's global position, `pelvis` the pelvis's
    /// global rotation; the knee points as near as possible to `knee_heading` (degrees about Y).
    pub fn reaching(hip: DVec3, pelvis: DMat3, foot: Foot, knee_heading: f64) -> LegAngles {
        let wanted_axis = turn(Axis::Y, knee_heading) * DVec3::X;
        let bend = Bend::reaching(hip, foot.ankle, [THIGH, SHANK], wanted_axis);
        let thigh = bend.upper_rotation(-1.0);
        let shank = thigh * turn(Axis::X, bend.degrees);
        LegAngles {
            thigh: to_euler(pelvis.transpose() * thigh, Axis::ALL, [0.0; 3]),
            knee: bend.degrees,
            foot: to_euler(shank.transpose() * foot.rotation, Axis::ALL, [0.0; 3]),
            toes: foot.toes,
        }
    }

    /// The angles at `time` of a leg that swings from one stand to the next, from `span[0]` to `span[1]` (seconds).
    ///
    /// `standing` gives the angles of the stand before for the first moment and of the one after for the last, and a
    /// little beside both. Every angle follows a smooth curve that takes over place and speed at one end, passes its
    /// `knots`, and hands place and speed over at the other. `knots` has one entry for each of the eight angles.
    pub fn swinging(
        span: [f64; 2],
        standing: [&dyn Fn(f64) -> LegAngles; 2],
        knots: [Knots; 8],
        time: f64,
    ) -> LegAngles {
        // Just long enough for a difference of angles to say a speed.
        const MOMENT: f64 = 1.0 / 480.0;
        let [leaving, arriving] = [0, 1].map(|end| {
            let angles = |time: f64| standing[end](time).to_array();
            let (before, after) = (angles(span[end] - MOMENT), angles(span[end] + MOMENT));
            let speeds: [f64; 8] = std::array::from_fn(|n| (after[n] - before[n]) / (2.0 * MOMENT));
            (angles(span[end]), speeds)
        });
        let mut knots = knots.into_iter();
        LegAngles::from_array(std::array::from_fn(|n| {
            let inner = knots.next().unwrap_or_default();
            let mut points = vec![(span[0], leaving.0[n])];
            points.extend(inner.iter().map(|(part, angle)| (span[0] + part * (span[1] - span[0]), *angle)));
            points.push((span[1], arriving.0[n]));
            Spline::clamped(&points, [leaving.1[n], arriving.1[n]]).at(time)
        }))
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

    /// All eight angles: thigh X, Y, Z, knee, foot X, Y, Z, toes.
    pub fn to_array(self) -> [f64; 8] {
        let ([a, b, c], [d, e, f]) = (self.thigh, self.foot);
        [a, b, c, self.knee, d, e, f, self.toes]
    }

    /// The reverse of [`LegAngles::to_array`].
    pub fn from_array([a, b, c, knee, d, e, f, toes]: [f64; 8]) -> LegAngles {
        LegAngles { thigh: [a, b, c], knee, foot: [d, e, f], toes }
    }
}
