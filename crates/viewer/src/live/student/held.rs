//! The poses at hand for one motion.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::posed::Posed;
use super::window::Window;
use crate::live::worker::Trouble;

/// The newest pose of every frame that is at hand, and what is wrong with the frames that have none of the last version.
pub(super) struct Held {
    window: Window,
    batches: BTreeMap<usize, Vec<Option<(u64, Posed)>>>,
    troubles: BTreeMap<usize, Arc<Trouble>>,
}

impl Held {
    pub(super) fn new(window: Window) -> Held {
        Held { window, batches: BTreeMap::new(), troubles: BTreeMap::new() }
    }

    /// A new version begins: what older ones answered stays until it answers too.
    pub(super) fn begin(&mut self) {
        self.troubles.clear();
    }

    /// Keeps what `version` answered for the frames from `first` on.
    pub(super) fn insert(&mut self, version: u64, first: usize, frames: Vec<Posed>) {
        for (frame, posed) in (first..).zip(frames) {
            let batch = self.window.batch_of(frame);
            let all = self.window.frames(batch);
            let kept = self.batches.entry(batch).or_insert_with(|| vec![None; all.len()]);
            if let Some(place) = kept.get_mut(frame - all.start) {
                *place = Some((version, posed));
            }
        }
    }

    pub(super) fn insert_trouble(&mut self, frame: usize, trouble: Arc<Trouble>) {
        self.troubles.insert(frame, trouble);
    }

    /// The pose of `frame`, and the version that answered it.
    pub(super) fn pose(&self, frame: usize) -> Option<(u64, &Posed)> {
        let kept = self.batches.get(&self.window.batch_of(frame))?;
        let (version, posed) = kept.get(frame % self.window.batch_size())?.as_ref()?;
        Some((*version, posed))
    }

    pub(super) fn trouble(&self, frame: usize) -> Option<&Arc<Trouble>> {
        self.troubles.get(&frame)
    }

    /// When there are more batches than may be kept, forgets those that are far from the frame that is shown, and gives
    /// them.
    pub(super) fn forget_far_from(&mut self, shown: usize) -> Vec<usize> {
        if self.batches.len() <= self.window.len() {
            return Vec::new();
        }
        let window = self.window;
        let far: Vec<usize> =
            self.batches.keys().copied().filter(|batch| !window.holds(shown, *batch)).collect();
        far.iter().for_each(|batch| drop(self.batches.remove(batch)));
        far
    }

    #[cfg(test)]
    pub(super) fn batch_count(&self) -> usize {
        self.batches.len()
    }
}
