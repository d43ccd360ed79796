//! Part 2: single bones.

use exam::acclaim::Question as AcclaimQuestion;
use glam::Vec3;
use skeleton::acclaim::{Bone, Skeleton};

use super::{Draft, input};
use crate::acclaim::compare;
use crate::acclaim::figure::figure;
use crate::compare::{quaternion, vector};
use crate::dice::Dice;

/// What a case asks about: the bone, and whether its end is moved.
type Wanted = (&'static str, bool);

pub(super) fn drafts(dice: &mut Dice, check: &str) -> Vec<Draft> {
    let skeleton = figure(dice);
    let wanted: &[Wanted] = match check {
        "start" => &[("ltibia", false), ("rfemur", true), ("root", false), ("lradius", true)],
        "end" => &[
            ("ltibia", false),
            ("rhumerus", false),
            ("thorax", false),
            ("rhipjoint", false),
            ("head", false),
            ("lfemur", false),
            ("lclavicle", false),
            ("root", false),
        ],
        "translation" => &[("lhumerus", true), ("rtibia", true), ("lowerback", true), ("rradius", true)],
        _ => &[],
    };
    wanted.iter().map(|wanted| draft(dice, &skeleton, check, *wanted)).collect()
}

fn draft(dice: &mut Dice, skeleton: &Skeleton, check: &str, (name, is_moved): Wanted) -> Draft {
    let bone = skeleton.find(name).unwrap_or(skeleton.root());
    let (rotation, parent_end) = (dice.rotation(), dice.vector(10.0, 60.0));
    let translation = if is_moved { dice.vector(2.0, 20.0) } else { Vec3::ZERO };
    Draft {
        question: AcclaimQuestion::Ends {
            skeleton: skeleton.clone(),
            bone: bone.id,
            rotation,
            parent_end,
            translation,
        },
        inputs: vec![
            input("bone", who(bone)),
            input("local direction", vector(bone.local_direction)),
            input("rotation (x, y, z, w)", quaternion(rotation)),
            input("parent's end", format!("{} (file's unit)", vector(parent_end))),
            input("translation", format!("{} (file's unit)", vector(translation))),
        ],
        difference: if check == "start" { compare::start } else { compare::end },
        group: Some(group(check, bone, is_moved).to_owned()),
        size: skeleton.extent(),
    }
}

/// What wrong answers can have in common.
fn group(check: &str, bone: &Bone, is_moved: bool) -> &'static str {
    match (check, bone.is_root(), is_moved) {
        ("start", _, true) => "bones with a translation",
        ("start", _, false) => "bones without a translation",
        (_, true, _) => "the root, which has no length",
        (_, false, _) => "bones with a length",
    }
}

fn who(bone: &Bone) -> String {
    if bone.is_root() {
        "root, which has no length".to_owned()
    } else {
        format!("{}, {} long (file's unit)", bone.name, bone.length)
    }
}
