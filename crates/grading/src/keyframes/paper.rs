//! The questions of the exam on keyframes.

mod gaps;
mod poses;
pub(super) mod reductions;

use exam::keyframes::Question as KeyframesQuestion;
use exam::{Answer, Functions, Question};

use super::misconceptions::misconceptions;
use super::{RUBRIC, TEMPLATE, compare, whole_motion};
use crate::dice::{self, Dice};
use crate::exam_paper::{Known, input};
use crate::{Case, Exam, Misconception, Reference};

/// The exam on keyframes. The same seed gives the same questions.
pub fn exam(seed: u64, reference: &dyn Reference) -> Exam {
    let known = Known { template: Functions::keyframes(TEMPLATE), accepted: |_| Vec::new(), misconceptions };
    Exam::fill(
        &RUBRIC,
        &known,
        |part, check| cases(seed, reference, part, check),
        whole_motion::paper(seed, reference),
    )
}

fn cases(seed: u64, reference: &dyn Reference, part: &str, check: &str) -> Vec<Case> {
    let dice = &mut Dice::new(seed, &format!("keyframes {part} {check}"));
    let drafts = match part {
        "part1" => poses::drafts(dice, check),
        "part2" => gaps::drafts(dice, check),
        "part3" => reductions::drafts(dice, check),
        _ => Vec::new(),
    };
    let case = |draft: Draft| {
        let Draft { question, inputs, group, size } = draft;
        let question = Question::Keyframes(question);
        let expected = reference.answer(&question);
        Case { question, expected, difference: compare::difference, inputs, group, size }
    };
    drafts.into_iter().map(case).collect()
}

/// A case without its answer.
struct Draft {
    question: KeyframesQuestion,
    inputs: Vec<(String, String)>,
    group: Option<String>,
    /// The extent of the skeleton; 0 where there is none.
    size: f32,
}

/// What each way to understand a question answers: the right way first, and then each misconception that a check is to
/// cost and that `shows` here, with all its variants.
fn ways(
    part: &str,
    check: &str,
    question: KeyframesQuestion,
    shows: impl Fn(&Misconception) -> bool,
) -> Vec<Vec<Answer>> {
    let question = Question::Keyframes(question);
    let right = question.ask(&Functions::keyframes(solutions::KEYFRAMES));
    let all = misconceptions(part);
    let wrong =
        all.iter().filter(|misconception| misconception.costs.contains(&check) && shows(misconception));
    let answers = wrong.map(|one| one.variants.iter().map(|variant| question.ask(variant)).collect());
    [vec![right]].into_iter().chain(answers).collect()
}

/// So often dice are thrown for a question. Far fewer throws are needed, which a test makes sure of.
const MOST_THROWS: usize = 5000;

/// Throws the dice until a question tells the misconceptions apart.
pub(super) fn until<T>(throw: impl FnMut() -> T, tells: impl Fn(&T) -> bool) -> T {
    dice::until(MOST_THROWS, throw, tells)
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
