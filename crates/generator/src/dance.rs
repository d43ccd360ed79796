//! `dance.bvh`: a double pirouette, a side lunge, circling arms and a high kick.
//!
//! The motion is made for questions about interpolation. The hips turn by two full turns, and their angle about Y
//! grows to 720° and more. The left arm's angle about X runs on past −360°. The right arm makes a full circle too,
//! but its angles are stored within ±180°, as recording programs often do, and jump where they pass it.
//! Neighbouring joints have different rotation orders.
//!
//! The dancer was put together by eye from the steps as ballet teaches them: preparation with bent knees, rise to
//! the ball of the foot, the free foot at the knee (passé), the head that looks at one point as long as it can and
//! whips round (spotting), and a grand battement. While a foot stands, inverse kinematics holds it in place.

use glam::{DMat3, DVec3};
use skeleton::{Axis, Motion, RotationOrder};

use crate::Error;
use crate::humanoid::{BALL_HEIGHT, LEFT_HIP, Side, skeleton};
use crate::leg::{Foot, Knots, LegAngles};
use crate::math::{acos, from_euler, sin, to_euler, turn};
use crate::recorder::Recorder;
use crate::spline::Spline;

/// How many frames the dance has.
const FRAMES: usize = 141;
/// The seconds between two frames.
const FRAME_TIME: f64 = 0.033333;

/// The dance: 141 frames at 30 per second, in cm.
///
/// # Errors
///
/// None, unless the tables of this crate contradict each other.
pub fn dance() -> Result<Motion, Error> {
    let mut pose = Recorder::new(skeleton(order)?);
    pose.wrap("RightArm")?;
    for frame in 0..FRAMES {
        set_pose(frame as f64 * FRAME_TIME, &mut pose)?;
        pose.push_frame();
    }
    pose.finish(FRAME_TIME)
}

/// The rotation order of each joint. All six occur.
fn order(joint: &str) -> [Axis; 3] {
    let order = match joint.trim_start_matches("Left").trim_start_matches("Right") {
        // The turn about the vertical comes first: it may grow without end.
        "Hips" | "Neck" | "Foot" => RotationOrder::Yxz,
        "Spine" | "Spine1" | "Spine2" | "Shoulder" => RotationOrder::Zxy,
        "ForeArm" | "Head" => RotationOrder::Yzx,
        "Hand" | "ToeBase" => RotationOrder::Xzy,
        "UpLeg" => RotationOrder::Zyx,
        "Arm" if joint == "RightArm" => RotationOrder::Zxy,
        _ => RotationOrder::Xyz,
    };
    order.axes().unwrap_or(Axis::ALL)
}

/// The moments of the dance, in seconds, and below what every part of the body does at them. In between it moves
/// smoothly.
#[rustfmt::skip]
const MOMENTS: [f64; 9] =
    // start  prepare  risen  turned  lunge  push off  kick   down  end
    [  0.0,    0.5,    0.95,  2.15,   2.7,    3.25,    3.75,  4.25, 4.7];

/// One value for each of the moments.
type Row = [f64; 9];

/// A foot that stands: from when to when (seconds), where the ball of the foot is (cm), and where the toes point
/// and how far the heel is raised (degrees).
struct Stand {
    from: f64,
    to: f64,
    ball: DVec3,
    heading: Row,
    pitch: Row,
}

/// One leg's part: it stands, swings, and stands again.
struct LegPart {
    side: Side,
    stands: [Stand; 2],
    /// The points that the swing passes.
    knots: fn() -> [Knots; 8],
}

/// The middle between the hip joints, in cm: X, Y, Z.
const HIPS: [Row; 3] = [
    [2.0, 0.0, -8.0, -8.0, 12.0, 20.0, 23.0, 22.0, 22.0],
    [88.0, 77.0, 100.1, 100.1, 74.0, 89.5, 92.0, 89.0, 91.0],
    [-4.0, -2.0, 13.0, 13.0, 8.0, -1.0, 0.0, 1.0, 1.0],
];
/// Where the hips face, and how far they tilt forward and to the right, in degrees.
const YAW: Row = [8.0, -24.0, 100.0, 650.0, 728.0, 712.0, 718.0, 722.0, 724.0];
const TILT_FORWARD: Row = [0.0, 5.0, 0.0, 0.0, 6.0, 4.0, -16.0, -4.0, -6.0];
const TILT_RIGHT: Row = [0.0, 1.0, 3.0, 3.0, -4.0, 0.0, -5.0, 0.0, 0.0];
/// The trunk's angles about X, Y and Z, which the spine shares.
const TRUNK: [Row; 3] = [
    [0.0, 6.0, -2.0, -2.0, 10.0, -6.0, 14.0, -14.0, -20.0],
    [0.0, -32.0, 12.0, 8.0, -16.0, 14.0, -2.0, 0.0, 10.0],
    [0.0, 0.0, 0.0, 0.0, 18.0, -8.0, 2.0, 0.0, -8.0],
];
/// The upper arms' angles about X, Y and Z, and the bends of the elbows.
const LEFT_ARM: [Row; 4] = [
    [0.0, 0.0, 0.0, 0.0, 15.0, -150.0, -390.0, -480.0, -512.0],
    [-10.0, -10.0, -68.0, -68.0, -5.0, -8.0, -10.0, -12.0, -14.0],
    [-62.0, -18.0, -32.0, -32.0, -20.0, -68.0, -68.0, -72.0, -76.0],
    [28.0, 14.0, 62.0, 62.0, 10.0, 12.0, 14.0, 18.0, 24.0],
];
const RIGHT_ARM: [Row; 4] = [
    [0.0; 9],
    [10.0, 62.0, 68.0, 68.0, 8.0, 34.0, 34.0, 24.0, 14.0],
    [62.0, 36.0, 32.0, 32.0, 12.0, 180.0, 368.0, 330.0, 296.0],
    [28.0, 58.0, 62.0, 62.0, 10.0, 14.0, 16.0, 20.0, 26.0],
];
/// The left leg pushes off from behind, is drawn up to the other knee, and is put down to the side.
const LEFT_LEG: LegPart = LegPart {
    side: Side::Left,
    stands: [
        Stand {
            from: 0.0,
            to: 0.72,
            ball: DVec3::new(14.0, BALL_HEIGHT, -20.0),
            heading: [48.0; 9],
            pitch: [8.0, 12.0, 75.0, 75.0, 75.0, 75.0, 75.0, 75.0, 75.0],
        },
        Stand {
            from: 2.42,
            to: f64::INFINITY,
            ball: DVec3::new(38.0, BALL_HEIGHT, 8.0),
            heading: [765.0; 9],
            pitch: [30.0, 30.0, 30.0, 30.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        },
    ],
    knots: passe,
};
/// On the ball of the right foot the dancer turns. Then the leg pushes off, kicks, and is put down pointed, in front.
const RIGHT_LEG: LegPart = LegPart {
    side: Side::Right,
    stands: [
        Stand {
            from: 0.0,
            to: 3.2,
            ball: DVec3::new(-8.0, BALL_HEIGHT, 14.0),
            heading: [-25.0, -25.0, 75.0, 625.0, 695.0, 695.0, 695.0, 695.0, 695.0],
            pitch: [0.0, 0.0, 48.0, 48.0, 0.0, 42.0, 60.0, 60.0, 60.0],
        },
        Stand {
            from: 4.25,
            to: f64::INFINITY,
            ball: DVec3::new(14.0, BALL_HEIGHT, 46.0),
            heading: [700.0; 9],
            pitch: [52.0, 52.0, 52.0, 52.0, 52.0, 52.0, 52.0, 52.0, 42.0],
        },
    ],
    knots: kick,
};

/// The value of a row at `time`, in seconds.
fn at(row: &Row, time: f64) -> f64 {
    Spline::held(&MOMENTS, row).at(time)
}

fn set_pose(time: f64, pose: &mut Recorder) -> Result<(), Error> {
    let (hips, position) = hips(time);
    pose.set_position("Hips", position)?;
    pose.set_angles("Hips", [at(&TILT_FORWARD, time), at(&YAW, time), at(&TILT_RIGHT, time)])?;
    for part in [&LEFT_LEG, &RIGHT_LEG] {
        leg(part, time).set(pose, part.side)?;
    }
    set_trunk_and_head(hips, time, pose)?;
    set_arm(Side::Left, &LEFT_ARM, time, pose)?;
    set_arm(Side::Right, &RIGHT_ARM, time, pose)
}

/// The rotation of the hips and the position of the joint `Hips`.
fn hips(time: f64) -> (DMat3, DVec3) {
    let angles = [at(&YAW, time), at(&TILT_FORWARD, time), at(&TILT_RIGHT, time)];
    let rotation = from_euler([Axis::Y, Axis::X, Axis::Z], angles);
    let middle = DVec3::from_array(HIPS.map(|row| at(&row, time)));
    (rotation, middle - rotation * DVec3::new(0.0, LEFT_HIP.y, 0.0))
}

fn leg(part: &LegPart, time: f64) -> LegAngles {
    let standing = |stand: &Stand, time: f64| {
        let (rotation, position) = hips(time);
        let heading = at(&stand.heading, time);
        let foot = Foot::standing(stand.ball, heading, at(&stand.pitch, time));
        LegAngles::reaching(position + rotation * part.side.mirror(LEFT_HIP), rotation, foot, heading)
    };
    let [before, after] = &part.stands;
    if time < before.to {
        standing(before, time)
    } else if time >= after.from {
        standing(after, time)
    } else {
        let ends: [&dyn Fn(f64) -> LegAngles; 2] =
            [&|time| standing(before, time), &|time| standing(after, time)];
        LegAngles::swinging([before.to, after.from], ends, (part.knots)(), time)
    }
}

fn set_trunk_and_head(hips: DMat3, time: f64, pose: &mut Recorder) -> Result<(), Error> {
    let trunk = TRUNK.map(|row| at(&row, time));
    let mut chest = hips;
    for (name, part) in [("Spine", 0.3), ("Spine1", 0.35), ("Spine2", 0.35)] {
        let [x, y, z] = trunk.map(|angle| angle * part);
        pose.set_angles(name, [x, y, z])?;
        chest *= from_euler([Axis::Z, Axis::X, Axis::Y], [z, x, y]);
    }
    // Spotting: where the dancer faces the front the head stands still, and behind it turns twice as fast as the
    // body.
    let yaw = at(&YAW, time);
    let wanted = turn(Axis::Y, yaw - sin(yaw).to_degrees()) * turn(Axis::X, 0.3 * trunk[0] - 3.0);
    let both = to_euler(chest.transpose() * wanted, [Axis::Y, Axis::X, Axis::Z], [0.0; 3]);
    let neck = from_euler([Axis::Y, Axis::X, Axis::Z], both.map(|angle| 0.4 * angle));
    pose.set_rotation("Neck", neck)?;
    pose.set_rotation("Head", neck.transpose() * chest.transpose() * wanted)
}

fn set_arm(side: Side, rows: &[Row; 4], time: f64, pose: &mut Recorder) -> Result<(), Error> {
    let [x, y, z, elbow] = rows.map(|row| at(&row, time));
    pose.set_angles(&side.joint("Arm"), [x, y, z])?;
    let mut set = |name: &str, left: [f64; 3]| pose.set_angles(&side.joint(name), side.mirror_angles(left));
    set("Shoulder", [0.0, 0.0, 4.0])?;
    set("ForeArm", [0.0, -elbow, 0.0])?;
    set("Hand", [-20.0, -8.0, -6.0])?;
    set("HandThumb1", [0.0, 14.0, -10.0])?;
    set("HandIndex1", [0.0, 0.0, -10.0])?;
    set("HandIndex2", [0.0, 0.0, -14.0])
}

/// The left leg in the turn: thigh to the side and turned out, the toes at the other knee.
fn passe() -> [Knots; 8] {
    // The thigh points forward, down and to the side; the shank from there back to the other knee.
    let (thigh, shank) =
        (DVec3::new(0.72, -0.45, 0.53).normalize(), DVec3::new(-0.80, -0.60, -0.15).normalize());
    let axis = thigh.cross(shank).normalize();
    let rotation = DMat3::from_cols(axis, -thigh, axis.cross(-thigh));
    let [x, y, z] = to_euler(rotation, Axis::ALL, [0.0; 3]);
    let hold = |angle: f64| [0.17, 0.26, 0.4, 0.6, 0.74, 0.83].map(|part| (part, angle)).to_vec();
    // The foot is pointed until it comes near the ground.
    let foot = vec![(0.17, 42.0), (0.4, 42.0), (0.7, 42.0), (0.86, 20.0)];
    [hold(x), hold(y), hold(z), hold(acos(thigh.dot(shank))), foot, hold(0.0), hold(0.0), hold(6.0)]
}

/// The right leg's grand battement: up in front, straight, with a pointed foot.
fn kick() -> [Knots; 8] {
    let up = |angles: [f64; 3]| vec![(0.2, angles[0]), (0.5, angles[1]), (0.8, angles[2])];
    [
        up([-42.0, -112.0, -62.0]),
        up([-12.0, -12.0, -10.0]),
        up([-2.0, 4.0, 0.0]),
        up([58.0, 8.0, 12.0]),
        up([2.0, 46.0, 44.0]),
        vec![(0.5, 0.0)],
        vec![(0.5, 0.0)],
        up([-14.0, 10.0, 4.0]),
    ]
}
