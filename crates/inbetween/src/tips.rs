//! Where the tips of a skeleton are.

use glam::Vec3;
use skeleton::{Clip, Pose, Skeleton};

use crate::gap::Gap;
use crate::{InbetweenClip, Way};

/// Memory that is used again from one pose to the next. It may serve any clips in turn; it serves frames of the same
/// gap, one after the other, best.
#[derive(Clone, Debug, Default)]
pub struct Scratch {
    gap: Gap,
    tips: Vec<Vec3>,
}

/// End Sites, and joints that no other joint hangs on.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tips {
    ids: Vec<usize>,
    /// For each frame where each of them is.
    originals: Vec<Vec3>,
}

impl Tips {
    pub(crate) fn of(skeleton: &Skeleton) -> Tips {
        let mut is_tip = vec![true; skeleton.len()];
        for parent in skeleton.joints().iter().filter_map(|joint| joint.parent) {
            is_tip[parent.0] = false;
        }
        Tips { ids: (0..skeleton.len()).filter(|id| is_tip[*id]).collect(), originals: Vec::new() }
    }
}

impl InbetweenClip {
    /// Where the tips are in `frame`, in the order of the joints. Empty for a motion without frames.
    pub fn tips(&self, frame: usize) -> &[Vec3] {
        let Some(last) = self.frame_count.checked_sub(1) else { return &[] };
        let first = frame.min(last) * self.tips.ids.len();
        &self.tips.originals[first..first + self.tips.ids.len()]
    }

    /// Where the tips are in `frame` when it is interpolated between the keyframes `start` and `end`, in the order of
    /// the joints: where [`between`](Clip::between) puts them. Takes no new memory when the same `scratch` has served
    /// before. Empty for a motion without frames.
    pub fn tips_between<'a>(
        &'a self,
        start: usize,
        end: usize,
        frame: usize,
        scratch: &'a mut Scratch,
    ) -> &'a [Vec3] {
        match self.way(start, end, frame) {
            Way::Frame(frame) => self.tips(frame),
            Way::Between { start, end, frame } => {
                let posed = scratch.gap.pose(self, start, end, frame);
                scratch.tips.clear();
                scratch.tips.extend(self.tips.ids.iter().map(|id| posed.position(*id)));
                &scratch.tips
            }
        }
    }

    pub(crate) fn remember_tips(&mut self) {
        let mut pose = Pose::default();
        let mut originals = Vec::with_capacity(self.frame_count * self.tips.ids.len());
        for frame in 0..self.frame_count {
            self.original(frame, &mut pose);
            originals.extend(self.tips.ids.iter().map(|id| pose.transforms()[*id].position));
        }
        self.tips.originals = originals;
    }
}
