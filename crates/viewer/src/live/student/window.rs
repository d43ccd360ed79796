//! Which batches of a motion are kept: those near the frame that is shown.

use std::ops::Range;

/// How many batches are asked for ahead of the frame that is shown, before anything else is asked.
pub(super) const AHEAD: usize = 4;

/// The batches of one motion, and how many of them may be kept. The first batch follows the last, as when it is played.
#[derive(Clone, Copy, Debug)]
pub(super) struct Window {
    frame_count: usize,
    batch_size: usize,
    most: usize,
}

impl Window {
    pub(super) fn new(frame_count: usize, batch_size: usize, most: usize) -> Window {
        Window { frame_count, batch_size: batch_size.max(1), most: most.max(2 * AHEAD) }
    }

    /// How many batches there are.
    pub(super) fn count(&self) -> usize {
        self.frame_count.div_ceil(self.batch_size)
    }

    /// How many of them may be kept.
    pub(super) fn len(&self) -> usize {
        self.most.min(self.count())
    }

    pub(super) fn batch_size(&self) -> usize {
        self.batch_size
    }

    /// The batch in which `frame` is.
    pub(super) fn batch_of(&self, frame: usize) -> usize {
        frame / self.batch_size
    }

    /// The frames of a batch.
    pub(super) fn frames(&self, batch: usize) -> Range<usize> {
        let first = batch * self.batch_size;
        first..(first + self.batch_size).min(self.frame_count)
    }

    /// The batch that is kept in place `rank` while `frame` is shown: its own, those ahead, and last those behind.
    pub(super) fn batch(&self, frame: usize, rank: usize) -> Option<usize> {
        let (len, count) = (self.len(), self.count());
        if rank >= len {
            return None;
        }
        let ahead = len - len / 8;
        let step = if rank < ahead { rank } else { count - 1 - (rank - ahead) };
        Some((self.batch_of(frame) + step) % count)
    }

    /// Whether a batch is kept while `frame` is shown.
    pub(super) fn holds(&self, frame: usize, batch: usize) -> bool {
        let (len, count) = (self.len(), self.count());
        let step = (batch + count - self.batch_of(frame) % count) % count;
        step < len - len / 8 || count - step <= len / 8
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_asked_is_what_is_kept_and_never_more_than_it_may_be() {
        for (frames, size, most) in [(1, 100, 16), (100, 10, 16), (1000, 10, 16), (999, 7, 50), (170, 10, 17)]
        {
            let window = Window::new(frames, size, most);
            for shown in [0, frames / 2, frames - 1] {
                let asked: Vec<usize> = (0..=most).filter_map(|rank| window.batch(shown, rank)).collect();
                let mut kept: Vec<usize> =
                    (0..window.count()).filter(|batch| window.holds(shown, *batch)).collect();
                assert_eq!(asked.len(), window.len(), "{window:?}");
                assert_eq!(asked[0], shown / size);
                let mut sorted = asked.clone();
                sorted.sort_unstable();
                kept.sort_unstable();
                assert_eq!(sorted, kept, "{window:?} at {shown}");
                assert!(kept.len() <= most);
            }
        }
    }
}
