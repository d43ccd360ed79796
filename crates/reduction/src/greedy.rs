//! One keyframe after the other is removed, always the one that costs least.

use std::ops::ControlFlow;

use skeleton::RemovalCosts;
use solutions::keyframes::{Removal, Removals};

use crate::Errors;

/// The keyframes that stay when `count` of them are wanted, in ascending order.
pub fn greedy(errors: &Errors, count: usize) -> Vec<usize> {
    let mut stays = vec![true; errors.frame_count()];
    remove(errors, count, &mut |removal| {
        stays[removal.frame] = false;
        ControlFlow::Continue(())
    });
    (0..stays.len()).filter(|frame| stays[*frame]).collect()
}

/// How the error grows while keyframes are removed.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Curve {
    /// The keyframes in the order in which they are removed.
    pub removed: Vec<usize>,
    /// `errors[n]` is the accumulated error when `n` frames are interpolated: the first `n` of `removed`. `errors[0]`
    /// is 0, and there is one more of them than of `removed`. It falls where interpolating one more frame happens to
    /// bring others closer to where they were.
    pub errors: Vec<f64>,
}

/// Removes keyframes until `count` are left, and tells what is left of the motion after each removal.
///
/// `progress` is told after every removal how many there have been, and how many there are to be. When it breaks, the
/// curve ends there.
pub fn curve(
    errors: &Errors,
    count: usize,
    progress: &mut dyn FnMut(usize, usize) -> ControlFlow<()>,
) -> Curve {
    let surplus = errors.frame_count().saturating_sub(count.max(2));
    let mut curve = Curve { removed: Vec::with_capacity(surplus), errors: vec![0.0] };
    let mut error = 0.0;
    remove(errors, count, &mut |removal| {
        error += removal.cost;
        curve.removed.push(removal.frame);
        curve.errors.push(error);
        progress(curve.removed.len(), surplus)
    });
    curve
}

/// Tells `removed` of one removal after the other, until `count` keyframes are left or it breaks.
///
/// What costs nothing goes first. Up to then no gap has an error, so that no cost is negative, and nothing matters
/// about a cost but whether it is 0. Mostly one pose shows that it is not. The exact cost would be posed for nothing,
/// again and again: where a motion stops and then stands still, for the frame where it stops, whenever the frame
/// behind is removed.
fn remove(errors: &Errors, count: usize, removed: &mut dyn FnMut(Removal) -> ControlFlow<()>) {
    let frame_count = errors.frame_count();
    let surplus = frame_count.saturating_sub(count.max(2));
    if surplus == 0 {
        return;
    }
    let mut stays = vec![true; frame_count];
    let mut free = 0;
    let cost = |before, _, after| if errors.is_free(before, after) { 0.0 } else { 1.0 };
    for removal in Removals::new(frame_count, &RemovalCosts::new(&cost)).take(surplus) {
        if removal.cost > 0.0 {
            break;
        }
        stays[removal.frame] = false;
        free += 1;
        if removed(removal).is_break() {
            return;
        }
    }
    if free == surplus {
        return;
    }
    let left: Vec<usize> = (0..frame_count).filter(|frame| stays[*frame]).collect();
    let cost =
        |before: usize, frame: usize, after: usize| errors.cost(left[before], left[frame], left[after]);
    for Removal { frame, cost } in Removals::new(left.len(), &RemovalCosts::new(&cost)).take(surplus - free) {
        if removed(Removal { frame: left[frame], cost }).is_break() {
            return;
        }
    }
}
