//! The reference's hand.

use exam::Failure;
use exam::keyframes::Reduction;
use skeleton::{LocalPose, Representation};

use super::hand::{Hand, Progress};
use super::reductions::{Curves, Reductions};
use crate::motion::stage::Stage;

/// Interpolates as the solution does, and chooses keyframes greedily. Remembers the order in which it removes keyframes,
/// so that another number of them is there at once.
#[derive(Debug, Default)]
pub struct ReferenceHand {
    reductions: Reductions,
}

impl Hand for ReferenceHand {
    fn reduce(
        &mut self,
        stage: &Stage,
        representation: Representation,
        counts: &[usize],
        progress: Progress,
    ) -> Result<Vec<Reduction>, Failure> {
        Ok(self.reductions.reduce(stage, representation, counts, progress).unwrap_or_default())
    }

    fn between(
        &mut self,
        stage: &Stage,
        representation: Representation,
        start: usize,
        end: usize,
        progress: Progress,
    ) -> Result<Vec<LocalPose>, Failure> {
        let skeleton = stage.motion().skeleton();
        let (from, to) = (stage.frame(start), stage.frame(end));
        let length = end.saturating_sub(start) as f32;
        let interpolate = solutions::INTERPOLATION.interpolate_frame;
        let at =
            |frame: usize| interpolate(skeleton, &from, &to, (frame - start) as f32 / length, representation);
        let mut poses = Vec::new();
        for frame in start + 1..end {
            poses.push(at(frame));
            if progress(frame - start, end - start).is_break() {
                break;
            }
        }
        Ok(poses)
    }

    fn curves(&mut self, stage: &Stage, progress: Progress) -> Option<Curves> {
        self.reductions.curves(stage, progress)
    }
}
