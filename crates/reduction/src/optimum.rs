//! The least error that so many keyframes can have.

use std::ops::ControlFlow;

use crate::Errors;

/// The best reduction of a motion to so many keyframes.
#[derive(Clone, Debug, PartialEq)]
pub struct Optimum {
    /// In ascending order.
    pub keyframes: Vec<usize>,
    /// Their accumulated error.
    pub error: f64,
    /// The longest gap that was looked at, where not all were.
    pub cap: Option<usize>,
}

/// The `count` keyframes with the least error of all, by dynamic programming: the shortest way from the first frame to the last
/// over exactly `count` of them, where the length of a step is the error of its gap.
///
/// `cap` is the longest gap that may be between two keyframes, in frames from one to the other: the result is the best among
/// the reductions that keep to it. Without it, the result is the best of all.
///
/// `progress` is told how many frames have been reached, and how many there are. `None` when it breaks, and when no reduction
/// keeps to `cap`.
pub fn optimum(
    errors: &Errors,
    count: usize,
    cap: Option<usize>,
    progress: &mut dyn FnMut(usize, usize) -> ControlFlow<()>,
) -> Option<Optimum> {
    let frame_count = errors.frame_count();
    let count = count.max(2).min(frame_count);
    let longest = cap.unwrap_or(frame_count);
    // best[frame][n]: the least error of a way from frame 0 to here over n steps, and the frame before.
    let mut best: Vec<Vec<Option<(f64, usize)>>> = vec![vec![None; count]; frame_count];
    if frame_count > 0 {
        best[0][0] = Some((0.0, 0));
    }
    for end in 1..frame_count {
        for start in end.saturating_sub(longest)..end {
            let gap = errors.of_gap(start, end);
            let gap = if gap.is_nan() { f64::INFINITY } else { gap };
            for steps in 1..count {
                let Some((error, _)) = best[start][steps - 1] else { continue };
                let error = error + gap;
                if best[end][steps].is_none_or(|(least, _)| error < least) {
                    best[end][steps] = Some((error, start));
                }
            }
        }
        if progress(end, frame_count - 1).is_break() {
            return None;
        }
    }
    let mut keyframes = Vec::with_capacity(count);
    if frame_count > 0 {
        let mut frame = frame_count - 1;
        for steps in (0..count).rev() {
            keyframes.push(frame);
            frame = best[frame][steps]?.1;
        }
    }
    keyframes.reverse();
    Some(Optimum { error: errors.of_keyframes(&keyframes), keyframes, cap })
}
