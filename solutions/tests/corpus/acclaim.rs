//! Acclaim files: skeletons, and motions of them.
//!
//! Positions are computed here in two ways that must agree: bone by bone about the world's axes, and bone by bone in
//! each one's own axes; and a third time by the reference solution, after the bones have become joints.

use std::fs;
use std::path::Path;

use glam::{Quat, Vec3};
use parser::acclaim::{self, FileError};
use serde::Deserialize;
use skeleton::acclaim::{Bone, Motion, Posture, Root, Skeleton};
use skeleton::{Axis, Pose, pose_frame};

use super::{POSITION_TOLERANCE, Reading, Worst, distance, has_extension, larger, refused, same};

/// The farthest that the two ways of computing positions may be apart, as a part of the skeleton's extent.
const FORMULATION_TOLERANCE: f32 = 1e-5;

/// What is known of a motion from elsewhere.
#[derive(Deserialize)]
struct Expected {
    /// The skeleton's path, from the folder.
    asf: String,
    frames_total: usize,
    /// In the order of the skeleton, with the root.
    bones: Vec<String>,
    /// Some of the frames.
    frames: Vec<ExpectedFrame>,
}

#[derive(Deserialize)]
struct ExpectedFrame {
    /// From 0.
    frame: usize,
    /// Where each bone starts and ends, in the file's unit.
    start: Vec<[f64; 3]>,
    end: Vec<[f64; 3]>,
}

/// Reads a skeleton.
pub fn check_skeleton(file: &Path) -> Reading {
    match acclaim::read_skeleton_file(file) {
        Ok(_) => Reading::Read(None),
        Err(error) => refused(&error, file),
    }
}

/// Reads a motion with its skeleton, and compares it with what `json` says of it. Without a `json` nobody knows the
/// skeleton: those beside the motion are tried, or a root alone.
pub fn check_motion(file: &Path, folder: &Path, json: Option<&Path>) -> Reading {
    match json {
        Some(json) => Reading::Read(Some(compare(file, folder, json))),
        None => match read_with_any_skeleton(file) {
            Ok(()) => Reading::Read(None),
            Err(error) => refused(&error, file),
        },
    }
}

fn read_with_any_skeleton(file: &Path) -> Result<(), FileError> {
    let entries = fs::read_dir(file.parent().unwrap_or(file)).expect("a folder can be listed");
    let paths = entries.map(|entry| entry.expect("a folder can be listed").path());
    let skeletons = paths
        .filter(|path| has_extension(path, "asf"))
        .filter_map(|path| acclaim::read_skeleton_file(path).ok());
    let root = Skeleton::new(Root::default()).expect("a root");
    let mut result = acclaim::read_motion_file(file, &root);
    for reading in skeletons {
        result = result.or_else(|_| acclaim::read_motion_file(file, &reading.skeleton));
    }
    result.map(|_| ())
}

/// Compares the motion in `file` with what `json` says of it. Gives how far off the worst bone is, or what is wrong.
fn compare(file: &Path, folder: &Path, json: &Path) -> Result<Worst, String> {
    let text = fs::read_to_string(json).map_err(|error| error.to_string())?;
    let expected: Expected = serde_json::from_str(&text).map_err(|error| error.to_string())?;
    let skeleton =
        acclaim::read_skeleton_file(folder.join(&expected.asf)).map_err(|error| error.to_string())?.skeleton;
    let motion = acclaim::read_motion_file(file, &skeleton).map_err(|error| error.to_string())?.motion;
    same("frames", &motion.frame_count(), &expected.frames_total)?;
    let names: Vec<String> = skeleton.bones().iter().map(|bone| bone.name.clone()).collect();
    same("bones", &names, &expected.bones)?;
    check_formulations(&motion)?;

    let mut worst = Worst::default();
    let unit = f64::from(skeleton.extent());
    let joints = acclaim::to_joints(&motion, 1.0 / 120.0).map_err(|error| error.to_string())?;
    for frame in &expected.frames {
        same("starts", &frame.start.len(), &skeleton.len())?;
        same("ends", &frame.end.len(), &skeleton.len())?;
        let ends = ends_about_world_axes(&skeleton, &motion.posture(frame.frame));
        let as_joints = ends_of_joints(&skeleton, &joints, frame.frame);
        for bone in skeleton.bones() {
            let (start, end) = (frame.start[bone.id.0], frame.end[bone.id.0]);
            let start_of = |ends: &[Vec3]| bone.parent.map_or(ends[0], |parent| ends[parent.0]).to_array();
            for (way, ends) in [("as bones", &ends), ("as joints", &as_joints)] {
                let end_off = distance(ends[bone.id.0].to_array(), end);
                let off = larger(end_off, distance(start_of(ends), start)) / unit;
                worst.include(Worst { position: off, rotation: 0.0 });
                if off.is_nan() || off > POSITION_TOLERANCE {
                    let Bone { name, .. } = bone;
                    return Err(format!(
                        "frame {}, {name} {way}: off by {off:.1e} of the extent",
                        frame.frame
                    ));
                }
            }
        }
    }
    if expected.frames.is_empty() { Err("no frames to compare".into()) } else { Ok(worst) }
}

/// Both ways of computing positions must agree in all frames.
fn check_formulations(motion: &Motion) -> Result<(), String> {
    let skeleton = motion.skeleton();
    let mut posture = Posture::default();
    for frame in 0..motion.frame_count() {
        motion.read_posture(frame, &mut posture);
        let one = ends_about_world_axes(skeleton, &posture);
        let other = ends_in_own_axes(skeleton, &posture);
        let mut apart = one.iter().zip(other).map(|(one, other)| one.distance(other) / skeleton.extent());
        if let Some(apart) = apart.find(|apart| apart.is_nan() || *apart > FORMULATION_TOLERANCE) {
            return Err(format!("frame {frame}: the two formulations are {apart:.1e} of the extent apart"));
        }
    }
    Ok(())
}

/// The rotation about a bone's own axes.
fn own_rotation(bone: &Bone, posture: &Posture) -> Quat {
    let angles = posture.angles[bone.id.0];
    let turn = |axis: Axis| Quat::from_axis_angle(axis.unit(), angles[axis.index()].to_radians());
    bone.rotation_order.axes().into_iter().flatten().map(turn).product()
}

/// Where the bones end: G = G(parent) C M C⁻¹, applied to the bone as it is at rest.
fn ends_about_world_axes(skeleton: &Skeleton, posture: &Posture) -> Vec<Vec3> {
    ends(skeleton, posture, |bone, above| {
        let c = bone.axis_rotation;
        let turned = above * c * own_rotation(bone, posture) * c.inverse();
        (turned, turned * bone.rest_vector())
    })
}

/// Where the bones end: R = R(parent) `rot_parent_current` M, applied to the bone in its own axes.
fn ends_in_own_axes(skeleton: &Skeleton, posture: &Posture) -> Vec<Vec3> {
    ends(skeleton, posture, |bone, above| {
        let turned = above * bone.rot_parent_current * own_rotation(bone, posture);
        (turned, turned * (bone.length * bone.local_direction))
    })
}

/// `turn` gives for a bone, and the rotation of its parent, its own rotation and its way from start to end.
fn ends(skeleton: &Skeleton, posture: &Posture, turn: impl Fn(&Bone, Quat) -> (Quat, Vec3)) -> Vec<Vec3> {
    let mut placed: Vec<(Quat, Vec3)> = Vec::new();
    for bone in skeleton.bones() {
        let (above, start) = bone.parent.map_or((Quat::IDENTITY, Vec3::ZERO), |parent| placed[parent.0]);
        let (turned, way) = turn(bone, above);
        placed.push((turned, start + way + posture.translations[bone.id.0]));
    }
    placed.into_iter().map(|(_, end)| end).collect()
}

/// Where the bones end: where that hangs which hangs on the joint of the same name, by the reference solution.
fn ends_of_joints(skeleton: &Skeleton, joints: &skeleton::Motion, frame: usize) -> Vec<Vec3> {
    let mut pose = Pose::default();
    pose_frame(joints.skeleton(), &joints.frame(frame), &solutions::FK, &mut pose);
    let all = joints.skeleton().joints();
    let end = |bone: &Bone| {
        let joint = all.iter().find(|joint| joint.name == bone.name && !joint.is_end_site).expect("a joint");
        let hung = all.iter().find(|hung| hung.parent == Some(joint.id)).expect("a joint on the joint");
        pose[hung.id].position
    };
    skeleton.bones().iter().map(end).collect()
}
