//! Which frames of a motion a warped one shows.

use skeleton::acclaim::Between;

/// A time warp: for every frame of the new motion, where it is in the old one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TimeMap {
    /// The whole motion gets another number of frames: part 1 of the exercise on time warping.
    Whole {
        /// How many frames the old motion has.
        old: usize,
        /// How many the new one has.
        new: usize,
    },
    /// The stretch from one keyframe to another takes more or less time. What is before and behind it stays.
    Stretch {
        /// How many frames the old motion has.
        old: usize,
        /// The first keyframe, from 0.
        first: usize,
        /// The second keyframe, behind the first.
        last: usize,
        /// How many frames it is from the one to the other in the new motion: at least one.
        new: usize,
    },
}

impl TimeMap {
    /// The stretch between two keyframes of a motion of `old` frames, in either order, gets `new` frames. `None` when there
    /// is nothing between them, one of them is not there, or there are to be no frames.
    pub fn stretch(old: usize, keyframes: (usize, usize), new: usize) -> Option<TimeMap> {
        let (first, last) = (keyframes.0.min(keyframes.1), keyframes.0.max(keyframes.1));
        (first < last && last < old && new > 0).then_some(TimeMap::Stretch { old, first, last, new })
    }

    /// How many frames the old motion has.
    pub fn old_count(&self) -> usize {
        let (TimeMap::Whole { old, .. } | TimeMap::Stretch { old, .. }) = *self;
        old
    }

    /// How many frames the new motion has. A motion without frames stays without.
    pub fn frame_count(&self) -> usize {
        match *self {
            TimeMap::Whole { old: 0, .. } => 0,
            TimeMap::Whole { new, .. } => new,
            TimeMap::Stretch { old, first, last, new } => (old - (last - first)).saturating_add(new),
        }
    }

    /// The keyframes of a stretch: in the old motion, and in the new one.
    pub fn keyframes(&self) -> Option<[(usize, usize); 2]> {
        match *self {
            TimeMap::Whole { .. } => None,
            TimeMap::Stretch { first, last, .. } => {
                Some([first, last].map(|keyframe| (keyframe, self.new_frame(keyframe))))
            }
        }
    }

    /// How many new frames take the place of how many old ones: `(new, old)`, where time is warped.
    pub fn speed(&self) -> (usize, usize) {
        match *self {
            TimeMap::Whole { old, new } => (new, old),
            TimeMap::Stretch { first, last, new, .. } => (new, last - first),
        }
    }

    /// Where the new motion's frame `index` is in the old one, as one number.
    pub fn position(&self, index: usize) -> f64 {
        position_of(self.place(index))
    }

    /// Where the new motion's frame `index` (from 0) is in the old one. After the last frame it is the last one.
    pub fn place(&self, index: usize) -> Between {
        let index = index.min(self.frame_count().saturating_sub(1));
        match *self {
            TimeMap::Whole { old, new } => (solutions::TIME_WARP.old_position)(index, old, new),
            TimeMap::Stretch { first, .. } if index <= first => at(index),
            TimeMap::Stretch { first, last, new, .. } if index - first < new => {
                // In whole numbers nothing is lost, however large they are.
                let (place, of) = ((index - first) as u128 * (last - first) as u128, new as u128);
                let (before, rest) = (first + (place / of) as usize, (place % of) as f64);
                let after = if rest > 0.0 { before + 1 } else { before };
                Between { before, after, t: (rest / of as f64) as f32 }
            }
            TimeMap::Stretch { first, last, new, .. } => at(last + (index - first - new)),
        }
    }

    /// The frame of the new motion that comes closest to frame `index` of the old one.
    pub fn new_frame(&self, index: usize) -> usize {
        let scaled = |index: usize, old: usize, new: usize| {
            let (old, place) = (old.max(1) as u128, index as u128 * new as u128);
            usize::try_from((place + old / 2) / old).unwrap_or(usize::MAX)
        };
        let frame = match *self {
            // Behind the place of the last frame it stays.
            TimeMap::Whole { old, new } if index + 1 >= old => held_from(old, new),
            TimeMap::Whole { old, new } => scaled(index, old, new),
            TimeMap::Stretch { first, .. } if index <= first => index,
            TimeMap::Stretch { first, last, new, .. } if index < last => {
                first + scaled(index - first, last - first, new)
            }
            TimeMap::Stretch { first, last, new, .. } => {
                first.saturating_add(new).saturating_add(index - last)
            }
        };
        frame.min(self.frame_count().saturating_sub(1))
    }

    /// The corners of the curve that leads from new frames to old ones: `(new, old)`, from the first frame to the last.
    pub fn corners(self) -> impl Iterator<Item = (usize, f64)> {
        let end = self.frame_count().saturating_sub(1);
        let (first, second) = match self {
            TimeMap::Whole { old, new } => (0, held_from(old, new)),
            TimeMap::Stretch { first, new, .. } => (first, first.saturating_add(new)),
        };
        let mut least = 0;
        let corners = [0, first, second, end].into_iter().filter(move |corner| {
            let is_next = (least..=end).contains(corner);
            least = if is_next { corner.saturating_add(1) } else { least };
            is_next
        });
        corners.map(move |corner| (corner, self.position(corner)))
    }
}

/// A place between two frames as one number.
pub fn position_of(Between { before, after, t }: Between) -> f64 {
    before as f64 + f64::from(t) * (after as f64 - before as f64)
}

/// From which new frame on the last one of `old` frames is shown, of which `new` are made.
fn held_from(old: usize, new: usize) -> usize {
    let place = old.saturating_sub(1) as u128 * new as u128;
    usize::try_from(place.div_ceil(old.max(1) as u128)).unwrap_or(usize::MAX)
}

/// A frame of the old motion as it is.
fn at(frame: usize) -> Between {
    Between { before: frame, after: frame, t: 0.0 }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn position(map: &TimeMap, index: usize) -> f64 {
        let Between { before, after, t } = map.place(index);
        assert!(before <= after && after - before <= 1 && after < map.old_count());
        before as f64 + f64::from(t) * (after - before) as f64
    }

    #[test]
    fn a_stretch_gets_slower_and_the_rest_keeps_its_length() {
        let map = TimeMap::stretch(10, (6, 3), 6).unwrap();
        let places: Vec<f64> = (0..map.frame_count()).map(|index| position(&map, index)).collect();
        assert_eq!(places, [0.0, 1.0, 2.0, 3.0, 3.5, 4.0, 4.5, 5.0, 5.5, 6.0, 7.0, 8.0, 9.0]);
        assert_eq!(map.corners().collect::<Vec<_>>(), [(0, 0.0), (3, 3.0), (9, 6.0), (12, 9.0)]);
        assert_eq!((map.keyframes(), map.speed()), (Some([(3, 3), (6, 9)]), (6, 3)));
        assert_eq!([2, 3, 4, 6, 9].map(|old| map.new_frame(old)), [2, 3, 5, 9, 12]);
    }

    #[test]
    fn there_is_no_stretch_between_a_frame_and_itself_nor_beyond_the_motion_nor_of_no_frames() {
        assert_eq!(TimeMap::stretch(10, (3, 3), 5), None);
        assert_eq!(TimeMap::stretch(10, (3, 10), 5), None);
        assert_eq!(TimeMap::stretch(0, (0, 1), 5), None);
        assert_eq!(TimeMap::stretch(10, (3, 6), 0), None);
    }

    #[test]
    fn motions_of_one_frame_and_none_and_counts_of_one_and_zero() {
        for (old, new, count) in [(0, 9, 0), (9, 0, 0), (1, 5, 5), (5, 1, 1), (0, 0, 0)] {
            let map = TimeMap::Whole { old, new };
            assert_eq!(map.frame_count(), count);
            assert!((0..count).all(|index| position(&map, index) <= old as f64 - 1.0));
            assert!(map.corners().next().is_some());
        }
        assert_eq!(TimeMap::Whole { old: 5, new: 1 }.place(0), at(0));
    }

    proptest! {
        #[test]
        fn time_never_goes_back_and_both_ways_agree(
            old in 2usize..500,
            new in 1usize..500,
            ends in (0usize..500, 0usize..500),
            whole: bool,
        ) {
            let stretch = TimeMap::stretch(old, (ends.0 % old, ends.1 % old), new);
            let map = stretch.filter(|_| !whole).unwrap_or(TimeMap::Whole { old, new });
            let places: Vec<f64> = (0..map.frame_count()).map(|index| position(&map, index)).collect();
            prop_assert!(places.is_sorted());
            let mut before = 0;
            for frame in 0..old {
                let new_frame = map.new_frame(frame);
                prop_assert!(new_frame >= before && new_frame < map.frame_count());
                before = new_frame;
                let off = |index: usize| (places[index] - frame as f64).abs();
                let best = (0..places.len()).map(off).fold(f64::INFINITY, f64::min);
                prop_assert!(off(new_frame) <= best + 1e-4, "{map:?}: {frame} at {new_frame}");
            }
        }

        #[test]
        fn a_curve_is_straight_between_its_corners(
            old in 2usize..200,
            new in 1usize..300,
            ends in (0usize..200, 0usize..200),
        ) {
            let stretch = TimeMap::stretch(old, (ends.0 % old, ends.1 % old), new);
            // Between the last place of a whole motion and the one that is held, a corner is a frame wide.
            for (map, wide) in [(Some(TimeMap::Whole { old, new }), 1.0), (stretch, 0.0)] {
                let Some(map) = map else { continue };
                let corners: Vec<_> = map.corners().collect();
                prop_assert_eq!(corners[0].0, 0);
                prop_assert_eq!(corners[corners.len() - 1].0, map.frame_count() - 1);
                for pair in corners.windows(2) {
                    let [(from, a), (to, b)] = [pair[0], pair[1]];
                    for index in from..=to {
                        let straight = a + (b - a) * (index - from) as f64 / (to - from) as f64;
                        prop_assert!((position(&map, index) - straight).abs() <= wide + 1e-3, "{map:?}");
                    }
                }
            }
        }
    }
}
