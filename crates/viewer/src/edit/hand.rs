//! Who does the work.

use std::ops::ControlFlow;

use exam::Failure;
use exam::keyframes::Reduction;
use skeleton::{LocalPose, Representation};

use super::reductions::{Curves, Reductions};
use crate::motion::stage::Stage;

/// Told how much is done and how much there is to do. When it breaks, the work is to be left as it is.
pub type Progress<'a> = &'a mut dyn FnMut(usize, usize) -> ControlFlow<()>;

/// Interpolates, and chooses keyframes: the reference, or a student's functions where the exercise is theirs.
///
/// It is asked on a thread of its own and may take its time. What comes of work that `progress` broke off is of no use. Where
/// nobody knows how far the work is, nothing is told.
pub trait Hand: Send {
    /// Reduces the motion to each of these numbers of keyframes.
    ///
    /// # Errors
    ///
    /// When a student's functions gave no answer.
    fn reduce(
        &mut self,
        stage: &Stage,
        representation: Representation,
        counts: &[usize],
        progress: Progress,
    ) -> Result<Vec<Reduction>, Failure>;

    /// All frames between the keyframes `start` and `end`, without these two.
    ///
    /// # Errors
    ///
    /// When a student's functions gave no answer.
    fn between(
        &mut self,
        stage: &Stage,
        representation: Representation,
        start: usize,
        end: usize,
        progress: Progress,
    ) -> Result<Vec<LocalPose>, Failure>;

    /// Whose functions these are.
    fn makers(&self) -> Makers {
        Makers::default()
    }

    /// How the error grows in both representations, by the reference. `None` when `progress` breaks.
    fn curves(&mut self, stage: &Stage, progress: Progress) -> Option<Curves> {
        Reductions::default().curves(stage, progress)
    }
}

/// Who chooses the keyframes, and who makes the frames between them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Makers {
    /// The keyframes.
    pub keyframes: Maker,
    /// The frames between.
    pub between: Maker,
}

/// Whose functions are at work.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Maker {
    /// The reference's.
    #[default]
    Reference,
    /// The student's.
    Student,
}
