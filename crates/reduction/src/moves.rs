//! Keyframes moved between their neighbours, as long as that helps.

use std::ops::ControlFlow;

use crate::Errors;

/// A move must make the error of the two gaps around a keyframe smaller by more than this part of it: what is less is
/// rounding.
const LEAST_GAIN: f64 = 1e-9;

/// Moves each keyframe between the first and the last one to the best place between its neighbours, again and again,
/// until no single move helps. Of several best places the earliest is taken. Each move makes the error smaller, so
/// that it ends.
///
/// `keyframes` may come in any order. Those that the motion does not have are left out, and the first and the last
/// frame are added.
///
/// `progress` is told how many keyframes are in their best place, as far as is known, and how many there are to be
/// moved; the first number falls when a move leaves its neighbours to be looked at again. When it breaks, the
/// keyframes are left as they are then.
pub fn local_moves(
    errors: &Errors,
    keyframes: &[usize],
    progress: &mut dyn FnMut(usize, usize) -> ControlFlow<()>,
) -> Vec<usize> {
    let mut keyframes = whole(errors.frame_count(), keyframes);
    let inner = keyframes.len().saturating_sub(2);
    // With room for the first and the last keyframe, which nothing asks about.
    let mut is_settled = vec![false; keyframes.len()];
    let mut settled = 0;
    while settled < inner {
        for index in 1..=inner {
            if is_settled[index] {
                continue;
            }
            let best = best_place(errors, keyframes[index - 1], keyframes[index], keyframes[index + 1]);
            if best != keyframes[index] {
                keyframes[index] = best;
                is_settled[index - 1] = false;
                is_settled[index + 1] = false;
            }
            is_settled[index] = true;
            settled = is_settled[1..=inner].iter().filter(|is_settled| **is_settled).count();
            if progress(settled, inner).is_break() {
                return keyframes;
            }
        }
    }
    keyframes
}

/// Ascending, from the first frame to the last.
fn whole(frame_count: usize, keyframes: &[usize]) -> Vec<usize> {
    let Some(last) = frame_count.checked_sub(1) else { return Vec::new() };
    let known = keyframes.iter().copied().filter(|frame| *frame < last);
    let mut whole: Vec<usize> = known.chain([0, last]).collect();
    whole.sort_unstable();
    whole.dedup();
    whole
}

/// Where between two keyframes a third one leaves the least error; `frame` itself unless another place is better.
fn best_place(errors: &Errors, before: usize, frame: usize, after: usize) -> usize {
    let error = errors.of_gap(before, frame) + errors.of_gap(frame, after);
    let mut best = (frame, error * (1.0 - LEAST_GAIN));
    for place in before + 1..after {
        let Some(first) = errors.of_gap_up_to(before, place, best.1) else { continue };
        let Some(second) = errors.of_gap_up_to(place, after, best.1 - first) else { continue };
        if first + second < best.1 {
            best = (place, first + second);
        }
    }
    best.0
}
