//! Who does the work.

use exam::Failure;
use exam::keyframes::Reduction;
use skeleton::{LocalPose, Representation};

use crate::motion::stage::Stage;

/// Interpolates, and chooses keyframes: the reference, or a student's functions where the exercise is theirs.
///
/// It is asked on a thread of its own and may take its time.
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
    ) -> Result<Vec<LocalPose>, Failure>;
}
