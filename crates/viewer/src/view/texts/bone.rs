//! Everything about the bone that the user looks at, where the exercise is about bones.

use std::fmt;

use glam::Vec3;
use skeleton::acclaim::{Bone, BoneId, BonePlace, Posture};

use super::Facts;
use super::number::{Rounded, Row, digits_for};
use crate::live::student::Details;
use crate::motion::bones::Bones;
use crate::scene::{Line, Off, Panel};
use crate::view::app::Shown;
use crate::view::blame::bone::{Blame, Case, Wrong, blame};

/// The bones, and what is right of them in this frame.
#[derive(Clone, Copy)]
pub struct OfBones<'a> {
    pub bones: &'a Bones,
    pub posture: &'a Posture,
    pub expected: &'a [Option<BonePlace>],
}

/// The name of `bone` as a heading, which says so where joint `joint` (from 0) stands for its end.
pub(super) fn write_name(bones: &Bones, joint: usize, bone: &Bone, panel: &mut Panel) {
    match bones.is_end(joint) {
        true => panel.add(Line::Heading, format_args!("{}: its end", bone.name)),
        false => panel.add(Line::Heading, &bone.name),
    }
}

pub fn write(facts: &Facts, of: OfBones, panel: &mut Panel) {
    let Some(joint) = facts.app.selected() else { return };
    let skeleton = of.bones.motion().skeleton();
    let Some(bone) = skeleton.get(of.bones.of_joint(joint)) else { return };
    write_name(of.bones, joint, bone, panel);
    match bone.parent.and_then(|parent| skeleton.get(parent)) {
        Some(parent) => panel.add(Line::Key("parent"), &parent.name),
        None => panel.add(Line::Key("parent"), "none: the root"),
    }
    match bone.dofs.is_empty() {
        true => panel.add(Line::Key("dof"), "none: it does not turn"),
        false => panel.add(Line::Key("dof"), Dofs(bone)),
    }
    let [x, y, z] = of.posture.angles.get(bone.id.0).copied().unwrap_or_default();
    panel.add(Line::Key("angles"), format_args!("X {x:.2}°, Y {y:.2}°, Z {z:.2}°"));

    let Some(right) = of.expected.get(bone.id.0).copied().flatten() else { return };
    let digits = digits_for(facts.app.stage().size());
    let Shown::Student(_) = facts.shown else {
        panel.add(Line::Key("rotation"), Row(&right.rotation.to_array(), 4));
        panel.add(Line::Key("start"), Row(&right.start.to_array(), digits));
        return panel.add(Line::Key("end"), Row(&right.end.to_array(), digits));
    };
    let Some(given) = facts.posed.and_then(|posed| posed.places()) else { return };
    let current = facts.standing.is_some_and(|standing| standing.current);
    if !current {
        panel.add(Line::Quiet, "yours: of your last version that worked");
    }
    let yours = given.get(bone.id.0).copied().flatten();
    rows(
        panel,
        "rotation (x, y, z, w)",
        yours.map(|own| own.rotation.to_array()),
        right.rotation.to_array(),
        4,
    );
    rows(
        panel,
        "start, in the file's units",
        yours.map(|own| own.start.to_array()),
        right.start.to_array(),
        digits,
    );
    rows(panel, "end", yours.map(|own| own.end.to_array()), right.end.to_array(), digits);
    if let Some(yours) = yours {
        off(facts, &[(yours.start, right.start), (yours.end, right.end)], panel);
    }
    if current {
        verdict(facts, of, given, bone.id, panel);
    }
}

fn rows<const N: usize>(
    panel: &mut Panel,
    what: &str,
    yours: Option<[f32; N]>,
    right: [f32; N],
    digits: usize,
) {
    panel.add(Line::Text, what);
    match yours {
        Some(yours) => panel.add(Line::Key("yours"), Row(&yours, digits)),
        None => panel.add(Line::Key("yours"), "none: not visited"),
    }
    panel.add(Line::Key("expected"), Row(&right, digits));
}

/// By how much it is off: the end that is farther off.
fn off(facts: &Facts, ends: &[(Vec3, Vec3); 2], panel: &mut Panel) {
    let [start, end] = ends.map(|(given, right)| given.distance(right));
    let size = facts.app.stage().size();
    if start.is_nan() || end.is_nan() {
        return panel.add(Line::Key("off by"), "nobody knows how much: NaN is no number");
    }
    let (which, off) = if end >= start { ("its end", end) } else { ("its start", start) };
    if Off::by(off / size) > Off::Right {
        let percent = Rounded(f64::from(off / size) * 100.0);
        let off = Rounded(f64::from(off));
        panel.add(Line::Key("off by"), format_args!("{which}: {off}, that is {percent} % of the figure"));
    }
}

/// Which part is to blame.
fn verdict(facts: &Facts, of: OfBones, given: &[Option<BonePlace>], bone: BoneId, panel: &mut Panel) {
    let skeleton = of.bones.motion().skeleton();
    let visits = match facts.details() {
        Some(Details::Visits(visits)) => Some(&visits[..]),
        _ => None,
    };
    let times = visits.map_or(0, |visits| visits.iter().filter(|visit| **visit == bone).count());
    if times > 1 {
        panel.add(Line::Trouble, format_args!("part 3 visits it {times} times: once would do"));
    }
    let size = facts.app.stage().size();
    let case = Case { skeleton, posture: of.posture, given, expected: of.expected, visits, size };
    let name = |bone: BoneId| skeleton.get(bone).map_or("", |bone| &bone.name);
    match blame(&case, bone) {
        Blame::Nobody => panel.add(Line::Right, "right"),
        Blame::InPlace { from_rest: true } => {
            panel.add(Line::Right, "in its place");
            panel.add(Line::Quiet, "its rotation is counted from the rest pose: the handout's other formula");
        }
        Blame::InPlace { from_rest: false } => {
            panel.add(Line::Right, "in its place");
            panel.add(Line::Quiet, "its rotation is another one than part 1 asks for");
        }
        Blame::OtherOrder => {
            panel.add(Line::Quiet, "right as its file means it: the goal turns every bone by Rz Ry Rx")
        }
        Blame::Own(wrong) => match begun(facts, wrong) {
            None => panel.add(Line::Quiet, "not right yet: not all parts are started"),
            Some(wrong) => panel.add(Line::Trouble, own(wrong)),
        },
        // In the untouched file that is so for all but the root, also before its points are known.
        Blame::NotVisited if !facts.is_begun(2) || given.iter().flatten().count() <= 1 => {
            panel.add(Line::Quiet, "part 3 does not visit this bone yet");
        }
        Blame::NotVisited => panel.add(Line::Trouble, "part 3 is to blame: it does not visit this bone"),
        Blame::WithoutParent(parent) => panel.add(
            Line::Trouble,
            format_args!(
                "part 3 is to blame: it does not visit the parent, {}, which has no place",
                name(parent)
            ),
        ),
        Blame::BeforeParent(parent) => panel.add(
            Line::Trouble,
            format_args!(
                "part 3 is to blame: it visits this bone before its parent, {}, which had no place then",
                name(parent)
            ),
        ),
        Blame::Unclear => panel.add(Line::Trouble, "one of the parts is to blame: asking part 3 by itself…"),
        Blame::Above(above) => {
            panel.add(
                Line::Trouble,
                format_args!("its own parts are right: it is off because {} is", name(above)),
            );
        }
    }
}

/// What of it is the fault of parts that are begun, if anything is.
fn begun(facts: &Facts, wrong: Wrong) -> Option<Wrong> {
    let second = facts.is_begun(1);
    let begun = Wrong {
        rotation: wrong.rotation && facts.is_begun(0),
        start: wrong.start && second,
        end: wrong.end && second,
    };
    (begun != Wrong::default()).then_some(begun)
}

/// For a bone whose own parts are wrong.
fn own(Wrong { rotation, start, end }: Wrong) -> &'static str {
    match (rotation, start, end) {
        (true, false, false) => "part 1 is to blame: given its parent's rotation, its rotation is wrong",
        (true, ..) => "parts 1 and 2 are to blame, each by itself",
        (false, true, false) => "part 2 is to blame: its start is not its parent's end",
        (false, false, _) => "part 2 is to blame: given its start and its rotation, its end is wrong",
        (false, true, true) => {
            "part 2 is to blame: given its rotation and its parent's end, both its ends are wrong"
        }
    }
}

/// What can move in a bone, as files say it.
struct Dofs<'a>(&'a Bone);

impl fmt::Display for Dofs<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, dof) in self.0.dofs.iter().enumerate() {
            let blank = if index > 0 { " " } else { "" };
            write!(f, "{blank}{dof}")?;
        }
        Ok(())
    }
}
