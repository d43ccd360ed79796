//! An exam: the rubric, filled with questions and right answers.

use std::fmt;

use crate::{Accepted, CheckRubric, Misconception, PartRubric, Rubric, WholeReport};
use exam::{Answer, Functions, Question};

/// The questions of one exercise from one seed.
#[derive(Debug)]
pub struct Exam {
    /// What the parts are worth.
    pub rubric: &'static Rubric,
    /// The parts in the rubric's order.
    pub parts: Vec<PartPaper>,
    /// All parts together, over a whole motion.
    pub whole_motion: WholeMotion,
}

/// What is known of an exercise's functions beforehand, apart from the right ones.
pub(crate) struct Known {
    /// The untouched template.
    pub template: Functions,
    /// Of a part, by its id: ways that get full points, with a remark.
    pub accepted: fn(&str) -> Vec<Accepted>,
    /// Of a part, by its id: ways to be wrong that have a name.
    pub misconceptions: fn(&str) -> Vec<Misconception>,
}

impl Exam {
    /// Fills the rubric with questions: `cases` are those of a part and a check, by their ids.
    pub(crate) fn fill(
        rubric: &'static Rubric,
        known: &Known,
        cases: impl Fn(&str, &str) -> Vec<Case>,
        whole_motion: WholeMotion,
    ) -> Exam {
        let part = |part: &'static PartRubric| {
            let check =
                |rubric: &'static CheckRubric| CheckPaper { rubric, cases: cases(part.id, rubric.id) };
            PartPaper {
                rubric: part,
                checks: part.checks.iter().map(check).collect(),
                template: known.template,
                accepted: (known.accepted)(part.id),
                misconceptions: (known.misconceptions)(part.id),
            }
        };
        Exam { rubric, parts: rubric.parts.iter().map(part).collect(), whole_motion }
    }
}

/// An input as a student reads it: its name, and its value with its unit.
pub(crate) fn input(name: impl Into<String>, value: impl Into<String>) -> (String, String) {
    (name.into(), value.into())
}

/// The questions of one part.
#[derive(Debug)]
pub struct PartPaper {
    /// What the part is worth.
    pub rubric: &'static PartRubric,
    /// The checks in the rubric's order.
    pub checks: Vec<CheckPaper>,
    /// The untouched template: who answers like this has not started.
    pub template: Functions,
    /// Ways that get full points, with a remark.
    pub accepted: Vec<Accepted>,
    /// Ways to be wrong that have a name.
    pub misconceptions: Vec<Misconception>,
}

/// The cases of one check.
#[derive(Debug)]
pub struct CheckPaper {
    /// What the check is worth.
    pub rubric: &'static CheckRubric,
    /// From easy to hard.
    pub cases: Vec<Case>,
}

/// One question with its right answer.
#[derive(Debug)]
pub struct Case {
    /// What is asked.
    pub question: Question,
    /// The right answer.
    pub expected: Answer,
    /// What of the answer counts here: given the right answer and another one, where they differ.
    pub difference: fn(&Case, expected: &Answer, got: &Answer) -> Option<Difference>,
    /// The inputs as a student reads them, each with its name and unit.
    pub inputs: Vec<(String, String)>,
    /// What cases of one check can be told apart by, when only some of them are wrong: for example the rotation order.
    pub group: Option<String>,
    /// The size of the skeleton behind the question: the measure of position tolerances.
    pub size: f32,
}

/// How two answers differ, as a student reads it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Difference {
    /// What came.
    pub got: String,
    /// What should have come.
    pub expected: String,
    /// How far apart they are, with a unit.
    pub between: String,
}

/// The question that chains all parts over a motion. It gives no points: it shows what the parts do together.
#[derive(Debug)]
pub struct WholeMotion {
    /// All of it in one question.
    pub question: Question,
    /// What tells how good an answer is.
    pub judge: Box<dyn Judge>,
}

/// Judges what all parts have made of a motion.
pub trait Judge: fmt::Debug + Send + Sync {
    /// Compares the answer with the right one.
    fn judge(&self, answer: &Answer) -> WholeReport;
}
