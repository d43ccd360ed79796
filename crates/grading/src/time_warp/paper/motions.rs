//! Part 3: whole motions, mostly short ones.

use exam::time_warp::Question as TimeWarpQuestion;
use skeleton::acclaim::Posture;

use super::{case, input};
use crate::Case;
use crate::compare::counted;
use crate::dice::Dice;
use crate::time_warp::compare::{self, in_degrees};
use crate::time_warp::throws;

/// The bones of a small figure.
const BONES: usize = 4;

pub(super) fn cases(dice: &mut Dice, check: &str) -> Vec<Case> {
    let mut ask_all = |counts: &[(usize, usize, usize)]| -> Vec<Case> {
        let ask = |&(frames, bones, new_count): &(usize, usize, usize)| {
            let postures = throws::motion(dice, frames, bones);
            ask(postures, new_count, None, None)
        };
        counts.iter().map(ask).collect()
    };
    match check {
        "longer" => ask_all(&[(3, 1, 6), (4, 1, 7), (6, BONES, 15), (11, BONES, 26)]),
        "shorter" => ask_all(&[(4, 1, 3), (8, BONES, 5), (12, BONES, 7), (10, BONES, 3)]),
        "same" => same(dice),
        "few" => few(dice),
        _ => Vec::new(),
    }
}

/// As many frames as before, and what has been warped to twice as many.
fn same(dice: &mut Dice) -> Vec<Case> {
    let mut cases = Vec::new();
    for (frames, bones) in [(3, 1), (8, BONES)] {
        let postures = throws::motion(dice, frames, bones);
        let twice = solutions::time_warp::warp(&postures, 2 * frames);
        let origin = format!("{frames} frames, warped to twice as many");
        cases.push(ask(postures, frames, None, Some("as many frames")));
        cases.push(ask(twice, frames, Some(origin), Some("twice as many and back")));
    }
    cases
}

fn few(dice: &mut Dice) -> Vec<Case> {
    let counts = [
        (1, 4, "a motion of one frame"),
        (1, 1, "a motion of one frame"),
        (5, 1, "a count of 1"),
        (2, 1, "a count of 1"),
        (4, 0, "a count of 0"),
        (0, 3, "a motion without frames"),
        (0, 0, "a motion without frames"),
    ];
    let ask = |(frames, new_count, group)| {
        let postures = throws::motion(dice, frames, 2);
        ask(postures, new_count, None, Some(group))
    };
    counts.map(ask).into()
}

fn ask(postures: Vec<Posture>, new_count: usize, origin: Option<String>, group: Option<&str>) -> Case {
    let bones = postures.first().map_or(0, |posture| posture.angles.len());
    let old = format!("{}, {}", counted(postures.len(), "frame"), counted(bones, "bone"));
    let mut inputs = vec![input("old motion", old)];
    inputs.extend(origin.map(|origin| input("made from", origin)));
    if bones == 1 {
        let shown = |(frame, posture): (usize, &Posture)| {
            input(format!("angles[0] in frame {frame}"), in_degrees(&posture.angles[0]))
        };
        inputs.extend(postures.iter().enumerate().map(shown));
    }
    inputs.push(input("frames of the new motion", new_count.to_string()));
    let question = TimeWarpQuestion::Warp { postures, new_count };
    case(question, compare::motions, inputs, group.map(str::to_owned))
}
