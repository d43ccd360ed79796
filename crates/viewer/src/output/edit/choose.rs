//! Ways of choosing keyframes.

use std::ops::ControlFlow;

use clap::ValueEnum;
use reduction::{Errors, curve, local_moves, optimum};

use crate::edit::remaining;

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
            Method::Optimum => return best(errors, Size::of(errors, count), progress).ok_or(TooLong),
            Method::Even => even(errors.frame_count(), count),
        };
        Ok(Choice { keyframes, cap: None })
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

/// The optimum, of all keyframes if that is to be had, or else with gaps of a limited length. `None` when neither is.
fn best(errors: &Errors, size: Size, progress: &mut dyn FnMut(usize, usize)) -> Option<Choice> {
    let Size { count, .. } = size;
    let begun = errors.poses();
    let mut within = |done, all| {
        progress(done, all);
        if (errors.poses() - begun) as f64 <= size.poses() {
            ControlFlow::Continue(())
        } else {
            ControlFlow::Break(())
        }
    };
    let exact = if size.may_be_exact() { optimum(errors, count, None, &mut within) } else { None };
    let found = exact.or_else(|| {
        let cap = size.cap()?;
        optimum(errors, count, Some(cap), &mut |done, all| {
            progress(done, all);
            ControlFlow::Continue(())
        })
    })?;
    Some(Choice { keyframes: found.keyframes, cap: found.cap })
}

/// What says how long the search for the optimum takes.
///
/// For every gap all frames in it are posed, as long as the gap is not too bad to be of use: of n frames at most n³ / 6, or
/// n · cap² / 2 where gaps are no longer than a cap.
#[derive(Clone, Copy, Debug)]
struct Size {
    frames: usize,
    joints: usize,
    count: usize,
}

impl Size {
    /// So many joints can be posed in a minute or so.
    const JOINTS: f64 = 3e9;
    /// Of all gaps so many joints would have to be posed, if it were not for those that are of no use: mostly a few times more
    /// than are.
    const ALL_JOINTS: f64 = 2e10;
    /// So many ways from the first frame are remembered, some bytes each, and so many are gone.
    const WAYS: (f64, f64) = (1e7, 5e9);

    fn of(errors: &Errors, count: usize) -> Size {
        let frames = errors.frame_count();
        let joints = errors.clip().skeleton().len().max(1);
        Size { frames, joints, count: count.max(2).min(frames) }
    }

    /// How many poses the search may take.
    fn poses(self) -> f64 {
        Size::JOINTS / self.joints as f64
    }

    /// How many ways the search remembers.
    fn ways(self) -> f64 {
        self.frames as f64 * self.count as f64
    }

    fn may_be_exact(self) -> bool {
        let frames = self.frames as f64;
        let all = frames.powi(3) / 6.0 * self.joints as f64;
        all <= Size::ALL_JOINTS && self.ways() <= Size::WAYS.0 && self.ways() * frames <= Size::WAYS.1
    }

    /// The longest gap that the search may look at; `None` when even the shortest gaps with which so few keyframes reach from end
    /// to end are too many.
    fn cap(self) -> Option<usize> {
        let by_poses = (2.0 * self.poses() / self.frames as f64).sqrt();
        let cap = by_poses.min(Size::WAYS.1 / self.ways()) as usize;
        let shortest = self.frames.saturating_sub(1).div_ceil(self.count.saturating_sub(1).max(1));
        (cap >= shortest && self.ways() <= Size::WAYS.0).then_some(cap)
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec3;
    use skeleton::{Axis, Channel, Frame, Motion, Representation, Skeleton};

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
        let size = |frames, count| Size { frames, joints: 35, count };
        for exact in [size(0, 0), size(1, 1), size(141, 20), size(1377, 20), size(1377, 1377)] {
            assert!(exact.may_be_exact(), "{exact:?}");
        }
        for capped in [size(2000, 20), size(5000, 400)] {
            assert!(!capped.may_be_exact(), "{capped:?}");
            let cap = capped.cap().expect("it is capped");
            assert!((100..500).contains(&cap), "{capped:?}: {cap}");
        }
        // Two are too far apart; or too many are remembered.
        for refused in [size(100_000, 20), size(100_000, 50_000), size(4000, 4000)] {
            assert!(!refused.may_be_exact() && refused.cap().is_none(), "{refused:?}");
        }
    }

    /// A joint that goes to and fro.
    fn errors(frames: usize) -> Errors {
        let mut skeleton = Skeleton::new();
        let channels = [Channel::Position(Axis::X)];
        skeleton.add_joint(None, "r", Vec3::ZERO, channels).unwrap();
        let values = (0..frames).map(|i| (i % 7) as f32 + (i % 11) as f32).collect();
        let motion = Motion::new(skeleton, frames, 0.1, values).unwrap();
        let frames: Vec<Frame> = (0..frames).map(|index| motion.frame(index)).collect();
        Errors::new(motion.skeleton(), &frames, Representation::Quaternion)
    }

    #[test]
    fn better_methods_leave_smaller_errors() {
        let errors = errors(60);
        let of = |method: Method| {
            let choice = method.choose(&errors, 12, &mut |_, _| ()).unwrap();
            assert_eq!((choice.keyframes.len(), choice.cap), (12, None));
            errors.of_keyframes(&choice.keyframes)
        };
        let [optimum, moved, greedy] = [Method::Optimum, Method::Moves, Method::Greedy].map(of);
        assert!(optimum <= moved && moved < greedy, "{optimum} {moved} {greedy}");
    }

    #[test]
    fn a_capped_optimum_says_so_and_one_that_takes_longer_than_expected_is_broken_off() {
        let errors = errors(60);
        // As if posing took long.
        let capped = Size { joints: 1_000_000, ..Size::of(&errors, 12) };
        let choice = best(&errors, capped, &mut |_, _| ()).unwrap();
        assert_eq!(choice.cap, Some(10));
        assert!(choice.keyframes.windows(2).all(|gap| gap[1] - gap[0] <= 10), "{choice:?}");

        let errors = self::errors(60);
        let broken_off = Size { joints: 550_000, ..Size::of(&errors, 3) };
        assert!(broken_off.may_be_exact() && broken_off.cap().is_none());
        assert_eq!(best(&errors, broken_off, &mut |_, _| ()), None);
        let poses = errors.poses() as f64;
        assert!((0.9..1.5).contains(&(poses / broken_off.poses())), "{poses}");
    }
}
