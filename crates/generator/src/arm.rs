//! `arm.bvh`: a robot arm on a rail picks a part up, screws it in elsewhere and goes home.
//!
//! It is no human: it has a slide, which moves without turning, fingers that move and could turn, and all six
//! rotation orders. Its measures are our own, those of a middling industrial arm. Y is up, the unit is the
//! centimetre. At rest it points straight up.

use glam::{DMat3, DVec3, Vec3};
use skeleton::{Axis, Channel, Motion, RotationOrder, Skeleton};

use crate::Error;
use crate::math::{atan2, cos, sin, turn};
use crate::recorder::Recorder;
use crate::spline::Spline;
use crate::two_bones::Bend;

/// How many frames the work takes: a little over six seconds.
const FRAMES: usize = 376;
/// The seconds between two frames.
const FRAME_TIME: f64 = 0.016667;

/// The direction in which the rail runs: the pedestal's heading in degrees.
const RAIL_HEADING: f64 = 20.0;
/// From the pedestal to the slide at its zero.
const SLIDE: DVec3 = DVec3::new(0.0, 14.0, 0.0);
/// From the slide to the turret, and from there to the shoulder.
const TURRET: DVec3 = DVec3::new(0.0, 10.0, 0.0);
const SHOULDER: DVec3 = DVec3::new(0.0, 18.0, 0.0);
const UPPER_ARM: f64 = 46.0;
const FOREARM: f64 = 42.0;
/// From the wrist to the gripper, and from there to the point between the finger tips.
const GRIPPER: f64 = 9.0;
const GRIP: f64 = 13.0;

/// The arm: 376 frames at 60 per second, in cm.
///
/// # Errors
///
/// None, unless the tables of this crate contradict each other.
pub fn arm() -> Result<Motion, Error> {
    let mut pose = Recorder::new(skeleton()?);
    for frame in 0..FRAMES {
        set_pose(frame as f64 * FRAME_TIME, &mut pose)?;
        pose.push_frame();
    }
    pose.finish(FRAME_TIME)
}

/// Nine joints. Every order occurs; `Slide` has a position channel and nothing else, the fingers have all six
/// channels with the rotations in front.
fn skeleton() -> Result<Skeleton, Error> {
    let positions = || Axis::ALL.map(Channel::Position).to_vec();
    let rotations = |order: RotationOrder| order.axes().unwrap_or(Axis::ALL).map(Channel::Rotation).to_vec();
    let up = |height: f64| Vec3::new(0.0, height as f32, 0.0);
    let mut skeleton = Skeleton::new();
    let root = [positions(), rotations(RotationOrder::Zxy)].concat();
    let mut last = skeleton.add_joint(None, "Pedestal", Vec3::ZERO, root)?;
    // The OFFSET along the rail is where the slide stands when the arm is switched off.
    let parked = SLIDE.as_vec3() + Vec3::new(0.0, 0.0, -45.0);
    let slide = vec![Channel::Position(Axis::Z)];
    last = skeleton.add_joint(Some(last), "Slide", parked, slide)?;
    for (name, offset, order) in [
        ("Turret", TURRET.as_vec3(), RotationOrder::Yxz),
        ("Shoulder", SHOULDER.as_vec3(), RotationOrder::Xzy),
        ("Elbow", up(UPPER_ARM), RotationOrder::Xyz),
        ("Wrist", up(FOREARM), RotationOrder::Yzx),
        ("Gripper", up(GRIPPER), RotationOrder::Yxz),
    ] {
        last = skeleton.add_joint(Some(last), name, offset, rotations(order))?;
    }
    for (name, side) in [("LeftFinger", 1.0), ("RightFinger", -1.0)] {
        let channels = [rotations(RotationOrder::Zyx), positions()].concat();
        let finger = skeleton.add_joint(Some(last), name, Vec3::new(side * 2.0, 5.0, 0.0), channels)?;
        skeleton.add_end_site(finger, "End Site", up(GRIP - 5.0))?;
    }
    Ok(skeleton)
}

/// The moments of the work, in seconds, and below what is wanted at them. In between all moves smoothly.
#[rustfmt::skip]
const MOMENTS: [f64; 11] =
    // home  above  at it  held  lifted  carried  set  screwed  let go  clear  home
    [  0.0,  1.1,   1.6,   1.95,  2.5,    3.5,    4.0,  4.75,    5.05,  5.45,  6.2];

/// One value for each of the moments.
type Row = [f64; 11];

/// The point between the finger tips, in cm, along X, Y and Z of the pedestal.
const TIP: [Row; 3] = [
    [0.0, 38.0, 38.0, 38.0, 36.0, -46.0, -46.0, -46.0, -46.0, -46.0, 0.0],
    [62.0, 24.0, 6.0, 6.0, 38.0, 34.0, 13.0, 9.0, 9.0, 28.0, 62.0],
    [20.0, -2.0, -2.0, -2.0, -2.0, 52.0, 52.0, 52.0, 52.0, 52.0, 20.0],
];
/// Where the slide stands on the rail, in cm.
const SLIDE_PLACE: Row = [-45.0, -38.0, -38.0, -38.0, -38.0, 30.0, 30.0, 30.0, 30.0, 24.0, -45.0];
/// By how many degrees the gripper tilts out of the vertical; negative is forward.
const TILT: Row = [-55.0, 0.0, 0.0, 0.0, -15.0, 0.0, 0.0, 0.0, 0.0, 0.0, -55.0];
/// The gripper's turn about its own axis, in degrees: it grows past a full turn.
const SCREW: Row = [0.0, 35.0, 35.0, 35.0, 35.0, 35.0, 40.0, 560.0, 575.0, 575.0, 540.0];
/// By how many degrees the elbow leans to the side.
const SWIVEL: Row = [0.0, 30.0, 30.0, 30.0, 20.0, -36.0, -36.0, -36.0, -36.0, -30.0, 0.0];
/// The distance of each finger from the gripper's middle, in cm.
const OPENING: Row = [2.0, 4.5, 4.5, 2.4, 2.4, 2.4, 2.4, 2.4, 4.2, 4.2, 2.0];
/// By how many degrees the fingers give way at their roots as they hold.
const GIVE: Row = [0.0, 0.0, 0.0, 4.0, 4.0, 4.0, 4.0, 4.0, 0.0, 0.0, 0.0];

/// The value of a row at `time`, in seconds.
fn at(row: &Row, time: f64) -> f64 {
    Spline::held(&MOMENTS, row).at(time)
}

fn set_pose(time: f64, pose: &mut Recorder) -> Result<(), Error> {
    let slide = DVec3::new(0.0, SLIDE.y, at(&SLIDE_PLACE, time));
    // All from here on is in the pedestal's axes, from its foot.
    let tip = DVec3::from_array(TIP.map(|row| at(&row, time)));
    let turret_foot = slide + TURRET;
    let shoulder = turret_foot + SHOULDER;
    let heading = atan2(tip.x - turret_foot.x, tip.z - turret_foot.z);
    let turret = turn(Axis::Y, heading);
    // The gripper points down: a half turn about X.
    let down = turret * turn(Axis::X, 180.0 + at(&TILT, time));
    let wrist = tip - down * DVec3::Y * (GRIPPER + GRIP);
    let swivel = at(&SWIVEL, time);
    let elbow_axis = turret * DVec3::new(cos(swivel), sin(swivel), 0.0);
    let bend = Bend::reaching(shoulder, wrist, [UPPER_ARM, FOREARM], elbow_axis);
    let upper_arm = bend.upper_rotation(1.0);
    let forearm: DMat3 = upper_arm * turn(Axis::X, bend.degrees);

    pose.set_angles("Pedestal", [0.0, RAIL_HEADING, 0.0])?;
    pose.set_position("Slide", slide)?;
    pose.set_angles("Turret", [0.0, heading, 0.0])?;
    pose.set_rotation("Shoulder", turret.transpose() * upper_arm)?;
    pose.set_angles("Elbow", [bend.degrees, 0.0, 0.0])?;
    pose.set_rotation("Wrist", forearm.transpose() * down)?;
    pose.set_angles("Gripper", [0.0, at(&SCREW, time), 0.0])?;
    for (finger, side) in [("LeftFinger", 1.0), ("RightFinger", -1.0)] {
        pose.set_position(finger, DVec3::new(side * at(&OPENING, time), 5.0, 0.0))?;
        pose.set_angles(finger, [0.0, 0.0, side * at(&GIVE, time)])?;
    }
    Ok(())
}
