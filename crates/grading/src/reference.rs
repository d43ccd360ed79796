//! Where right answers come from.

use exam::{Answer, Functions, Question};

/// Knows the right answer to every question. The solutions compute it; answers recorded beforehand would do as well.
pub trait Reference {
    /// The right answer.
    fn answer(&self, question: &Question) -> Answer;
}

/// The reference that computes its answers by the `solutions` crate.
#[derive(Clone, Copy, Debug, Default)]
pub struct Solutions;

impl Reference for Solutions {
    fn answer(&self, question: &Question) -> Answer {
        match question {
            Question::Fk(_) => question.ask(&Functions::Fk(solutions::FK)),
            Question::Interpolation(_) => question.ask(&Functions::Interpolation(solutions::INTERPOLATION)),
            Question::Keyframes(_) => question.ask(&Functions::keyframes(solutions::KEYFRAMES)),
            Question::Acclaim(_) => question.ask(&Functions::Acclaim(solutions::ACCLAIM)),
            Question::TimeWarp(_) => question.ask(&Functions::TimeWarp(solutions::TIME_WARP)),
        }
    }
}
