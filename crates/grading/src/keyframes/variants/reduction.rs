//! Part 3.

use skeleton::RemovalCosts;

/// How many keyframes stay.
fn wanted(frame_count: usize, count: usize) -> usize {
    count.max(2).min(frame_count)
}

/// Removes one keyframe after the other until `count` are left. `choose` gives the place of the next one, if there is any.
fn removing(
    frame_count: usize,
    count: usize,
    mut choose: impl FnMut(&[usize]) -> Option<usize>,
) -> Vec<usize> {
    let mut keyframes: Vec<usize> = (0..frame_count).collect();
    while keyframes.len() > count {
        let Some(place) = choose(&keyframes) else { break };
        keyframes.remove(place);
    }
    keyframes
}

/// The place of the inner keyframe with the least cost, and of several the first one.
fn least(keyframes: &[usize], cost: impl Fn(&[usize]) -> f64) -> Option<usize> {
    let costs = keyframes.windows(3).map(cost).enumerate();
    costs.min_by(|(_, a), (_, b)| a.total_cmp(b)).map(|(index, _)| index + 1)
}

fn present(costs: &RemovalCosts, three: &[usize]) -> f64 {
    costs.of(three[0], three[1], three[2])
}

/// What the keyframe in the middle of three cost when all frames were keyframes.
fn at_first(costs: &RemovalCosts, three: &[usize]) -> f64 {
    costs.of(three[1] - 1, three[1], three[1] + 1)
}

/// Right, but for how many stay.
fn greedy(frame_count: usize, count: usize, costs: &RemovalCosts) -> Vec<usize> {
    removing(frame_count, count, |keyframes| least(keyframes, |three| present(costs, three)))
}

pub fn never_refreshed(frame_count: usize, count: usize, costs: &RemovalCosts) -> Vec<usize> {
    let count = wanted(frame_count, count);
    removing(frame_count, count, |keyframes| least(keyframes, |three| at_first(costs, three)))
}

/// Of a removed keyframe's neighbours only the one before it gets a new cost, or only the one after it.
pub fn one_side_refreshed<const BEFORE: bool>(
    frame_count: usize,
    count: usize,
    costs: &RemovalCosts,
) -> Vec<usize> {
    let is_inner = |frame: usize| frame > 0 && frame + 1 < frame_count;
    let first = |frame| if is_inner(frame) { costs.of(frame - 1, frame, frame + 1) } else { 0.0 };
    let mut known: Vec<f64> = (0..frame_count).map(first).collect();
    removing(frame_count, wanted(frame_count, count), |keyframes| {
        let place = least(keyframes, |three| known[three[1]])?;
        let mut rest = keyframes.to_vec();
        rest.remove(place);
        let neighbour = if BEFORE { place - 1 } else { place };
        if neighbour > 0 && neighbour + 1 < rest.len() {
            known[rest[neighbour]] = present(costs, &rest[neighbour - 1..=neighbour + 1]);
        }
        Some(place)
    })
}

/// A keyframe is removed as soon as any cost that it has ever had is the least.
pub fn outdated_costs_count(frame_count: usize, count: usize, costs: &RemovalCosts) -> Vec<usize> {
    let mut lowest = vec![f64::INFINITY; frame_count];
    removing(frame_count, wanted(frame_count, count), |keyframes| {
        for three in keyframes.windows(3) {
            lowest[three[1]] = lowest[three[1]].min(present(costs, three));
        }
        least(keyframes, |three| lowest[three[1]])
    })
}

/// As if −3 were more than 2.
pub fn sizes_compared(frame_count: usize, count: usize, costs: &RemovalCosts) -> Vec<usize> {
    removing(frame_count, wanted(frame_count, count), |keyframes| {
        least(keyframes, |three| present(costs, three).abs())
    })
}

/// As if nothing could cost less than nothing.
pub fn below_zero_is_zero(frame_count: usize, count: usize, costs: &RemovalCosts) -> Vec<usize> {
    removing(frame_count, wanted(frame_count, count), |keyframes| {
        least(keyframes, |three| present(costs, three).max(0.0))
    })
}

/// The keyframe before the one that costs least goes, or the one after it.
pub fn neighbour_removed<const BEFORE: bool>(
    frame_count: usize,
    count: usize,
    costs: &RemovalCosts,
) -> Vec<usize> {
    removing(frame_count, wanted(frame_count, count), |keyframes| {
        let place = least(keyframes, |three| present(costs, three))?;
        Some(if BEFORE { place - 1 } else { place + 1 })
    })
}

/// Of several that cost most, the first goes.
pub fn most_expensive(frame_count: usize, count: usize, costs: &RemovalCosts) -> Vec<usize> {
    let count = wanted(frame_count, count);
    removing(frame_count, count, |keyframes| least(keyframes, |three| -present(costs, three)))
}

/// Of several that cost most, the last goes.
pub fn most_expensive_later(frame_count: usize, count: usize, costs: &RemovalCosts) -> Vec<usize> {
    removing(frame_count, wanted(frame_count, count), |keyframes| {
        last_least(keyframes, |three| -present(costs, three))
    })
}

/// Those that cost least at first are kept.
pub fn cheapest_kept(frame_count: usize, count: usize, costs: &RemovalCosts) -> Vec<usize> {
    let count = wanted(frame_count, count);
    removing(frame_count, count, |keyframes| least(keyframes, |three| -at_first(costs, three)))
}

/// The same, with the later ones kept of those that cost the same.
pub fn later_cheapest_kept(frame_count: usize, count: usize, costs: &RemovalCosts) -> Vec<usize> {
    let count = wanted(frame_count, count);
    removing(frame_count, count, |keyframes| last_least(keyframes, |three| -at_first(costs, three)))
}

pub fn later_of_equals(frame_count: usize, count: usize, costs: &RemovalCosts) -> Vec<usize> {
    let count = wanted(frame_count, count);
    removing(frame_count, count, |keyframes| last_least(keyframes, |three| present(costs, three)))
}

/// As `least`, but of several the last one.
fn last_least(keyframes: &[usize], cost: impl Fn(&[usize]) -> f64) -> Option<usize> {
    let costs = keyframes.windows(3).map(cost).enumerate();
    costs.max_by(|(_, a), (_, b)| b.total_cmp(a)).map(|(index, _)| index + 1)
}

/// As if removing an end cost nothing: it goes first, and then the next one is an end. With `CLAMPED`, two stay at least.
pub fn first_removed<const CLAMPED: bool>(frame_count: usize, count: usize, _: &RemovalCosts) -> Vec<usize> {
    let stay = if CLAMPED { wanted(frame_count, count) } else { count.min(frame_count) };
    (frame_count - stay..frame_count).collect()
}

/// The same at the other end.
pub fn last_removed<const CLAMPED: bool>(frame_count: usize, count: usize, _: &RemovalCosts) -> Vec<usize> {
    (0..if CLAMPED { wanted(frame_count, count) } else { count.min(frame_count) }).collect()
}

/// The removed ones in ascending order.
pub fn removed_returned(frame_count: usize, count: usize, costs: &RemovalCosts) -> Vec<usize> {
    let mut removed = removed_returned_as_they_go(frame_count, count, costs);
    removed.sort_unstable();
    removed
}

pub fn removed_returned_as_they_go(frame_count: usize, count: usize, costs: &RemovalCosts) -> Vec<usize> {
    let mut removed = Vec::new();
    removing(frame_count, wanted(frame_count, count), |keyframes| {
        let place = least(keyframes, |three| present(costs, three))?;
        removed.push(keyframes[place]);
        Some(place)
    });
    removed
}

pub fn one_more(frame_count: usize, count: usize, costs: &RemovalCosts) -> Vec<usize> {
    greedy(frame_count, (count + 1).max(2), costs)
}

pub fn one_more_than_two(frame_count: usize, count: usize, costs: &RemovalCosts) -> Vec<usize> {
    greedy(frame_count, count.max(2) + 1, costs)
}

pub fn one_less(frame_count: usize, count: usize, costs: &RemovalCosts) -> Vec<usize> {
    greedy(frame_count, count.saturating_sub(1).max(2), costs)
}

/// As if `count` said how many to remove.
pub fn so_many_removed(frame_count: usize, count: usize, costs: &RemovalCosts) -> Vec<usize> {
    greedy(frame_count, frame_count.saturating_sub(count).max(2), costs)
}

/// Evenly spaced: what lies between two frames goes to the lower one (0), to the nearer one (1), or to the upper one (2).
pub fn evenly_spaced<const ROUNDING: usize>(
    frame_count: usize,
    count: usize,
    _: &RemovalCosts,
) -> Vec<usize> {
    let stay = wanted(frame_count, count);
    if frame_count < 2 {
        return (0..frame_count).collect();
    }
    let (last, steps) = (frame_count - 1, stay - 1);
    let round = |index: usize| match ROUNDING {
        0 => index * last / steps,
        1 => (2 * index * last + steps) / (2 * steps),
        _ => (index * last).div_ceil(steps),
    };
    (0..stay).map(round).collect()
}

/// What someone gives when fewer than two keyframes are wanted; the rest is right.
fn below_two(
    frame_count: usize,
    count: usize,
    costs: &RemovalCosts,
    give: impl Fn() -> Vec<usize>,
) -> Vec<usize> {
    if count < 2 { give() } else { greedy(frame_count, count, costs) }
}

pub fn below_two_the_first(frame_count: usize, count: usize, costs: &RemovalCosts) -> Vec<usize> {
    below_two(frame_count, count, costs, || (0..count.min(frame_count)).collect())
}

pub fn below_two_the_last(frame_count: usize, count: usize, costs: &RemovalCosts) -> Vec<usize> {
    below_two(frame_count, count, costs, || (frame_count.saturating_sub(count)..frame_count).collect())
}

pub fn below_two_nothing(frame_count: usize, count: usize, costs: &RemovalCosts) -> Vec<usize> {
    below_two(frame_count, count, costs, Vec::new)
}

pub fn below_two_everything(frame_count: usize, count: usize, costs: &RemovalCosts) -> Vec<usize> {
    below_two(frame_count, count, costs, || (0..frame_count).collect())
}
