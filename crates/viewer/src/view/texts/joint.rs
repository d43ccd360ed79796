//! Everything about the joint that the user looks at.

use skeleton::JointId;

use super::Facts;
use super::number::{Rounded, Row, digits_for};
use crate::scene::{Line, Off, Panel};
use crate::view::app::Shown;
use crate::view::blame::joint::{Blame, Case, angles_of, blame, right_local};

pub fn write(facts: &Facts, panel: &mut Panel) {
    let Some(id) = facts.app.selected().map(JointId) else { return };
    let (stage, skeleton) = (facts.app.stage(), facts.app.stage().motion().skeleton());
    let Some(joint) = skeleton.get(id) else { return };
    let name = |id| skeleton.get(id).map_or("", |joint| &joint.name);

    match (joint.is_end_site, joint.parent) {
        (true, Some(parent)) => panel.add(Line::Heading, format_args!("{} of {}", joint.name, name(parent))),
        _ => panel.add(Line::Heading, &joint.name),
    }
    match joint.parent {
        Some(parent) => panel.add(Line::Key("parent"), name(parent)),
        None => panel.add(Line::Key("parent"), "none: a root"),
    }
    match (joint.rotation_order.axes(), angles_of(skeleton, facts.angles, id)) {
        (Some([a, b, c]), Some(&[x, y, z])) => {
            panel.add(Line::Key("order"), joint.rotation_order);
            panel.add(Line::Key("angles"), format_args!("{a} {x:.2}°, {b} {y:.2}°, {c} {z:.2}°"));
        }
        _ => panel.add(Line::Key("order"), "NONE: takes no angles"),
    }

    let digits = digits_for(stage.size());
    let Some(expected) = facts.reference.transforms().get(id.0) else { return };
    let (rotation, position) = (expected.rotation.to_array(), expected.position.to_array());
    let Some(given) = facts.solid.and_then(|pose| pose.transforms().get(id.0)) else { return };
    match facts.shown {
        Shown::Reference if facts.edited.is_some() => {
            panel.add(Line::Text, "global rotation (x, y, z, w)");
            panel.add(Line::Key("shown"), Row(&given.rotation.to_array(), 4));
            panel.add(Line::Key("original"), Row(&rotation, 4));
            panel.add(Line::Text, "global position, in the file's units");
            panel.add(Line::Key("shown"), Row(&given.position.to_array(), digits));
            panel.add(Line::Key("original"), Row(&position, digits));
            let off = Rounded(f64::from(given.position.distance(expected.position)));
            panel.add(Line::Key("apart"), format_args!("{off}"));
        }
        Shown::Reference => {
            panel.add(Line::Key("rotation"), Row(&rotation, 4));
            panel.add(Line::Key("position"), Row(&position, digits));
        }
        Shown::Student(_) => {
            if facts.standing.is_some_and(|standing| !standing.current) {
                panel.add(Line::Quiet, "yours: of your last version that worked");
            }
            let locals = facts.student_locals().and_then(|locals| locals.get(id.0));
            if let Some(local) = locals {
                let right = right_local(skeleton, facts.angles, id);
                panel.add(Line::Text, "local rotation (x, y, z, w)");
                panel.add(Line::Key("yours"), Row(&local.rotation.to_array(), 4));
                panel.add(Line::Key("expected"), Row(&right.to_array(), 4));
            }
            panel.add(Line::Text, "global rotation (x, y, z, w)");
            panel.add(Line::Key("yours"), Row(&given.rotation.to_array(), 4));
            panel.add(Line::Key("expected"), Row(&rotation, 4));
            panel.add(Line::Text, "global position, in the file's units");
            panel.add(Line::Key("yours"), Row(&given.position.to_array(), digits));
            panel.add(Line::Key("expected"), Row(&position, digits));
            let off = given.position.distance(expected.position);
            if off.is_nan() {
                panel.add(Line::Key("off by"), "nobody knows how much: NaN is no number");
            } else if Off::by(off / stage.size()) > Off::Right {
                let percent = Rounded(f64::from(off / stage.size()) * 100.0);
                let off = Rounded(f64::from(off));
                panel.add(Line::Key("off by"), format_args!("{off}, that is {percent} % of the figure"));
            }
            verdict(facts, id, panel);
        }
    }
}

/// Which part is to blame.
fn verdict(facts: &Facts, joint: JointId, panel: &mut Panel) {
    let Some(given) = facts.solid else { return };
    if facts.standing.is_some_and(|standing| !standing.current) {
        return;
    }
    let stage = facts.app.stage();
    let skeleton = stage.motion().skeleton();
    let case = Case {
        skeleton,
        angles: facts.angles,
        local_positions: facts.local_positions,
        given,
        locals: facts.student_locals(),
        size: stage.size(),
    };
    match blame(&case, joint) {
        Blame::Nobody => panel.add(Line::Right, "right"),
        Blame::Own(parts) => match [0, 1, 2].map(|part| parts[part] && facts.is_begun(part)) {
            [false, false, false] => panel.add(Line::Quiet, "not right yet: not all parts are started"),
            begun => panel.add(Line::Trouble, own(begun)),
        },
        Blame::RotationOf => {
            panel.add(Line::Trouble, "part 1 or part 2 is to blame: asking part 1 by itself…")
        }
        Blame::Above(above) => {
            let name = skeleton.get(above).map_or("", |joint| &joint.name);
            panel.add(Line::Trouble, format_args!("its own parts are right: it is off because {name} is"));
        }
    }
}

/// For a joint whose own parts (the first, the second, the third) are wrong.
fn own(parts: [bool; 3]) -> &'static str {
    match parts {
        [true, false, false] => "part 1 is to blame: its local rotation is wrong",
        [false, true, false] => "part 2 is to blame: with part 1's answer its global rotation is wrong",
        [false, false, _] => "part 3 is to blame: given its parent, its position is wrong",
        [true, true, false] => "parts 1 and 2 are to blame, each by itself",
        [true, false, true] => "parts 1 and 3 are to blame, each by itself",
        [false, true, true] => "parts 2 and 3 are to blame, each by itself",
        [true, true, true] => "all three parts are to blame, each by itself",
    }
}
