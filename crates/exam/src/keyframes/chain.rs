//! The three functions together: errors of poses make costs, and costs decide which keyframes stay.

use std::cell::RefCell;
use std::collections::HashMap;

use skeleton::{Clip, FrameErrors, KeyframesFunctions, Pose, RemovalCosts, Skeleton};

use super::Reduction;

/// So many errors are kept. Then all are forgotten, and asked for again when they are wanted.
const MOST_KEPT: usize = 1 << 22;

/// The functions on one clip.
pub(super) struct Chain<'a> {
    functions: &'a KeyframesFunctions,
    skeleton: &'a Skeleton,
    clip: &'a dyn Clip,
    memory: RefCell<Memory>,
}

/// The errors of all frames of a gap are asked for together and kept: an algorithm that looks at all costs again and again
/// wants the same ones again and again.
#[derive(Default)]
struct Memory {
    gaps: HashMap<(usize, usize), Vec<f64>>,
    kept: usize,
    original: Pose,
    interpolated: Pose,
}

impl<'a> Chain<'a> {
    pub(super) fn new(
        functions: &'a KeyframesFunctions,
        skeleton: &'a Skeleton,
        clip: &'a dyn Clip,
    ) -> Chain<'a> {
        Chain { functions, skeleton, clip, memory: RefCell::default() }
    }

    /// The keyframes that stay.
    pub(super) fn reduce(&self, count: usize) -> Vec<usize> {
        let error = |start, end, frame| self.error(start, end, frame);
        let errors = FrameErrors::new(&error);
        let cost = |before, frame, after| (self.functions.removal_cost)(before, frame, after, &errors);
        (self.functions.reduce)(self.clip.frame_count(), count, &RemovalCosts::new(&cost))
    }

    /// The same, with the error that is left.
    pub(super) fn reduction(&self, count: usize) -> Reduction {
        let keyframes = self.reduce(count);
        let last = self.clip.frame_count().checked_sub(1);
        let is_whole = keyframes.first().copied() == last.map(|_| 0)
            && keyframes.last().copied() == last
            && keyframes.is_sorted_by(|a, b| a < b);
        let of_gap = |gap: &[usize]| (gap[0] + 1..gap[1]).map(|i| self.error(gap[0], gap[1], i)).sum::<f64>();
        let error = if is_whole { keyframes.windows(2).map(of_gap).sum() } else { f64::NAN };
        Reduction { keyframes, error }
    }

    /// By part 1; not a number for frames that the clip does not have.
    fn error(&self, start: usize, end: usize, frame: usize) -> f64 {
        if end >= self.clip.frame_count() {
            return f64::NAN;
        }
        let memory = &mut *self.memory.borrow_mut();
        if memory.kept > MOST_KEPT {
            memory.gaps.clear();
            memory.kept = 0;
        }
        let Memory { gaps, kept, original, interpolated } = memory;
        let gap = gaps.entry((start, end)).or_insert_with(|| {
            *kept += end - start;
            let error = |frame| {
                self.clip.original(frame, original);
                self.clip.between(start, end, frame, interpolated);
                (self.functions.pose_error)(self.skeleton, original, interpolated)
            };
            (start + 1..end).map(error).collect()
        });
        gap.get(frame - start - 1).copied().unwrap_or(f64::NAN)
    }
}
