//! The upper body of the walker: trunk, head and arms.

use glam::DMat3;
use skeleton::Axis;

use super::figure::{ELBOW, bone_name};
use super::pelvis::Pelvis;
use super::recorder::{BoneRecorder, ORDER};
use crate::Error;
use crate::humanoid::Side;
use crate::math::{cos, from_euler, to_euler, turn, wobble};

/// Sets trunk, head and arms of the pose; `time` in seconds.
///
/// # Errors
///
/// When the skeleton is not the figure.
pub fn set(pose: &mut BoneRecorder, pelvis: &Pelvis, time: f64) -> Result<(), Error> {
    let chest = set_spine(pose, pelvis, time)?;
    set_head(pose, chest, time)?;
    for side in Side::BOTH {
        set_arm(pose, pelvis.phase, side, time)?;
    }
    Ok(())
}

/// The chest turns against the pelvis, half as far, and keeps upright above it (Stokes et al. 1989). Gives its global
/// rotation.
fn set_spine(pose: &mut BoneRecorder, pelvis: &Pelvis, time: f64) -> Result<DMat3, Error> {
    let wave = |peak: f64| cos(360.0 * (pelvis.phase - peak));
    let lean = 1.0 + 0.8 * cos(720.0 * (pelvis.phase - 0.05)) + 0.4 * wobble(51, time);
    let twist = (7.2 + 0.4 * wobble(52, time)) * wave(0.02);
    let list = -2.8 * wave(0.17);
    let mut rotation = pelvis.rotation;
    for (name, part) in [("lowerback", 0.4), ("upperback", 0.3), ("thorax", 0.3)] {
        let angles = [lean * part, twist * part, list * part];
        pose.set_angles(name, angles)?;
        rotation *= from_euler(ORDER, [angles[2], angles[1], angles[0]]);
    }
    Ok(rotation)
}

/// The head keeps still while the chest moves below it, and looks ahead.
fn set_head(pose: &mut BoneRecorder, chest: DMat3, time: f64) -> Result<(), Error> {
    let wanted =
        from_euler([Axis::Y, Axis::X, Axis::Z], [1.5 * wobble(53, time), 3.0 + wobble(54, time), 0.0]);
    let all = to_euler(chest.transpose() * wanted, ORDER, [0.0; 3]);
    let [z, y, x] = all.map(|angle| 0.3 * angle);
    for name in ["lowerneck", "upperneck"] {
        pose.set_angles(name, [x, y, z])?;
    }
    let neck = from_euler(ORDER, [z, y, x]);
    pose.set_rotation("head", (neck * neck).transpose() * from_euler(ORDER, all))
}

/// The arms hang and swing against the legs, farther back than forward, and the elbows bend as they come forward
/// (Murray, Sepic and Barnard 1967, "Patterns of sagittal rotation of the upper limbs in walking").
fn set_arm(pose: &mut BoneRecorder, phase: f64, side: Side, time: f64) -> Result<(), Error> {
    // The right arm does half a stride later what the left one does.
    let phase = phase + if side == Side::Left { 0.0 } else { 0.5 };
    let wave = |peak: f64| cos(360.0 * (phase - peak));
    let vary = wobble(55 + side as u32, time);
    let forward = -5.0 + (17.0 + vary) * wave(0.52);
    let elbow = 24.0 + 9.0 * wave(0.56) + vary;
    let away = 9.0 - 1.5 * wave(0.52);
    let name = |bone: &str| bone_name(bone, side);
    let mirrored = |left: [f64; 3]| side.mirror_angles(left);
    // Out of the T of the rest pose down to the side, and forward; then turned about its own length, so that the hinge of
    // the elbow lies across the way.
    let [x, y, z] = mirrored([-forward, -10.0, away - 90.0]);
    let upper_arm = from_euler(Axis::ALL, [x, y, z]) * turn(Axis::X, -ELBOW);
    pose.set_angles(&name("*clavicle"), mirrored([0.0, -2.5 * wave(0.52), 3.0]))?;
    pose.set_rotation(&name("*humerus"), upper_arm)?;
    pose.set_angles(&name("*radius"), [elbow, 0.0, 0.0])?;
    pose.set_angles(&name("*wrist"), mirrored([0.0, -14.0 + 4.0 * wave(0.55), 0.0]))?;
    pose.set_angles(&name("*hand"), mirrored([6.0 + 2.0 * vary, 0.0, -4.0]))?;
    pose.set_angles(&name("*fingers"), [24.0 + 2.0 * vary, 0.0, 0.0])?;
    pose.set_angles(&name("*thumb"), mirrored([10.0, 0.0, -12.0]))
}
