//! The least error that so many keyframes can have.

use std::ops::{ControlFlow, RangeInclusive};

use crate::{Errors, greedy, local_moves};

/// Rounding must not rule out a way that is as good as the best one known.
const ROUNDING: f64 = 1e-9;

/// The best reduction of a motion to so many keyframes.
#[derive(Clone, Debug, PartialEq)]
pub struct Optimum {
    /// In ascending order.
    pub keyframes: Vec<usize>,
    /// Their accumulated error.
    pub error: f64,
    /// The longest gap that was allowed, when not every one was.
    pub cap: Option<usize>,
}

/// The `count` keyframes with the least error of all, by dynamic programming: the shortest way from the first frame
/// to the last over exactly so many, where the length of a step is the error of its gap.
///
/// `cap` is the longest gap that may be between two keyframes, counted from one to the other. Then the result is the
/// best of all reductions that keep to it; without it, the best of all.
///
/// A gap is not posed to its end once it is worse than a whole reduction that is known. How much work that saves
/// depends on the motion: at least it grows with the frames times `cap`, or, without, with the square of the frames.
/// It takes memory for a few numbers for each frame and keyframe, so that it is not for motions of tens of thousands
/// of frames.
///
/// `progress` is told how many frames have been reached, and how many there are to be reached. `None` when it breaks,
/// and when no reduction keeps to `cap`.
pub fn optimum(
    errors: &Errors,
    count: usize,
    cap: Option<usize>,
    progress: &mut dyn FnMut(usize, usize) -> ControlFlow<()>,
) -> Option<Optimum> {
    let frame_count = errors.frame_count();
    let count = count.max(2).min(frame_count);
    let Some(last) = frame_count.checked_sub(1) else {
        return Some(Optimum { keyframes: Vec::new(), error: 0.0, cap });
    };
    let longest = cap.unwrap_or(last);
    let enough = known(errors, count, longest, &mut |_, _| progress(0, last))? * (1.0 + ROUNDING);
    let steps = |frame: usize| (count - 1).saturating_sub(last - frame)..=frame.min(count - 1);
    let mut ways: Vec<Ways> = Vec::with_capacity(frame_count);
    ways.push(Ways { steps: 0..=0, errors: vec![0.0], before: vec![0] });
    for end in 1..frame_count {
        let mut to_end = Ways::none(steps(end));
        for (start, from) in ways.iter().enumerate().skip(end.saturating_sub(longest)) {
            let Some(gap) = errors.of_gap_up_to(start, end, enough) else { continue };
            to_end.extend(from, start, if gap.is_nan() { f64::INFINITY } else { gap });
        }
        ways.push(to_end);
        if progress(end, last).is_break() {
            return None;
        }
    }
    let mut keyframes = vec![last];
    let mut frame = last;
    for steps in (1..count).rev() {
        frame = ways[frame].before(steps)?;
        keyframes.push(frame);
    }
    keyframes.reverse();
    Some(Optimum { error: errors.of_keyframes(&keyframes), keyframes, cap })
}

/// The error of some good reduction whose gaps are at most `longest`, infinite when none is a number; `None` when
/// there is no such reduction, or `progress` breaks.
fn known(
    errors: &Errors,
    count: usize,
    longest: usize,
    progress: &mut dyn FnMut(usize, usize) -> ControlFlow<()>,
) -> Option<f64> {
    let last = errors.frame_count() - 1;
    let fits = |keyframes: &[usize]| keyframes.windows(2).all(|gap| gap[1] - gap[0] <= longest);
    let spread: Vec<usize> = (0..count).map(|index| index * last / (count - 1).max(1)).collect();
    if !fits(&spread) {
        return None;
    }
    let mut best = f64::INFINITY;
    for keyframes in [greedy(errors, count), spread] {
        let mut goes_on = ControlFlow::Continue(());
        let moved = local_moves(errors, &keyframes, &mut |settled, all| {
            goes_on = progress(settled, all);
            goes_on
        });
        if goes_on.is_break() {
            return None;
        }
        for keyframes in [keyframes, moved] {
            if fits(&keyframes) {
                best = best.min(errors.of_keyframes(&keyframes));
            }
        }
    }
    Some(best)
}

/// The best ways from the first frame to one frame, one for each number of steps.
struct Ways {
    /// More steps do not lead here, and with fewer the last frame cannot be reached.
    steps: RangeInclusive<usize>,
    errors: Vec<f64>,
    /// The frame before; `NOWHERE` where there is no way.
    before: Vec<usize>,
}

const NOWHERE: usize = usize::MAX;

impl Ways {
    fn none(steps: RangeInclusive<usize>) -> Ways {
        let count = steps.clone().count();
        Ways { steps, errors: vec![f64::INFINITY; count], before: vec![NOWHERE; count] }
    }

    /// Takes the ways to `start` where, with one more step of length `gap`, they are shorter than those that are known.
    fn extend(&mut self, to_start: &Ways, start: usize, gap: f64) {
        let first = (*to_start.steps.start() + 1).max(*self.steps.start());
        let last = (*to_start.steps.end() + 1).min(*self.steps.end());
        for steps in first..=last {
            let (old, new) = (steps - 1 - to_start.steps.start(), steps - self.steps.start());
            let error = to_start.errors[old] + gap;
            if to_start.before[old] != NOWHERE && (self.before[new] == NOWHERE || error < self.errors[new]) {
                self.errors[new] = error;
                self.before[new] = start;
            }
        }
    }

    fn before(&self, steps: usize) -> Option<usize> {
        let index = steps.checked_sub(*self.steps.start())?;
        self.before.get(index).copied().filter(|before| *before != NOWHERE)
    }
}
