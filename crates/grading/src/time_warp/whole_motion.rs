//! The three parts together, over a short motion.

use exam::time_warp::{Answer as TimeWarpAnswer, Question as TimeWarpQuestion};
use exam::{Answer, Failure, Question};
use skeleton::acclaim::{Between, Posture};

use super::compare::{Off, first_off};
use super::misconceptions::accepted;
use super::throws;
use crate::compare::{NOT_A_NUMBER, counted};
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
    let expected = reference.answer(&question);
    let judge = Box::new(RightMotion { question: question.clone(), expected });
    WholeMotion { question, judge }
}

/// Knows the warped motion.
#[derive(Debug)]
struct RightMotion {
    question: Question,
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
        let trouble = if got.len() != expected.len() {
            Some(other_count(got))
        } else {
            off(expected, got).filter(|_| !self.is_accepted(got))
        };
        WholeReport { frames: NEW_COUNT, praise, trouble }
    }
}

impl RightMotion {
    /// What part 2 accepts is accepted here too.
    fn is_accepted(&self, got: &[Posture]) -> bool {
        accepted("part2").iter().any(|way| {
            let answer = self.question.ask(&way.functions);
            postures(&answer).is_some_and(|way| off(way, got).is_none())
        })
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
    let place = if is_after_the_last(*frame) {
        format!("Frame {frame} is after the last old frame, which stays.")
    } else if before == after {
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
    let is_between = |frame: usize| !is_old(frame) && !is_after_the_last(frame);
    let any = |kind: &dyn Fn(usize) -> bool| all.iter().any(|(frame, _)| kind(*frame));
    if any(&is_between) && !any(&is_old) {
        details.push(
            "Wherever a new frame is an old one, it is right: it is what is between that is not.".to_owned(),
        );
    }
    Some(Trouble::Different { summary, details })
}

/// Whether there is no old frame after the place of this new one.
fn is_after_the_last(frame: usize) -> bool {
    frame * FRAMES > (FRAMES - 1) * NEW_COUNT
}

fn in_words(off: &Off) -> String {
    match off.bone {
        Some(bone) if off.difference.between == NOT_A_NUMBER => {
            format!("bone {bone} is not a number there (NaN), or infinite: look for a division by zero")
        }
        Some(bone) => format!("bone {bone} is off there, by {}", off.difference.between),
        None => "it has not as many bones as the motion".to_owned(),
    }
}
