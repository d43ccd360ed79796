//! Something that moves along a line, as a joint's coordinate does in a motion: a small model of one, for tables of errors
//! that could be real.

use exam::keyframes::Triples;

use crate::dice::Dice;

/// Where it is in each frame: it goes now faster, now slower, now back.
pub(super) fn wander(dice: &mut Dice, frames: usize) -> Vec<f64> {
    let (mut at, mut speed) = (0.0, 0.0);
    let step = |_| {
        at += speed;
        speed = 0.8 * speed + f64::from(dice.angle(0.0, 3.0));
        at
    };
    (0..frames).map(step).collect()
}

/// The error of every frame between any two others, with two decimals.
pub(super) fn errors(positions: &[f64]) -> Triples {
    Triples::new(positions.len(), |start, frame, end| round(100.0, error(positions, start, frame, end)))
}

/// What every removal costs (before, frame, after), with three decimals.
pub(super) fn costs(positions: &[f64]) -> Triples {
    let gap = |start, end| (start + 1..end).fold(0.0, |sum, frame| sum + error(positions, start, frame, end));
    Triples::new(positions.len(), |before, frame, after| {
        round(1000.0, gap(before, after) - gap(before, frame) - gap(frame, after))
    })
}

/// What is between keyframes lies on a straight line.
fn error(positions: &[f64], start: usize, frame: usize, end: usize) -> f64 {
    let t = (frame - start) as f64 / (end - start) as f64;
    let between = positions[start] + t * (positions[end] - positions[start]);
    (between - positions[frame]).powi(2)
}

/// With `parts` 10 to a tenth, with 100 to a hundredth.
pub(super) fn round(parts: f64, value: f64) -> f64 {
    // A zero without a sign.
    (value * parts).round() / parts + 0.0
}
