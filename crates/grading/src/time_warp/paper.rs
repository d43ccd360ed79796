//! The questions of the exam on time warping.

mod blends;
mod motions;
mod places;

use exam::time_warp::Question as TimeWarpQuestion;
use exam::{Answer, Functions, Question};

use super::misconceptions::{accepted, misconceptions};
use super::{RUBRIC, TEMPLATE, whole_motion};
use crate::dice::{self, Dice};
use crate::exam_paper::{Known, input};
use crate::{Case, Difference, Exam, Reference};

/// The exam on time warping. The same seed gives the same questions.
pub fn exam(seed: u64, reference: &dyn Reference) -> Exam {
    let known = Known { template: Functions::TimeWarp(TEMPLATE), accepted, misconceptions };
    let whole_motion = whole_motion::paper(&mut dice(seed, "whole motion"), reference);
    Exam::fill(&RUBRIC, &known, |part, check| cases(seed, reference, part, check), whole_motion)
}

fn dice(seed: u64, topic: &str) -> Dice {
    Dice::new(seed, &format!("time warp {topic}"))
}

fn cases(seed: u64, reference: &dyn Reference, part: &str, check: &str) -> Vec<Case> {
    let dice = &mut dice(seed, &format!("{part} {check}"));
    let throw = || match part {
        "part1" => places::cases(dice, check),
        "part2" => blends::cases(dice, check),
        "part3" => motions::cases(dice, check),
        _ => Vec::new(),
    };
    let cases = until(throw, |cases| tell(part, check, cases));
    cases.into_iter().map(|case| Case { expected: reference.answer(&case.question), ..case }).collect()
}

type Compare = fn(&Case, &Answer, &Answer) -> Option<Difference>;

fn case(
    question: TimeWarpQuestion,
    difference: Compare,
    inputs: Vec<(String, String)>,
    group: Option<String>,
) -> Case {
    let question = Question::TimeWarp(question);
    let expected = question.ask(&Functions::TimeWarp(solutions::TIME_WARP));
    Case { question, expected, difference, inputs, group, size: 1.0 }
}

/// Whether each misconception that is to cost this check gives a wrong answer to one of these questions, in each of its
/// variants.
fn tell(part: &str, check: &str, cases: &[Case]) -> bool {
    let is_wrong =
        |case: &Case, variant| (case.difference)(case, &case.expected, &case.question.ask(variant)).is_some();
    misconceptions(part)
        .iter()
        .filter(|misconception| misconception.costs.contains(&check))
        .flat_map(|misconception| &misconception.variants)
        .all(|variant| cases.iter().any(|case| is_wrong(case, variant)))
}

/// So often dice are thrown for a question. Far fewer throws are needed, which a test makes sure of.
const MOST_THROWS: usize = 2000;

/// Throws the dice until what they show will do.
pub(super) fn until<T>(throw: impl FnMut() -> T, will_do: impl Fn(&T) -> bool) -> T {
    dice::until(MOST_THROWS, throw, will_do)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Solutions;

    #[test]
    fn on_no_seed_the_dice_are_thrown_in_vain() {
        for seed in 0..100 {
            exam(seed * 104_729, &Solutions);
        }
    }
}
