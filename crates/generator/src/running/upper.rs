//! The upper body of the runner: trunk, head and arms.

use glam::DMat3;
use skeleton::Axis;

use super::course::Moment;
use super::pelvis::Pelvis;
use crate::Error;
use crate::humanoid::Side;
use crate::math::{cos, from_euler, to_euler, wobble};
use crate::recorder::Recorder;

/// Sets trunk, head and arms of the pose; `time` in seconds.
///
/// # Errors
///
/// When the skeleton is not the humanoid.
pub fn set(pose: &mut Recorder, now: &Moment, pelvis: &Pelvis, time: f64) -> Result<(), Error> {
    let chest = set_spine(pose, now, pelvis, time)?;
    set_head(pose, now, chest, time)?;
    for side in Side::BOTH {
        set_arm(pose, now, side, time)?;
    }
    Ok(())
}

/// The trunk leans forward by about 8° and turns against the pelvis. Gives the chest's global rotation.
fn set_spine(pose: &mut Recorder, now: &Moment, pelvis: &Pelvis, time: f64) -> Result<DMat3, Error> {
    let wave = |peak: f64| cos(360.0 * (now.phase - peak));
    let lean = 12.0 + 1.0 * now.effort() + 1.0 * cos(720.0 * (now.phase - 0.18)) + 0.5 * wobble(21, time);
    let twist = -(15.0 + wobble(22, time)) * wave(0.40);
    let list = -4.0 * wave(0.14) - 0.4 * now.lean;
    let mut rotation = pelvis.rotation;
    for (name, part) in [("Spine", 0.4), ("Spine1", 0.3), ("Spine2", 0.3)] {
        let angles = [lean * part, twist * part, list * part];
        pose.set_angles(name, angles)?;
        rotation *= from_euler(Axis::ALL, angles);
    }
    Ok(rotation)
}

/// The head stays nearly still while the chest moves below it, and looks where the runner goes.
fn set_head(pose: &mut Recorder, now: &Moment, chest: DMat3, time: f64) -> Result<(), Error> {
    let ahead = now.heading + 0.35 * now.lean + 2.0 * wobble(23, time);
    let nod = 4.0 + 1.2 * cos(720.0 * (now.phase - 0.3)) + wobble(24, time);
    let tilt = -0.4 * now.lean;
    let wanted = from_euler([Axis::Y, Axis::X, Axis::Z], [ahead, nod, tilt]);
    let both = to_euler(chest.transpose() * wanted, Axis::ALL, [0.0; 3]);
    let neck = both.map(|angle| 0.5 * angle);
    let head = from_euler(Axis::ALL, neck).transpose() * from_euler(Axis::ALL, both);
    pose.set_angles("Neck", neck)?;
    pose.set_rotation("Head", head)
}

/// The arms swing against the legs, elbows bent.
///
/// Each goes forward with the opposite leg and is driven by the turning chest (Pontzer et al. 2009, "Control and
/// function of arm swing in human walking and running"). The elbow closes a little as the hand comes forward.
fn set_arm(pose: &mut Recorder, now: &Moment, side: Side, time: f64) -> Result<(), Error> {
    // The right arm does half a stride later what the left one does.
    let phase = now.phase + if side == Side::Left { 0.0 } else { 0.5 };
    let wave = |peak: f64| cos(360.0 * (phase - peak));
    let vary = wobble(30 + side as u32, time);
    let swing = (23.0 + 4.0 * now.effort() + 1.5 * vary) * wave(0.31) + 2.5 * cos(720.0 * (phase - 0.31));
    let forward = swing - 14.0;
    let elbow = 100.0 + 13.0 * wave(0.33) + 2.0 * vary;
    let inwards = 14.0 + 10.0 * wave(0.33);
    let away = 17.0 - 4.0 * wave(0.31);
    let mut set = |name: &str, left: [f64; 3]| pose.set_angles(&side.joint(name), side.mirror_angles(left));
    set("Shoulder", [0.0, -5.0 * wave(0.31) - 2.0, 3.0])?;
    set("Arm", [-forward, -inwards, away - 90.0])?;
    set("ForeArm", [0.0, -elbow, 0.0])?;
    set("Hand", [-70.0, 6.0 * wave(0.45), 5.0 * wave(0.4)])?;
    set("HandThumb1", [0.0, 12.0, -25.0])?;
    set("HandIndex1", [0.0, 0.0, -55.0 - 2.0 * vary])?;
    set("HandIndex2", [0.0, 0.0, -65.0])
}
