//! The questions of the exam on time warping.

mod blends;
mod motions;
mod places;

use exam::time_warp::Question as TimeWarpQuestion;
use exam::{Answer, Functions, Question};

use super::misconceptions::misconceptions;
use super::{RUBRIC, TEMPLATE, whole_motion};
use crate::dice::Dice;
use crate::{Case, CheckPaper, Difference, Exam, PartPaper, Reference};

/// The exam on time warping. The same seed gives the same questions.
pub fn exam(seed: u64, reference: &dyn Reference) -> Exam {
    let parts = RUBRIC.parts.iter().map(|rubric| PartPaper {
        rubric,
        checks: rubric
            .checks
            .iter()
            .map(|check| CheckPaper { rubric: check, cases: cases(seed, reference, rubric.id, check.id) })
            .collect(),
        template: Functions::TimeWarp(TEMPLATE),
        accepted: Vec::new(),
        misconceptions: misconceptions(rubric.id),
    });
    let whole_motion = whole_motion::paper(&mut dice(seed, "whole motion"), reference);
    Exam { rubric: &RUBRIC, parts: parts.collect(), whole_motion }
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
pub(super) fn until<T>(mut throw: impl FnMut() -> T, will_do: impl Fn(&T) -> bool) -> T {
    for _ in 1..MOST_THROWS {
        let thrown = throw();
        if will_do(&thrown) {
            return thrown;
        }
    }
    #[cfg(test)]
    unreachable!("{MOST_THROWS} throws, and none will do");
    #[cfg(not(test))]
    throw()
}

fn input(name: impl Into<String>, value: impl Into<String>) -> (String, String) {
    (name.into(), value.into())
}

/// With two decimals, as in a file.
pub(super) fn two_decimals(number: f32) -> f32 {
    (number * 100.0).round() / 100.0
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
