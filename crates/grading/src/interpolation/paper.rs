//! The questions of the exam on interpolation.

mod angles;
mod frame;
mod slerp;

use exam::interpolation::Question as InterpolationQuestion;
use exam::{Answer, Functions, Question};

use super::misconceptions::{accepted, misconceptions};
use super::{RUBRIC, TEMPLATE};
use crate::dice::Dice;
use crate::exam_paper::{Known, input};
use crate::figure::figure;
use crate::{Case, Difference, Exam, Reference};

/// The exam on interpolation. The same seed gives the same questions.
pub fn exam(seed: u64, reference: &dyn Reference) -> Exam {
    let writer = Writer { seed, reference };
    let known = Known { template: Functions::Interpolation(TEMPLATE), accepted, misconceptions };
    let skeleton = writer.skeleton();
    let whole_motion = frame::whole_motion(&writer, &mut writer.dice("whole motion"), &skeleton);
    Exam::fill(&RUBRIC, &known, |part, check| writer.cases(part, check), whole_motion)
}

type Compare = fn(&Case, &Answer, &Answer) -> Option<Difference>;

struct Writer<'a> {
    seed: u64,
    reference: &'a dyn Reference,
}

impl Writer<'_> {
    fn cases(&self, part: &str, check: &str) -> Vec<Case> {
        let dice = &mut self.dice(&format!("{part} {check}"));
        match (part, check) {
            ("part1", "near") => angles::near(self, dice),
            ("part1", "across") => angles::across(self, dice),
            ("part1", "turns") => angles::turns(self, dice),
            ("part1", "ends") => angles::ends(self, dice),
            ("part2", "near") => slerp::near(self, dice),
            ("part2", "shorter_way") => slerp::shorter_way(self, dice),
            ("part2", "close") => slerp::close(self, dice),
            ("part2", "ends") => slerp::ends(self, dice),
            ("part3", "positions") => frame::positions(self, dice, &self.skeleton()),
            ("part3", check) => frame::rotations(self, dice, &self.skeleton(), check),
            _ => Vec::new(),
        }
    }

    fn dice(&self, topic: &str) -> Dice {
        Dice::new(self.seed, &format!("interpolation {topic}"))
    }

    fn skeleton(&self) -> skeleton::Skeleton {
        figure(&mut self.dice("figure"))
    }

    fn case(
        &self,
        question: InterpolationQuestion,
        inputs: Vec<(String, String)>,
        difference: Compare,
    ) -> Case {
        let question = Question::Interpolation(question);
        let expected = self.reference.answer(&question);
        Case { question, expected, difference, inputs, group: None, size: 1.0 }
    }
}

/// Values for `t` between the ends. Half-way, which comes first, even some wrong ways are right.
const BETWEEN: [f32; 6] = [0.5, 0.25, 0.1, 0.7, 0.3, 0.9];

/// At both ends, before the first and beyond the second.
const ENDS: [f32; 6] = [0.0, 1.0, -0.5, 1.5, -3.0, 4.0];

/// 1 and −1 in turns.
fn sign(number: usize) -> f32 {
    if number.is_multiple_of(2) { 1.0 } else { -1.0 }
}
