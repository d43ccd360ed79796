//! Part 1: single bones.

use exam::acclaim::Question as AcclaimQuestion;
use glam::Quat;
use skeleton::acclaim::{Bone, Skeleton};
use skeleton::{Axis, Channel};

use super::{Draft, input};
use crate::acclaim::compare;
use crate::acclaim::figure::{LIKE_PARENT, angles, figure};
use crate::compare::quaternion;
use crate::dice::Dice;

/// Bones that turn about at most one of their axes.
const PLAIN: [&str; 8] =
    ["ltibia", "lradius", "lclavicle", "lhipjoint", "rtibia", "rradius", "rclavicle", "rhipjoint"];

pub(super) fn drafts(dice: &mut Dice, check: &str) -> Vec<Draft> {
    let skeleton = figure(dice);
    let mut ask = |name: &str, low, high| {
        let bone = skeleton.find(name).unwrap_or(skeleton.root());
        let angles = angles(dice, bone, low, high);
        let parent = if bone.is_root() { Quat::IDENTITY } else { dice.rotation() };
        draft(&skeleton, bone, angles, parent)
    };
    match check {
        "root" => (0..4).map(|_| ask("root", 25.0, 80.0)).collect(),
        "angles" => {
            let once = LIKE_PARENT.map(|name| ask(name, 25.0, 80.0));
            once.into_iter().chain(LIKE_PARENT.map(|name| ask(name, 200.0, 1000.0))).collect()
        }
        "rest" => PLAIN.map(|name| ask(name, 25.0, 160.0)).into(),
        _ => Vec::new(),
    }
}

fn draft(skeleton: &Skeleton, bone: &Bone, angles: [f32; 3], parent: Quat) -> Draft {
    let [x, y, z] = angles;
    let mut inputs = vec![
        input("bone", format!("{}, {}", bone.name, dofs(bone))),
        input("angles", format!("X {x}°, Y {y}°, Z {z}°")),
        input("rot_parent_current (x, y, z, w)", quaternion(bone.rot_parent_current)),
    ];
    if !bone.is_root() {
        inputs.push(input("parent's rotation (x, y, z, w)", quaternion(parent)));
    }
    Draft {
        question: AcclaimQuestion::Rotation { skeleton: skeleton.clone(), bone: bone.id, angles, parent },
        inputs,
        difference: compare::rotation,
        group: None,
        size: skeleton.extent(),
    }
}

/// About which axes the bone turns.
fn dofs(bone: &Bone) -> String {
    let turns = |axis: &Axis| bone.dofs.iter().any(|dof| dof.channel == Channel::Rotation(*axis));
    let axes: Vec<String> =
        Axis::ALL.iter().filter(|axis| turns(axis)).map(|axis| axis.to_string()).collect();
    match &axes[..] {
        [] => "which does not turn against its parent".to_owned(),
        [axis] => format!("which turns about {axis} only"),
        [others @ .., last] => format!("which turns about {} and {last}", others.join(", ")),
    }
}
