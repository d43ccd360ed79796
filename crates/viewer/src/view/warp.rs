//! A time warp as keys change it.

use crate::motion::source::Warping;
use crate::motion::time_map::TimeMap;

/// The most frames that a motion can be warped to.
pub const MOST_FRAMES: usize = 100_000_000;

/// How a motion of any length is warped: the stretch between two keyframes, or the whole, gets another number of frames.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Warp {
    /// The keyframes; `None` where the motion itself begins or ends.
    first: Option<usize>,
    last: Option<usize>,
    /// So many new frames take the place of so many old ones. Kept as it was set, so that another stretch and back is as before.
    new: usize,
    of: usize,
}

impl Warp {
    /// What `map` does, to be changed.
    pub fn new(map: TimeMap) -> Warp {
        match map {
            TimeMap::Whole { old, new } => Warp { first: None, last: None, new, of: old },
            TimeMap::Stretch { first, last, new, .. } => {
                Warp { first: Some(first), last: Some(last), new, of: last - first }
            }
        }
    }

    /// What is asked for, for a motion of `old` frames, even when it does not have the keyframes.
    pub fn of_motion(warping: &Warping, old: usize) -> Warp {
        let of = warping.keyframes.map_or(old, |(a, b)| a.abs_diff(b));
        let (first, last) = warping.keyframes.map(|(a, b)| (a.min(b), a.max(b))).unzip();
        Warp { first, last, new: warping.frames.unwrap_or(of.saturating_mul(2)), of }
    }

    /// The warp of a motion of `old` frames: with as many of the keyframes as it has.
    pub fn map(&self, old: usize) -> TimeMap {
        let count = |of: usize| self.count(of);
        let stretch = self.stretch(old);
        stretch
            .and_then(|(first, last)| TimeMap::stretch(old, (first, last), count(last - first)))
            .unwrap_or(TimeMap::Whole { old, new: count(old) })
    }

    /// The same for a motion whose file has changed: a whole motion gets as many frames as before, however many it has now. One
    /// that had no frames, of which nobody said how many it gets, gets twice as many as it has now.
    #[must_use]
    pub fn for_motion(&self, old: usize) -> Warp {
        let whole = self.first.is_none() && self.last.is_none();
        let new = if self.new == 0 { old.saturating_mul(2) } else { self.new };
        if whole { Warp { new, of: old, ..*self } } else { *self }
    }

    /// The keyframes, in a motion of `old` frames; `None` when it is warped as a whole.
    fn stretch(&self, old: usize) -> Option<(usize, usize)> {
        let end = old.checked_sub(1)?;
        let (first, last) = (self.first.unwrap_or(0), self.last.unwrap_or(end).min(end));
        ((self.first.is_some() || self.last.is_some()) && first < last).then_some((first, last))
    }

    /// How many new frames take the place of `of` old ones.
    fn count(&self, of: usize) -> usize {
        let most = MOST_FRAMES as u128;
        if self.of == of {
            return self.new.min(MOST_FRAMES);
        }
        let (new, per) = (of as u128 * self.new as u128, self.of.max(1) as u128);
        ((new + per / 2) / per).clamp(1, most) as usize
    }

    /// Begins at this frame of a motion of `old` frames; at the motion's beginning if that was so already. The speed stays.
    pub fn begin_at(&mut self, frame: usize, old: usize) {
        self.first = (frame > 0 && self.first != Some(frame)).then_some(frame);
        if self.last.is_some_and(|last| last <= frame) {
            self.last = None;
        }
        self.drop_empty(old);
    }

    /// Ends at this frame of a motion of `old` frames; at the motion's end if that was so already. The speed stays.
    pub fn end_at(&mut self, frame: usize, old: usize) {
        self.last = (frame + 1 < old && self.last != Some(frame)).then_some(frame);
        if self.first.is_some_and(|first| first >= frame) {
            self.first = None;
        }
        self.drop_empty(old);
    }

    /// Between a frame and itself there is nothing to warp.
    fn drop_empty(&mut self, old: usize) {
        if self.stretch(old).is_none() {
            (self.first, self.last) = (None, None);
        }
    }

    /// More new frames for a motion of `old` frames, or fewer: to the next whole tenth of what is warped, or `fine`, by one.
    pub fn change(&mut self, more: bool, fine: bool, old: usize) {
        let of = self.stretch(old).map_or(old, |(first, last)| last - first);
        if of == 0 {
            return;
        }
        let now = self.count(of);
        let new = match (more, fine) {
            (true, true) => now.saturating_add(1),
            (false, true) => now.saturating_sub(1),
            (_, false) => next_tenth(of, now, more),
        };
        (self.new, self.of) = (new.clamp(1, MOST_FRAMES), of);
    }
}

/// The next number above or below `now` that is a whole number of tenths of `of`, rounded.
fn next_tenth(of: usize, now: usize, more: bool) -> usize {
    let tenths = |count: u128| ((of as u128 * count + 5) / 10) as usize;
    // Rounding moves by less than a tenth, and in short motions several tenths are one frame.
    let near = (now as u128 * 10) / (of.max(1) as u128);
    let mut around = near.saturating_sub(11)..=near + 11;
    let next = match more {
        true => around.map(tenths).find(|count| *count > now),
        false => around.rfind(|count| tenths(*count) < now).map(tenths),
    };
    next.unwrap_or(now)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn whole(old: usize, new: usize) -> Warp {
        Warp::new(TimeMap::Whole { old, new })
    }

    fn counts(mut warp: Warp, old: usize, more: bool) -> Vec<usize> {
        let mut counts = Vec::new();
        for _ in 0..22 {
            warp.change(more, false, old);
            counts.push(warp.map(old).frame_count());
        }
        counts
    }

    #[test]
    fn tenths_hit_a_half_the_whole_and_the_double_from_wherever_one_begins() {
        let up = counts(whole(480, 1), 480, true);
        assert_eq!(up[..5], [48, 96, 144, 192, 240]);
        assert!([240, 480, 960].iter().all(|count| up.contains(count)), "{up:?}");
        let down = counts(whole(480, 1000), 480, false);
        assert_eq!(down[..3], [960, 912, 864]);
        assert_eq!(down[19..], [48, 1, 1], "there is no motion with fewer frames than one");
        // Of a motion of three frames a tenth is less than a frame.
        assert_eq!(counts(whole(3, 1), 3, true)[..6], [2, 3, 4, 5, 6, 7]);
        assert_eq!(counts(whole(3, 6), 3, false)[..6], [5, 4, 3, 2, 1, 1]);
        let mut most = whole(480, MOST_FRAMES - 1);
        most.change(true, false, 480);
        most.change(true, true, 480);
        assert_eq!(most.map(480).frame_count(), MOST_FRAMES);
    }

    #[test]
    fn one_by_one_between_the_tenths() {
        let mut warp = whole(480, 960);
        warp.change(true, true, 480);
        assert_eq!(warp.map(480).frame_count(), 961);
        warp.change(false, false, 480);
        assert_eq!(warp.map(480).frame_count(), 960);
        warp.change(false, true, 480);
        warp.change(true, false, 480);
        assert_eq!(warp.map(480).frame_count(), 960);
    }

    #[test]
    fn another_stretch_has_the_same_speed_and_back_is_as_before() {
        let mut warp = whole(480, 701);
        warp.begin_at(100, 480);
        assert_eq!(warp.map(480), TimeMap::Stretch { old: 480, first: 100, last: 479, new: 553 });
        warp.end_at(160, 480);
        assert_eq!(warp.map(480), TimeMap::Stretch { old: 480, first: 100, last: 160, new: 88 });
        warp.begin_at(100, 480);
        assert_eq!(warp.map(480), TimeMap::Stretch { old: 480, first: 0, last: 160, new: 234 });
        warp.end_at(160, 480);
        assert_eq!(warp, whole(480, 701));
    }

    #[test]
    fn an_end_before_the_beginning_begins_anew_and_an_empty_stretch_is_none() {
        let mut warp = whole(480, 960);
        warp.end_at(100, 480);
        warp.begin_at(200, 480);
        assert_eq!(warp.map(480), TimeMap::Stretch { old: 480, first: 200, last: 479, new: 558 });
        warp.end_at(150, 480);
        assert_eq!(warp.map(480), TimeMap::Stretch { old: 480, first: 0, last: 150, new: 300 });
        for (frame, end) in [(479, false), (0, true), (0, false), (479, true)] {
            let mut warp = whole(480, 960);
            if end {
                warp.end_at(frame, 480)
            } else {
                warp.begin_at(frame, 480)
            }
            assert_eq!(warp, whole(480, 960), "{frame}");
        }
    }

    #[test]
    fn a_motion_that_has_changed_keeps_what_it_can_of_the_warp() {
        let warp = whole(480, 960);
        assert_eq!(warp.for_motion(500).map(500), TimeMap::Whole { old: 500, new: 960 });
        let mut stretch = warp;
        stretch.begin_at(100, 480);
        stretch.end_at(160, 480);
        let changed = |old: usize| stretch.for_motion(old).map(old);
        assert_eq!(changed(500), TimeMap::Stretch { old: 500, first: 100, last: 160, new: 120 });
        assert_eq!(changed(131), TimeMap::Stretch { old: 131, first: 100, last: 130, new: 60 });
        assert_eq!(changed(90), TimeMap::Whole { old: 90, new: 180 });
        assert_eq!(changed(0).frame_count(), 0);
    }

    #[test]
    fn what_the_command_line_asks_for_is_told_even_before_the_motion_can_be_read() {
        let warping = |frames, keyframes| Warping { frames, keyframes };
        let of_none = Warp::of_motion(&warping(Some(960), None), 0);
        assert_eq!(of_none.for_motion(480).map(480), TimeMap::Whole { old: 480, new: 960 });
        // Twice nothing is nothing, and stays so for no other motion.
        let twice = Warp::of_motion(&warping(None, None), 0);
        assert_eq!(twice.for_motion(0).map(0).frame_count(), 0);
        assert_eq!(twice.for_motion(480).map(480), TimeMap::Whole { old: 480, new: 960 });
        let stretch = Warp::of_motion(&warping(None, Some((160, 100))), 480);
        assert_eq!(stretch.map(480), TimeMap::Stretch { old: 480, first: 100, last: 160, new: 120 });
    }

    proptest! {
        #[test]
        fn whatever_keys_are_pressed_there_is_a_frame_and_never_too_many(
            old in 1usize..300,
            new in prop_oneof![1usize..900, Just(MOST_FRAMES)],
            keys in prop::collection::vec((0u8..4, 0usize..300, any::<bool>()), 0..40),
        ) {
            let mut warp = whole(old, new);
            for (key, frame, fine) in keys {
                let frame = frame % old;
                match key {
                    0 => warp.begin_at(frame, old),
                    1 => warp.end_at(frame, old),
                    key => warp.change(key == 2, fine, old),
                }
                let map = warp.map(old);
                prop_assert!(map.old_count() == old);
                prop_assert!((1..=MOST_FRAMES + old).contains(&map.frame_count()), "{map:?}");
                if let TimeMap::Stretch { first, last, new, .. } = map {
                    prop_assert!(first < last && last < old && new >= 1);
                }
            }
        }
    }
}
