//! Motions as files of another format, warped, and what is printed of bones, from outside.
#![allow(clippy::unwrap_used)]

#[path = "../command/mod.rs"]
mod command;
#[path = "../command/files.rs"]
mod files;
mod formats;
mod lost;
mod printed;
mod refused;
mod warps;

use std::fs;
use std::path::Path;

use command::{command, view};
use files::{Folder, data, run};
use glam::{Quat, Vec3};
use parser::{acclaim, bvh};
use skeleton::acclaim::{AcclaimFunctions, Bone, BonePlace, Posture, Skeleton};
use skeleton::{Motion, Pose, RotationOrder, pose_frame};

fn read(path: impl AsRef<Path>) -> Motion {
    bvh::read_file(path).unwrap().motion
}

/// The motion at `path`, whose skeleton has the same name.
fn read_bones(path: impl AsRef<Path>) -> skeleton::acclaim::Motion {
    let path = path.as_ref();
    let skeleton = acclaim::read_skeleton_file(path.with_extension("asf")).unwrap();
    let motion = acclaim::read_motion_file(path, &skeleton.skeleton).unwrap();
    assert!(skeleton.warnings.is_empty() && motion.warnings.is_empty());
    motion.motion
}

/// Where all joints are in a frame.
fn pose(motion: &Motion, frame: usize) -> Pose {
    let mut pose = Pose::default();
    pose_frame(motion.skeleton(), &motion.frame(frame), &solutions::FK, &mut pose);
    pose
}

/// Where all bones are in a posture: by the reference solution of the exercise, as long as all bones have the order of which it
/// speaks.
fn places(skeleton: &Skeleton, posture: &Posture) -> Vec<BonePlace> {
    let is_usual = |bone: &Bone| matches!(bone.rotation_order, RotationOrder::Zyx | RotationOrder::None);
    let functions = match skeleton.bones().iter().all(is_usual) {
        true => solutions::ACCLAIM,
        false => AcclaimFunctions {
            bone_rotation: |bone, angles, parent| parent * bone.rot_parent_current * turned(bone, angles),
            ..solutions::ACCLAIM
        },
    };
    let places = exam::acclaim::places(skeleton, posture, &functions);
    places.into_iter().map(Option::unwrap).collect()
}

/// How a bone is turned about its own axes, in its own order.
fn turned(bone: &Bone, angles: [f32; 3]) -> Quat {
    let turn = |axis: &skeleton::Axis| Quat::from_axis_angle(axis.unit(), angles[axis.index()].to_radians());
    bone.rotation_order.axes().iter().flatten().map(turn).product()
}

/// A chain of bones that turn in other orders about turned axes, some with two degrees of freedom and some with one.
const ODD_BONES: &str = "\
:version 1.10
:name odd
:units
  mass 1
  length 1
  angle deg
:root
  order RY TZ TX TY RZ RX
  axis YZX
  position 1 2 3
  orientation 10 20 30
:bonedata
  begin
    id 1
    name one
    direction 0 1 0
    length 5
    axis 20 -30 40 ZXY
    dof ry rz rx
  end
  begin
    id 2
    name two
    direction 0 0.6 0.8
    length 4
    axis 0 0 90 XYZ
    dof rz rx
  end
  begin
    id 3
    name three
    direction 1 0 0
    length 3
    axis 50 0 0 XYZ
    dof ry
  end
:hierarchy
  begin
    root one
    one two
    two three
  end
";

/// A motion of the [`ODD_BONES`], with so many frames.
fn odd_motion(frames: usize) -> String {
    let frame = |i: usize| {
        let x = i as f32;
        format!(
            "{}\nroot {} {} 4 5 {} {}\none {} {} {}\ntwo {} {}\nthree {}\n",
            i + 1,
            30.0 * x,
            x,
            -20.0 * x,
            170.0 + 15.0 * x,
            40.0 * x,
            -25.0 * x,
            80.0 - 10.0 * x,
            50.0 * x,
            -30.0 * x,
            100.0 + 20.0 * x
        )
    };
    let frames: String = (0..frames).map(frame).collect();
    format!(":FULLY-SPECIFIED\n:DEGREES\n{frames}")
}

/// Writes the [`ODD_BONES`] and a motion of them, and gives the name of the motion.
fn odd_files(folder: &Folder, frames: usize) -> String {
    fs::write(folder.path("odd one.asf"), ODD_BONES).unwrap();
    fs::write(folder.path("odd one.amc"), odd_motion(frames)).unwrap();
    folder.text("odd one.amc")
}
