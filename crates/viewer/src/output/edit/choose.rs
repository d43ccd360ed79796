//! Ways of choosing keyframes.

use std::ops::ControlFlow;

use clap::ValueEnum;
use reduction::{Errors, curve, local_moves, optimum};

/// How keyframes are chosen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Method {
    /// One keyframe after the other is removed, always the one that costs least
    #[default]
    Greedy,
    /// The same, and then each keyframe is moved to where it does best, until none can be moved
    Moves,
    /// The best keyframes that there are; of a long motion, the best with gaps up to a length that is told
    Optimum,
    /// Evenly spaced, whatever the motion does
    Even,
}

impl Method {
    /// All of them.
    pub const ALL: [Method; 4] = [Method::Greedy, Method::Moves, Method::Optimum, Method::Even];

    /// What it is called in a sentence and in a table.
    pub fn name(self) -> &'static str {
        match self {
            Method::Greedy => "greedy",
            Method::Moves => "greedy, then moved",
            Method::Optimum => "optimum",
            Method::Even => "evenly spaced",
        }
    }

    /// Chooses `count` keyframes of the motion of `errors`. `progress` is told how much has been done, and of how much.
    ///
    /// # Errors
    ///
    /// When the optimum would take too long.
    pub fn choose(
        self,
        errors: &Errors,
        count: usize,
        progress: &mut dyn FnMut(usize, usize),
    ) -> Result<Choice, TooLong> {
        let cap = match self {
            Method::Optimum => {
                cap(errors.frame_count(), errors.clip().skeleton().len(), count).ok_or(TooLong)?
            }
            _ => None,
        };
        self.choose_within(errors, count, cap, progress).ok_or(TooLong)
    }

    /// The same, where the optimum has gaps of at most `cap` frames, if that is given. `None` when there is no such optimum.
    pub(super) fn choose_within(
        self,
        errors: &Errors,
        count: usize,
        cap: Option<usize>,
        progress: &mut dyn FnMut(usize, usize),
    ) -> Option<Choice> {
        let mut go_on = |done, all| {
            progress(done, all);
            ControlFlow::Continue(())
        };
        let keyframes = match self {
            Method::Greedy => remaining(errors.frame_count(), &curve(errors, count, &mut go_on).removed),
            Method::Moves => {
                let greedy = remaining(errors.frame_count(), &curve(errors, count, &mut go_on).removed);
                local_moves(errors, &greedy, &mut go_on)
            }
            Method::Optimum => optimum(errors, count, cap, &mut go_on)?.keyframes,
            Method::Even => even(errors.frame_count(), count),
        };
        Some(Choice { keyframes, cap })
    }
}

/// Chosen keyframes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Choice {
    /// In ascending order.
    pub keyframes: Vec<usize>,
    /// The longest gap that the optimum was allowed, in frames from one keyframe to the next; `None` when any was.
    pub cap: Option<usize>,
}

/// The optimum of a motion of so many frames takes too long.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooLong;

/// The frames that stay when some are removed.
fn remaining(frame_count: usize, removed: &[usize]) -> Vec<usize> {
    let mut stays = vec![true; frame_count];
    removed.iter().for_each(|frame| stays[*frame] = false);
    (0..frame_count).filter(|frame| stays[*frame]).collect()
}

/// `count` frames as far apart as they can be, the first and the last among them.
fn even(frame_count: usize, count: usize) -> Vec<usize> {
    let count = count.max(2).min(frame_count);
    let (Some(last), Some(steps)) = (frame_count.checked_sub(1), count.checked_sub(1)) else {
        return Vec::new();
    };
    // Rounded; in wide numbers, because the product of two counts may not fit.
    let place = |step: usize| {
        let wide = (step as u128 * last as u128 * 2 + steps as u128) / (steps as u128 * 2).max(1);
        wide as usize
    };
    (0..count).map(place).collect()
}

/// The longest gap that the search for the optimum may look at; `Some(None)` when it may look at all. `None` when even the
/// shortest gaps with which so few keyframes reach from end to end are too many.
///
/// For every gap all frames in it are posed: of n frames about n · cap² / 2, and n³ / 6 for all gaps.
fn cap(frame_count: usize, joints: usize, count: usize) -> Option<Option<usize>> {
    /// So many joints can be posed in half a minute or so.
    const JOINTS: f64 = 6e8;
    /// So many ways from the first frame are remembered, some bytes each.
    const WAYS: f64 = 1e7;
    let count = count.max(2).min(frame_count);
    let (frames, poses) = (frame_count as f64, JOINTS / joints.max(1) as f64);
    if frames * count as f64 > WAYS {
        return None;
    }
    if frames.powi(3) / 6.0 <= poses {
        return Some(None);
    }
    let cap = (2.0 * poses / frames).sqrt() as usize;
    let shortest = (frame_count - 1).div_ceil(count - 1);
    (cap >= shortest).then_some(Some(cap))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn evenly_spaced_keyframes_reach_from_end_to_end() {
        assert!(even(0, 5).is_empty());
        assert_eq!(even(1, 5), [0]);
        assert_eq!(even(2, 0), [0, 1]);
        assert_eq!(even(7, 3), [0, 3, 6]);
        assert_eq!(even(141, 6), [0, 28, 56, 84, 112, 140]);
        assert_eq!(even(4, 4), [0, 1, 2, 3]);
        assert_eq!(even(usize::MAX, 3), [0, usize::MAX / 2, usize::MAX - 1]);
        for count in 2..40 {
            let even = even(40, count);
            let widest = even.windows(2).map(|gap| gap[1] - gap[0]).max();
            assert_eq!((even.len(), widest), (count, Some(39_usize.div_ceil(count - 1))));
        }
    }

    #[test]
    fn the_optimum_is_exact_for_short_motions_capped_for_longer_ones_and_refused_for_the_longest() {
        assert_eq!(cap(0, 0, 20), Some(None));
        assert_eq!(cap(141, 35, 20), Some(None));
        let long = cap(1377, 35, 20).flatten().expect("it is capped");
        assert!((100..300).contains(&long), "{long}");
        assert_eq!(cap(100_000, 35, 20), None);
        // Many keyframes are close together, and the memory would not do.
        assert_eq!(cap(100_000, 35, 50_000), None);
    }
}
