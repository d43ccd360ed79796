//! Part 2.

use std::ops::Range;

use skeleton::FrameErrors;

/// The errors of these frames between the keyframes `start` and `end`.
fn between(errors: &FrameErrors, start: usize, end: usize, frames: Range<usize>) -> f64 {
    frames.map(|frame| errors.between(start, end, frame)).sum()
}

fn gap(errors: &FrameErrors, start: usize, end: usize) -> f64 {
    between(errors, start, end, start + 1..end)
}

fn growth(before: usize, frame: usize, after: usize, errors: &FrameErrors) -> f64 {
    gap(errors, before, after) - gap(errors, before, frame) - gap(errors, frame, after)
}

pub fn new_gap(before: usize, _: usize, after: usize, errors: &FrameErrors) -> f64 {
    gap(errors, before, after)
}

pub fn removed_frame(before: usize, frame: usize, after: usize, errors: &FrameErrors) -> f64 {
    errors.between(before, after, frame)
}

pub fn without_the_old_before(before: usize, frame: usize, after: usize, errors: &FrameErrors) -> f64 {
    gap(errors, before, after) - gap(errors, before, frame)
}

pub fn without_the_old_after(before: usize, frame: usize, after: usize, errors: &FrameErrors) -> f64 {
    gap(errors, before, after) - gap(errors, frame, after)
}

pub fn reversed(before: usize, frame: usize, after: usize, errors: &FrameErrors) -> f64 {
    -growth(before, frame, after, errors)
}

pub fn old_added(before: usize, frame: usize, after: usize, errors: &FrameErrors) -> f64 {
    gap(errors, before, after) + gap(errors, before, frame) + gap(errors, frame, after)
}

pub fn absolute(before: usize, frame: usize, after: usize, errors: &FrameErrors) -> f64 {
    growth(before, frame, after, errors).abs()
}

pub fn at_least_zero(before: usize, frame: usize, after: usize, errors: &FrameErrors) -> f64 {
    growth(before, frame, after, errors).max(0.0)
}

pub fn removed_frame_forgotten(before: usize, frame: usize, after: usize, errors: &FrameErrors) -> f64 {
    growth(before, frame, after, errors) - errors.between(before, after, frame)
}

/// Without the first frame of each gap, or without the last one.
pub fn gaps_cut<const FIRST: bool>(before: usize, frame: usize, after: usize, errors: &FrameErrors) -> f64 {
    let gap = |start, end| between(errors, start, end, cut::<FIRST>(start, end));
    gap(before, after) - gap(before, frame) - gap(frame, after)
}

/// Without the first frame of the new gap, or without the last one.
pub fn new_gap_cut<const FIRST: bool>(
    before: usize,
    frame: usize,
    after: usize,
    errors: &FrameErrors,
) -> f64 {
    let new = between(errors, before, after, cut::<FIRST>(before, after));
    new - gap(errors, before, frame) - gap(errors, frame, after)
}

fn cut<const FIRST: bool>(start: usize, end: usize) -> Range<usize> {
    if FIRST { start + 2..end } else { start + 1..end.saturating_sub(1) }
}
