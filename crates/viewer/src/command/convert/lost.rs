//! What of a motion does not go over into another format as it is.

use std::collections::BTreeSet;

use parser::printable;
use skeleton::acclaim::{self, Bone, BoneId, DegreeOfFreedom, Units};
use skeleton::{Channel, Joint, Motion};

use super::facts::fact;
use crate::command::print::{number, shortened};
use crate::motion::stage::Stage;
use crate::view::texts::count;

/// So many names are told.
const MOST_NAMED: usize = 3;

/// So many characters of a name are told.
const LONGEST_NAME: usize = 40;

/// What joints do not have of the bones of which they were made; nothing where they were made of none.
pub fn of_bones(stage: &Stage) -> String {
    let Some(bones) = stage.bones() else { return String::new() };
    let skeleton = bones.motion().skeleton();
    let lost = properties(skeleton);
    let lost = match lost.is_empty() {
        true => String::new(),
        false => fact("lost", &format!("{}: joints have no such thing", listed(&lost, lost.len()))),
    };
    let is_moved_end = |joint: &&Joint| !joint.is_end_site && bones.is_end(joint.id.0);
    let ends = stage.motion().skeleton().joints().iter().filter(is_moved_end);
    let ends: Vec<String> = ends.map(|joint| quoted(&joint.name)).collect();
    let what =
        ["joint for the end of a bone that moves along", "joints for the ends of bones that move along"];
    added(&ends, what) + &lost
}

/// What these bones have, and no joint has.
fn properties(skeleton: &acclaim::Skeleton) -> Vec<String> {
    let bones = skeleton.bones();
    let Units { length, mass, .. } = skeleton.units;
    let short = |value: f32| shortened(number(value.into(), 3));
    // A joint that turns has three channels.
    let has_fewer = |bone: &Bone| [1, 2].contains(&rotations(bone));
    let all = [
        (bones.iter().any(|bone| bone.axis.angles != [0.0; 3]), "the bones' own axes".into()),
        (bones.iter().any(has_fewer), "which angles are dofs".into()),
        (bones.iter().flat_map(|bone| &bone.dofs).any(DegreeOfFreedom::is_limited), "limits".into()),
        (length != 1.0 || mass != 1.0, format!("units (length {}, mass {})", short(length), short(mass))),
        (!skeleton.name.is_empty(), "the skeleton's name".into()),
    ];
    all.into_iter().filter_map(|(is_there, what)| is_there.then_some(what)).collect()
}

fn rotations(bone: &Bone) -> usize {
    bone.dofs.iter().filter(|dof| matches!(dof.channel, Channel::Rotation(_))).count()
}

/// What has become of the joints of a motion of which `bones` were made; `of_joints` says which of these turns with each
/// joint.
pub fn of_joints(motion: &Motion, bones: &acclaim::Skeleton, of_joints: &[BoneId]) -> String {
    let joints = || motion.skeleton().joints().iter().zip(of_joints).filter(|(joint, _)| !joint.is_end_site);
    let renamed = joints().filter_map(|(joint, bone)| {
        let name = &bones.get(*bone)?.name;
        (*name != joint.name).then(|| format!("{} is now {}", quoted(&joint.name), quoted(name)))
    });
    let renamed: Vec<String> = renamed.collect();
    let moved = joints().filter(|(joint, _)| !joint.is_root() && has_positions(joint));
    let moved: Vec<String> = moved.map(|(joint, _)| quoted(&joint.name)).collect();
    let own: BTreeSet<BoneId> = of_joints.iter().copied().collect();
    let leading = bones.bones().iter().filter(|bone| !bone.is_root() && !own.contains(&bone.id));
    let leading: Vec<String> = leading.map(|bone| quoted(&bone.name)).collect();
    let mut said = String::new();
    if !renamed.is_empty() {
        said += &fact("new names", &listed(&renamed, MOST_NAMED));
    }
    said += &added(&leading, ["bone without dofs between joints", "bones without dofs between joints"]);
    if !moved.is_empty() {
        let joints = listed(&moved, MOST_NAMED);
        said += &fact("lost", &format!("the position channels of {joints}, which never change"));
    }
    said
}

fn has_positions(joint: &Joint) -> bool {
    joint.channels.iter().any(|channel| matches!(channel, Channel::Position(_)))
}

/// How many there are of something that is new, and their names.
fn added(names: &[String], [one, many]: [&str; 2]) -> String {
    match names.len() {
        0 => String::new(),
        number => fact("added", &format!("{}: {}", count(number, one, many), listed(names, MOST_NAMED))),
    }
}

/// `items` in one line; of more than `most` only the first, and how many more there are.
fn listed(items: &[String], most: usize) -> String {
    match items {
        [first @ .., last] if !first.is_empty() && items.len() <= most => {
            format!("{} and {last}", first.join(", "))
        }
        _ if items.len() <= most => items.concat(),
        _ => format!("{} and {} more", items[..most].join(", "), items.len() - most),
    }
}

/// A name as it is told: not longer than a line, and where it begins and ends can be seen.
fn quoted(name: &str) -> String {
    let mut start: String = name.chars().take(LONGEST_NAME).collect();
    if start.len() < name.len() {
        start.push('…');
    }
    format!("`{}`", printable(&start))
}
