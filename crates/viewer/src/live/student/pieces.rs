//! Frames in rows, and how far each row is.

use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

use exam::Failure;

/// How far some frames are.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum State {
    /// They have not been asked.
    Fresh,
    /// They were asked together with others, and that failed.
    Suspect,
    /// They are answered.
    Settled,
    /// It is a single one that fails.
    Bad {
        failure: Arc<Failure>,
        /// Whether it was looked for the place at which it does.
        narrowed: bool,
    },
}

/// Frames of a motion in pieces, by their first frame.
#[derive(Default)]
pub(super) struct Pieces(BTreeMap<usize, (usize, State)>);

impl Pieces {
    pub(super) fn clear(&mut self) {
        self.0.clear();
    }

    /// Takes out `frames`, which are whole pieces or none.
    pub(super) fn forget(&mut self, frames: Range<usize>) {
        let inside: Vec<usize> = self.0.range(frames).map(|(first, _)| *first).collect();
        inside.iter().for_each(|first| drop(self.0.remove(first)));
    }

    /// The piece in which `frame` is.
    pub(super) fn at(&self, frame: usize) -> Option<(Range<usize>, &State)> {
        let (first, (end, state)) = self.0.range(..=frame).next_back()?;
        (frame < *end).then_some((*first..*end, state))
    }

    /// The first piece in `frames` that has not been settled.
    pub(super) fn unsettled_in(&self, frames: Range<usize>) -> Option<Range<usize>> {
        let mut pieces = self.0.range(frames);
        pieces.find_map(|(first, (end, state))| {
            matches!(state, State::Fresh | State::Suspect).then_some(*first..*end)
        })
    }

    /// Says how far `frames` are. Pieces that begin or end within them are cut.
    pub(super) fn set(&mut self, frames: Range<usize>, state: State) {
        self.cut(frames.start);
        self.cut(frames.end);
        self.forget(frames.clone());
        if !frames.is_empty() {
            self.0.insert(frames.start, (frames.end, state));
        }
    }

    /// Lets a piece begin at `frame`, if there is one around it.
    fn cut(&mut self, frame: usize) {
        if let Some((first, (end, state))) = self.0.range_mut(..frame).next_back()
            && frame < *end
        {
            let rest = (*end, state.clone());
            debug_assert!(*first < frame);
            *end = frame;
            self.0.insert(frame, rest);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_are_cut_where_it_is_said_and_never_lose_a_frame() {
        let mut pieces = Pieces::default();
        pieces.set(0..10, State::Fresh);
        pieces.set(10..20, State::Fresh);
        pieces.set(3..4, State::Settled);
        assert_eq!(pieces.at(2), Some((0..3, &State::Fresh)));
        assert_eq!(pieces.at(3), Some((3..4, &State::Settled)));
        assert_eq!(pieces.at(9), Some((4..10, &State::Fresh)));
        assert_eq!(pieces.at(20), None);
        pieces.set(0..3, State::Settled);
        assert_eq!(pieces.unsettled_in(0..10), Some(4..10));
        pieces.set(4..10, State::Suspect);
        assert_eq!(pieces.unsettled_in(0..10), Some(4..10));
        pieces.set(4..10, State::Settled);
        assert_eq!(pieces.unsettled_in(0..10), None);
        assert_eq!(pieces.unsettled_in(10..20), Some(10..20));
        pieces.forget(0..10);
        assert_eq!(pieces.at(3), None);
        assert_eq!(pieces.at(10), Some((10..20, &State::Fresh)));
    }
}
