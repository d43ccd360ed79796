//! The questions of the exam on Acclaim forward kinematics.

mod ends;
mod rotations;
mod visits;

use exam::acclaim::Question as AcclaimQuestion;
use exam::{Answer, Functions, Question};

use super::misconceptions::{accepted, misconceptions};
use super::{RUBRIC, TEMPLATE, whole_motion};
use crate::dice::Dice;
use crate::exam_paper::{Known, input};
use crate::{Case, Difference, Exam, Reference};

/// The exam on Acclaim forward kinematics. The same seed gives the same questions.
pub fn exam(seed: u64, reference: &dyn Reference) -> Exam {
    let known = Known { template: Functions::Acclaim(TEMPLATE), accepted, misconceptions };
    Exam::fill(
        &RUBRIC,
        &known,
        |part, check| cases(seed, reference, part, check),
        whole_motion::paper(seed, reference),
    )
}

fn cases(seed: u64, reference: &dyn Reference, part: &str, check: &str) -> Vec<Case> {
    let dice = &mut Dice::new(seed, &format!("acclaim {part} {check}"));
    let drafts = match part {
        "part1" => rotations::drafts(dice, check),
        "part2" => ends::drafts(dice, check),
        "part3" => visits::drafts(dice, check),
        _ => Vec::new(),
    };
    let case = |draft: Draft| {
        let Draft { question, inputs, difference, group, size } = draft;
        let question = Question::Acclaim(question);
        let expected = reference.answer(&question);
        Case { question, expected, difference, inputs, group, size }
    };
    drafts.into_iter().map(case).collect()
}

/// A case without its answer.
struct Draft {
    question: AcclaimQuestion,
    inputs: Vec<(String, String)>,
    difference: fn(&Case, &Answer, &Answer) -> Option<Difference>,
    group: Option<String>,
    /// The extent of the skeleton.
    size: f32,
}
