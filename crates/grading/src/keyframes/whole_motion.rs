//! The three parts together, over a short motion.

use exam::keyframes::{Answer as KeyframesAnswer, Question as KeyframesQuestion, Triples};
use exam::{Answer, Failure, Question};

use super::clip;
use super::compare::{between_keyframes, list};
use super::misconceptions::misconceptions;
use super::paper::{reductions::is_clear, until};
use crate::dice::Dice;
use crate::{Difference, Judge, Reference, Trouble, WholeMotion, WholeReport};

/// Frames of the motion, and how many of them are to stay keyframes.
const FRAMES: usize = 20;
const COUNT: usize = 6;

/// One misconception of each part leads to other keyframes of the motion. Not all can, on one motion: errors that are all
/// halved never do.
const TELLING: [(&str, &str); 3] =
    [("part1", "end_sites_only"), ("part2", "new_gap_only"), ("part3", "never_refreshed")];

/// All parts together, over a motion from this seed.
pub(super) fn paper(seed: u64, reference: &dyn Reference) -> WholeMotion {
    let dice = &mut Dice::new(seed, "keyframes whole motion");
    let question = Question::Keyframes(until(|| clip::question(dice, FRAMES, COUNT), tells));
    let judge = Box::new(RightKeyframes { expected: reference.answer(&question) });
    WholeMotion { question, judge }
}

/// Whether it never hangs on rounding which keyframe goes next, and misconceptions lead to others.
fn tells(question: &KeyframesQuestion) -> bool {
    let KeyframesQuestion::Chain { skeleton, originals, between, .. } = question else { return false };
    let mut poses = between.iter();
    let errors = Triples::new(FRAMES, |_, frame, _| {
        let error = |pose| solutions::keyframes::pose_error(skeleton, &originals[frame], pose);
        poses.next().map_or(f64::NAN, error)
    });
    let gap = |start, end| (start + 1..end).map(|frame| errors.get(start, frame, end)).sum::<f64>();
    let cost = |before, frame, after| gap(before, after) - gap(before, frame) - gap(frame, after);
    if !is_clear(FRAMES, COUNT, cost, |before, _, after| gap(before, after)) {
        return false;
    }
    let question = Question::Keyframes(question.clone());
    let right = question.ask(&exam::Functions::keyframes(solutions::KEYFRAMES));
    TELLING.iter().all(|(part, id)| {
        let all = misconceptions(part);
        let variants = all.iter().filter(|one| one.id == *id).flat_map(|one| &one.variants);
        variants.into_iter().all(|variant| question.ask(variant) != right)
    })
}

/// Knows which keyframes stay.
#[derive(Debug)]
struct RightKeyframes {
    expected: Answer,
}

impl Judge for RightKeyframes {
    fn judge(&self, answer: &Answer) -> WholeReport {
        let (Some(expected), Some(got)) = (keyframes(&self.expected), keyframes(answer)) else {
            let why = "it is no list of keyframes".to_owned();
            return WholeReport::failed(Failure::Unreadable { why });
        };
        let trouble = |Difference { got, expected, between }| Trouble::Different {
            summary: "With your three functions together, other keyframes stay than should.".to_owned(),
            details: vec![
                format!("Yours: {got}."),
                format!("Expected: {expected}."),
                format!("Difference: {between}."),
            ],
        };
        WholeReport {
            frames: FRAMES,
            praise: format!(
                "With your three functions, {FRAMES} frames become {} keyframes: {}.",
                expected.len(),
                list(expected, 0)
            ),
            trouble: between_keyframes(expected, got, FRAMES).map(trouble),
        }
    }
}

fn keyframes(answer: &Answer) -> Option<&[usize]> {
    match answer {
        Answer::Keyframes(KeyframesAnswer::Reduce(keyframes)) => Some(keyframes),
        _ => None,
    }
}
