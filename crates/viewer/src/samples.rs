//! Small motions for tests.

use std::path::Path;
use std::sync::{Arc, OnceLock};

use glam::Vec3;
use skeleton::acclaim::{BoneData, BoneId, Columns, LocalAxes, Root};
use skeleton::{Channel, Motion, PositionChannels, Skeleton, acclaim};

use crate::motion::bones::Bones;
use crate::motion::source::Source;
use crate::motion::stage::Stage;

/// A file in `data/`.
pub fn data(name: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data").join(name)
}

/// A walk of bones: 31 of them in 480 frames.
pub fn walk() -> Arc<Stage> {
    static WALK: OnceLock<Arc<Stage>> = OnceLock::new();
    WALK.get_or_init(|| bones(&data("walk.asf"), &data("walk.amc"))).clone()
}

/// The same walk, with the numbers of the left thigh listed as rz ry rx.
pub fn walk_in_other_orders() -> Arc<Stage> {
    let skeleton = |text: &str| {
        let at = text.find("name lfemur").unwrap();
        text[..at].to_owned() + &text[at..].replacen("dof rx ry rz", "dof rz ry rx", 1)
    };
    walk_with(skeleton, |line| {
        let numbers: Vec<&str> = line.strip_prefix("lfemur ")?.split(' ').collect();
        Some(["lfemur", numbers[2], numbers[1], numbers[0]].join(" "))
    })
}

/// The same walk with another skeleton file, and with other lines in its motion.
pub fn walk_with(skeleton: impl Fn(&str) -> String, line: impl Fn(&str) -> Option<String>) -> Arc<Stage> {
    let folder = tempfile::tempdir().unwrap();
    let changed = |name: &str, change: &dyn Fn(&str) -> String| {
        let path = folder.path().join(name);
        std::fs::write(&path, change(&std::fs::read_to_string(data(name)).unwrap())).unwrap();
        path
    };
    let lines = |text: &str| {
        text.lines().map(|old| line(old).unwrap_or_else(|| old.to_owned()) + "\n").collect::<String>()
    };
    bones(&changed("walk.asf", &skeleton), &changed("walk.amc", &lines))
}

/// The motion of bones in two files.
pub fn bones(skeleton: &Path, motion: &Path) -> Arc<Stage> {
    Source { skeleton: Some(skeleton.into()), ..Source::new(motion) }.read().unwrap().stage
}

/// A root and so many bones, each on the one before and of length 1 along Y, in one frame in which nothing is turned.
pub fn chain_of_bones(count: usize) -> acclaim::Motion {
    let mut skeleton = acclaim::Skeleton::new(Root::default()).unwrap();
    (0..count).fold(BoneId::ROOT, |parent, index| {
        let (name, axis, dofs) = (format!("bone{index}"), LocalAxes::WORLD, Vec::new());
        skeleton.add_bone(parent, BoneData { name, direction: Vec3::Y, length: 1.0, axis, dofs }).unwrap()
    });
    let columns = Columns::new(skeleton);
    let row = vec![0.0; columns.len()];
    acclaim::Motion::new(columns, 1, row).unwrap()
}

/// The stage of that chain.
pub fn stage_of_bones(count: usize) -> Stage {
    let motion = chain_of_bones(count);
    let joints = parser::acclaim::to_joints(&motion, 0.1).unwrap();
    let bones = Bones::new(motion, joints.skeleton());
    Stage::new(joints, PositionChannels::Replace).with_bones(bones)
}

/// A root that walks along X and bobs, a left and a right limb on it, and a tip each.
pub fn chain(frames: usize, scale: f32) -> Motion {
    let channels =
        |words: &str| -> Vec<Channel> { words.split(' ').filter_map(Channel::from_word).collect() };
    let mut skeleton = Skeleton::new();
    let six = channels("Xposition Yposition Zposition Zrotation Xrotation Yrotation");
    let root = skeleton.add_joint(None, "Hips", Vec3::ZERO, six).unwrap();
    let offset = Vec3::new(0.2, -0.1, 0.0) * scale;
    let left =
        skeleton.add_joint(Some(root), "LeftLeg", offset, channels("Zrotation Yrotation Xrotation")).unwrap();
    skeleton.add_end_site(left, "End Site", Vec3::new(0.0, -0.8, 0.1) * scale).unwrap();
    let right = skeleton.add_joint(Some(root), "RightLeg", offset * Vec3::new(-1.0, 1.0, 1.0), []).unwrap();
    skeleton.add_end_site(right, "End Site", Vec3::new(0.0, -0.8, 0.1) * scale).unwrap();
    let row = |i: usize| {
        let t = i as f32;
        let place = [0.1 * t * scale, (0.9 + 0.02 * (t * 0.7).sin()) * scale, 0.0];
        place.into_iter().chain([2.0 * t, 5.0, 90.0, 30.0 * (t * 0.4).sin(), 0.0, 10.0])
    };
    Motion::new(skeleton, frames, 0.1, (0..frames).flat_map(row).collect()).unwrap()
}
