//! What a student's functions make of a warped motion.

use skeleton::acclaim::Between;
use skeleton::{JointId, Transform};

use super::Facts;
use super::bone::write_name;
use super::number::{self, Rounded, Row, digits_for};
use crate::live::student::time_warp::{is_asked_whole, places_step};
use crate::live::student::{Details, Extra};
use crate::motion::time_map::{TimeMap, position_of};
use crate::scene::{Line, Off, Panel};
use crate::view::app::Shown;
use crate::view::blame::warp::{Blame, Case, blame, is_same_place};

/// Where part 1 says the frame is, how many frames part 3 gives, and of how many bones the posture is, where that is not right.
/// Before they are begun nothing is wrong with that.
pub fn write(
    facts: &Facts,
    (given, place, bones): (Option<usize>, Option<Between>, Option<usize>),
    panel: &mut Panel,
) {
    let stage = facts.app.stage();
    let Some(map) = stage.warp() else { return };
    let line = |part: usize| if is_known_begun(facts, part) { Line::Trouble } else { Line::Text };
    if let (Some(count), Some(all)) = (bones, stage.bones()) {
        let all = all.motion().skeleton().len();
        panel.add(
            Line::Trouble,
            format_args!(
                "the posture has angles or translations of {}, and there are {all}",
                number::count(count, "bone", "bones")
            ),
        );
    }
    if !is_asked_whole(stage) {
        let why = match map {
            TimeMap::Stretch { .. } => "in a stretch only your part 2 is at work",
            TimeMap::Whole { .. } => "with so many frames only your part 2 is at work",
        };
        return panel.add(Line::Quiet, why);
    }
    match placed(facts, place, &map) {
        Some((frame, place)) if !is_same_place(place, map.place(frame)) => {
            let at = position_of(place);
            match frame == facts.app.frame() {
                true => panel.add(line(0), format_args!("part 1 puts it at {at:.2}")),
                false => panel.add(line(0), format_args!("part 1 puts frame {frame} at {at:.2}")),
            }
        }
        _ => {}
    }
    let wanted = map.frame_count();
    if let Some(given) = given.filter(|given| *given != wanted) {
        let given = number::count(given, "frame", "frames");
        panel.add(line(2), format_args!("part 3 gives {given}, and {wanted} are wanted"));
    }
}

/// Where part 1 puts the shown frame, or else the one before it that it was asked about: of a long motion it is not asked about
/// all.
fn placed(facts: &Facts, place: Option<Between>, map: &TimeMap) -> Option<(usize, Between)> {
    let frame = facts.app.frame();
    if let Some(place) = place {
        return Some((frame, place));
    }
    let Shown::Student(answers) = facts.shown else { return None };
    let asked = frame - frame % places_step(map);
    match answers.posed(asked)?.extra {
        Extra::Warp { place, .. } => Some((asked, place?)),
        Extra::Angles { .. } | Extra::Bones(_) => None,
    }
}

/// Whether the shown frame is none of those that part 3 gives.
pub fn is_missing(facts: &Facts) -> bool {
    let given = facts.posed.and_then(|posed| match posed.extra {
        Extra::Warp { given, .. } => given,
        _ => None,
    });
    given.is_some_and(|given| given <= facts.app.frame())
}

/// Whether it is known that a part (from 0) is begun: only then something is wrong with it.
pub fn is_known_begun(facts: &Facts, part: usize) -> bool {
    facts.standing.is_some_and(|standing| standing.board.is_some()) && facts.is_begun(part)
}

/// Everything about the joint that the user looks at.
pub fn write_joint(facts: &Facts, panel: &mut Panel) {
    let Some(id) = facts.app.selected().map(JointId) else { return };
    let stage = facts.app.stage();
    let Some(bones) = stage.bones() else { return };
    let Some(bone) = bones.motion().skeleton().get(bones.of_joint(id.0)) else { return };
    write_name(bones, id.0, bone, panel);
    let given = facts.solid.and_then(|pose| pose.transforms().get(id.0));
    let Some(right) = facts.reference.transforms().get(id.0) else { return };
    let (current, digits) =
        (facts.standing.is_some_and(|standing| standing.current), digits_for(stage.size()));
    if given.is_some() && !current {
        panel.add(Line::Quiet, "yours: of your last version that worked");
    }
    let own_axes = bones.own_axes(id.0);
    let is_missing = is_missing(facts);
    let row = |panel: &mut Panel, yours: Option<&[f32]>, right: &[f32], digits: usize| {
        match yours {
            Some(_) if is_missing => panel.add(Line::Key("yours"), "none: no such frame"),
            Some(yours) => panel.add(Line::Key("yours"), Row(yours, digits)),
            None => {}
        }
        panel.add(Line::Key("expected"), Row(right, digits));
    };
    let rotation = |transform: &Transform| (transform.rotation * own_axes).to_array();
    let place = if bones.is_end(id.0) { "end, in the file's units" } else { "start, in the file's units" };
    panel.add(Line::Text, "rotation (x, y, z, w)");
    row(panel, given.map(rotation).as_ref().map(|own| &own[..]), &rotation(right), 4);
    panel.add(Line::Text, place);
    let position = |transform: &Transform| transform.position.to_array();
    row(panel, given.map(position).as_ref().map(|own| &own[..]), &position(right), digits);
    let Some(given) = given else { return };
    let off = given.position.distance(right.position);
    if Off::by(off / stage.size()) > Off::Right && off.is_finite() {
        let percent = Rounded(f64::from(off / stage.size()) * 100.0);
        panel.add(
            Line::Key("off by"),
            format_args!("{}, that is {percent} % of the figure", Rounded(f64::from(off))),
        );
    }
    if current {
        verdict(facts, id, panel);
    }
}

/// Which part is to blame.
fn verdict(facts: &Facts, joint: JointId, panel: &mut Panel) {
    let (Some(pose), Some(Extra::Warp { place, .. })) = (facts.solid, facts.posed.map(|posed| &posed.extra))
    else {
        return;
    };
    let stage = facts.app.stage();
    let Some(map) = stage.warp() else { return };
    let frame = facts.app.frame();
    if is_missing(facts) {
        let line = if facts.is_begun(2) { Line::Trouble } else { Line::Quiet };
        return panel.add(line, "part 3 gives no such frame");
    }
    let (said, blended) = match facts.details() {
        Some(Details::Blended { right, place, own }) => (*place, Some((right, own.as_ref()))),
        _ => (None, None),
    };
    let case = Case {
        skeleton: stage.motion().skeleton(),
        given: pose,
        expected: facts.reference,
        // Of a long motion part 1 is asked about some frames only. Where only part 2 is at work, places are right.
        place: place.or(said).unwrap_or(map.place(frame)),
        right_place: map.place(frame),
        blended,
        size: stage.size(),
    };
    match blame(&case, joint) {
        Blame::Nobody => panel.add(Line::Right, "right"),
        Blame::Unclear => {
            panel.add(Line::Trouble, "one of the parts is to blame: asking parts 1 and 2 by themselves…")
        }
        Blame::Parts(parts) => match [0, 1, 2].map(|part| parts[part] && facts.is_begun(part)) {
            [false, false, false] => panel.add(Line::Quiet, "not right yet: not all parts are started"),
            begun => told(begun, &case, panel),
        },
        Blame::Above(above) => {
            let name = case.skeleton.get(above).map_or("", |joint| &joint.name);
            panel.add(Line::Trouble, format_args!("turned rightly itself: it is off because {name} is"));
        }
    }
}

/// What is wrong with parts that are begun.
fn told(parts: [bool; 3], case: &Case, panel: &mut Panel) {
    if parts[0] {
        let [own, right] = [case.place, case.right_place].map(position_of);
        panel.add(
            Line::Trouble,
            format_args!("part 1 is to blame: the frame is not at {own:.2}, but at {right:.2}"),
        );
    }
    if parts[1] {
        let Between { before, after, t } = case.right_place;
        panel.add(Line::Trouble, "part 2 is to blame: it turns this bone wrongly");
        panel.add(Line::Quiet, format_args!("between the frames {before} and {after}, at t = {t:.3}"));
    }
    if parts[2] {
        panel.add(Line::Trouble, "part 3 is to blame: parts 1 and 2 make something else of it");
    }
}
