//! One keyframe after the other is removed, always the one that costs least.

use std::ops::ControlFlow;

use skeleton::RemovalCosts;
use solutions::keyframes::{Removals, reduce};

use crate::Errors;

/// The keyframes that stay when `count` of them are wanted, in ascending order.
pub fn greedy(errors: &Errors, count: usize) -> Vec<usize> {
    reduce(
        errors.frame_count(),
        count,
        &RemovalCosts::new(&|before, frame, after| errors.cost(before, frame, after)),
    )
}

/// How the error grows while keyframes are removed.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Curve {
    /// The keyframes in the order in which they are removed.
    pub removed: Vec<usize>,
    /// `errors[n]` is the accumulated error when `n` frames are interpolated: the first `n` of `removed`. `errors[0]` is 0, and
    /// there is one more of them than of `removed`. Where interpolating one more frame happens to bring the others closer, it
    /// falls.
    pub errors: Vec<f64>,
}

/// Removes keyframes until `count` are left, and tells what each removal costs.
///
/// `progress` is told after every removal how many there have been, and how many there are to be. When it breaks, the curve
/// ends there.
pub fn curve(
    errors: &Errors,
    count: usize,
    progress: &mut dyn FnMut(usize, usize) -> ControlFlow<()>,
) -> Curve {
    let surplus = errors.frame_count().saturating_sub(count.max(2));
    let cost = |before, frame, after| errors.cost(before, frame, after);
    let costs = RemovalCosts::new(&cost);
    let mut curve = Curve { removed: Vec::with_capacity(surplus), errors: vec![0.0] };
    let mut error = 0.0;
    for removal in Removals::new(errors.frame_count(), &costs).take(surplus) {
        error += removal.cost;
        curve.removed.push(removal.frame);
        curve.errors.push(error);
        if progress(curve.removed.len(), surplus).is_break() {
            break;
        }
    }
    curve
}
