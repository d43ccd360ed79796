//! Part 2: removals from tables of errors.

use exam::Answer;
use exam::keyframes::{Answer as KeyframesAnswer, Question as KeyframesQuestion, Triples};

use super::{Draft, input, until, ways};
use crate::dice::Dice;
use crate::keyframes::compare::list;
use crate::keyframes::wander::{errors, round, wander};

/// Frames of a longer motion.
const FRAMES: usize = 24;

/// Answers that count as different lie farther apart than this, times the largest of them: far more than is tolerated.
const APART: f64 = 0.002;

/// A cost is at least this, times the largest of all answers: then what is rounded in sums of `f32` does not matter.
const LEAST: f64 = 0.02;

/// Where the errors come from.
#[derive(Clone, Copy)]
enum Table {
    /// Every one is thrown by itself.
    Numbers,
    /// From something that moves.
    Wandering,
    /// The same, and in the frame that is removed it is far away from where it is before and after.
    Peak,
    /// Every one is thrown by itself, and those in the new gap are small.
    SmallInNewGap,
}

pub(super) fn drafts(dice: &mut Dice, check: &str) -> Vec<Draft> {
    use Table::{Numbers, Peak, SmallInNewGap, Wandering};
    let cases: &[(Table, usize, [usize; 3])] = match check {
        "first" => &[
            (Numbers, 6, [2, 3, 4]),
            (Wandering, 12, [1, 2, 3]),
            (Numbers, FRAMES, [20, 21, 22]),
            (Wandering, FRAMES, [17, 18, 19]),
        ],
        "gap" => &[
            (Numbers, 8, [2, 4, 5]),
            (Numbers, 9, [1, 2, 5]),
            (Numbers, 10, [2, 5, 8]),
            (Wandering, 12, [4, 7, 10]),
            (Wandering, FRAMES, [16, 18, 22]),
            (Wandering, FRAMES, [3, 12, 21]),
        ],
        "lower" => &[
            (SmallInNewGap, 10, [2, 5, 8]),
            (Peak, 11, [1, 5, 8]),
            (Peak, FRAMES, [14, 18, 22]),
            (Wandering, FRAMES, [11, 15, 18]),
        ],
        "edges" => &[(Numbers, 9, [0, 3, 6]), (Wandering, 14, [8, 11, 13]), (Wandering, 9, [0, 5, 8])],
        _ => &[],
    };
    let throw = |&(table, frames, keyframes): &(Table, usize, [usize; 3])| {
        let throw = || table.throw(dice, frames, keyframes);
        let errors = until(throw, |errors| tells(check, keyframes, errors));
        Draft { group: group(check, frames, keyframes), ..draft(errors, frames, keyframes) }
    };
    cases.iter().map(throw).collect()
}

impl Table {
    fn throw(self, dice: &mut Dice, frames: usize, [before, frame, after]: [usize; 3]) -> Triples {
        let mut number = |low, high| round(10.0, dice.between(low, high).into());
        match self {
            Table::Numbers => Triples::new(frames, |_, _, _| number(0.5, 20.0)),
            Table::SmallInNewGap => Triples::new(frames, |start, _, end| {
                if (start, end) == (before, after) { number(0.5, 8.0) } else { number(6.0, 20.0) }
            }),
            Table::Wandering => errors(&wander(dice, frames)),
            Table::Peak => {
                let mut positions = wander(dice, frames);
                positions[frame] += f64::from(dice.angle(15.0, 25.0));
                errors(&positions)
            }
        }
    }
}

fn question([before, frame, after]: [usize; 3], errors: &Triples) -> KeyframesQuestion {
    KeyframesQuestion::RemovalCost { before, frame, after, errors: errors.clone() }
}

/// Whether the answers of all misconceptions that this check is to cost lie apart from the right one, and in the check
/// about gaps from one another too.
fn tells(check: &str, keyframes: [usize; 3], errors: &Triples) -> bool {
    let cost = |answer: &Answer| match answer {
        Answer::Keyframes(KeyframesAnswer::RemovalCost(cost)) => *cost,
        _ => f64::NAN,
    };
    let ways = ways("part2", check, question(keyframes, errors), |_| true);
    let ways: Vec<Vec<f64>> = ways.iter().map(|answers| answers.iter().map(cost).collect()).collect();
    let scale = ways.iter().flatten().fold(0.0, |scale: f64, answer| scale.max(answer.abs()));
    let right = ways[0][0];
    let is_clear = if check == "lower" { right < -LEAST * scale } else { right > LEAST * scale };
    let [before, frame, after] = keyframes;
    if frame - before == 1 || after - frame == 1 {
        // With nothing on one side of the removed keyframe, some answers are the same.
        return is_clear;
    }
    let are_apart = |a: &[f64], b: &[f64]| a.iter().all(|a| b.iter().all(|b| (a - b).abs() > APART * scale));
    let others = |index: usize| &ways[..if check == "gap" { index } else { index.min(1) }];
    let mut all = ways.iter().enumerate();
    is_clear && all.all(|(index, way)| others(index).iter().all(|other| are_apart(way, other)))
}

/// What the report says when only some cases are wrong.
fn group(check: &str, frames: usize, [before, frame, after]: [usize; 3]) -> Option<String> {
    let name = match (check, before, after + 1 == frames) {
        ("gap", ..) => match (frame - before > 1, after - frame > 1) {
            (true, false) => "other frames only before the removed one",
            (false, _) => "other frames only behind the removed one",
            (true, true) => "other frames on both sides",
        },
        ("edges", 0, true) => "the first and the last keyframe",
        ("edges", 0, false) => "the first keyframe",
        ("edges", ..) => "the last keyframe",
        _ => return None,
    };
    Some(name.to_owned())
}

fn draft(errors: Triples, frames: usize, keyframes: [usize; 3]) -> Draft {
    let [before, frame, after] = keyframes;
    let mut inputs = vec![
        input("removed keyframe", format!("{frame}, of a motion of {frames} frames")),
        input("keyframes next to it", format!("{before} and {after}")),
    ];
    for (start, end) in [(before, after), (before, frame), (frame, after)] {
        let shown = |frame| format!("{frame}: {}", errors.get(start, frame, end));
        let shown: Vec<String> = (start + 1..end).map(shown).collect();
        inputs.push(input(format!("errors between {start} and {end}"), list(&shown, 0)));
    }
    let question = question(keyframes, &errors);
    Draft { question, inputs, group: None, size: 0.0 }
}
