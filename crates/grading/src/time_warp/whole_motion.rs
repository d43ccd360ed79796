//! The three parts together, over a short motion.

use exam::time_warp::{Answer as TimeWarpAnswer, Question as TimeWarpQuestion};
use exam::{Answer, Failure, Question};
use skeleton::acclaim::{Between, Posture};

use super::compare::{Off, first_off};
use super::throws;
use crate::compare::counted;
use crate::dice::Dice;
use crate::{Judge, Reference, Trouble, WholeMotion, WholeReport};

/// Frames of the motion, its bones, and how many frames it is to have. Every fifth new frame is an old one.
const FRAMES: usize = 12;
const BONES: usize = 6;
const NEW_COUNT: usize = 30;

/// A motion of some bones, warped by all parts together.
pub(super) fn paper(dice: &mut Dice, reference: &dyn Reference) -> WholeMotion {
    let postures = throws::motion(dice, FRAMES, BONES);
    let question = Question::TimeWarp(TimeWarpQuestion::Motion { postures, new_count: NEW_COUNT });
    let judge = Box::new(RightMotion { expected: reference.answer(&question) });
    WholeMotion { question, judge }
}

/// Knows the warped motion.
#[derive(Debug)]
struct RightMotion {
    expected: Answer,
}

impl Judge for RightMotion {
    fn judge(&self, answer: &Answer) -> WholeReport {
        let (Some(expected), Some(got)) = (postures(&self.expected), postures(answer)) else {
            let why = "it is no motion".to_owned();
            return WholeReport::failed(Failure::Unreadable { why });
        };
        let praise = format!(
            "With your three functions, {FRAMES} frames become {NEW_COUNT}, and in all of them every bone is turned and \
             placed as it should be."
        );
        let trouble = if got.len() == expected.len() { off(expected, got) } else { Some(other_count(got)) };
        WholeReport { frames: NEW_COUNT, praise, trouble }
    }
}

fn postures(answer: &Answer) -> Option<&[Posture]> {
    match answer {
        Answer::TimeWarp(TimeWarpAnswer::Motion(postures)) => Some(postures),
        _ => None,
    }
}

fn other_count(got: &[Posture]) -> Trouble {
    let frames = counted(got.len(), "frame");
    let summary =
        format!("With your three functions, the new motion has {frames}, and not as many as were asked for.");
    Trouble::Different { summary, details: vec![format!("{FRAMES} frames were to become {NEW_COUNT}.")] }
}

fn off(expected: &[Posture], got: &[Posture]) -> Option<Trouble> {
    let pairs = expected.iter().zip(got).enumerate();
    let all: Vec<(usize, Off)> =
        pairs.filter_map(|(frame, (right, got))| Some((frame, first_off(right, got)?))).collect();
    let (frame, first) = all.first()?;
    let summary = format!(
        "With your three functions, {} of {NEW_COUNT} frames are off. The first of them is frame {frame}: {}.",
        all.len(),
        in_words(first)
    );
    let Between { before, after, t } = solutions::time_warp::old_position(*frame, FRAMES, NEW_COUNT);
    let place = if before == after {
        format!("Frame {frame} is the old frame {before}.")
    } else {
        format!("Frame {frame} is between the old frames {before} and {after}, at t = {t:.2}.")
    };
    let mut details = vec![
        place,
        format!("Yours: {}.", first.difference.got),
        format!("Expected: {}.", first.difference.expected),
    ];
    let is_old = |frame: usize| (frame * FRAMES).is_multiple_of(NEW_COUNT);
    if !all.iter().any(|(frame, _)| is_old(*frame)) {
        details.push(
            "Wherever a new frame is an old one, it is right: it is what is between that is not.".to_owned(),
        );
    }
    Some(Trouble::Different { summary, details })
}

fn in_words(off: &Off) -> String {
    match off.bone {
        Some(bone) => format!("bone {bone} is off there, by {}", off.difference.between),
        None => "it has not as many bones as the motion".to_owned(),
    }
}
