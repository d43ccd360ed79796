//! A motion of which frames are interpolated.

use std::sync::Arc;

use skeleton::Pose;

use super::hand::Makers;
use super::reductions::Curves;
use super::wish::Wish;

/// What came of a [`Wish`]. Frames are counted from 0.
#[derive(Clone, Debug)]
pub struct Edited {
    /// What was wanted.
    pub wish: Wish,
    /// Whose work it is.
    pub makers: Makers,
    /// The keyframes, in ascending order: of a stretch its first and its last frame.
    pub keyframes: Vec<usize>,
    /// How many frames are interpolated.
    pub interpolated: usize,
    /// The accumulated error: the sum of the errors of all interpolated frames, in the file's unit, squared.
    pub error: f64,
    /// The root of the mean squared distance of a tip from where it is in the original, in the file's unit: over all frames
    /// from the first keyframe to the last, so that results with different numbers of keyframes can be compared.
    pub distance: f64,
    /// How the error grows in both representations, where that was wanted and is known.
    pub curves: Option<Curves>,
    pub(super) frames: Arc<Frames>,
}

/// The frames from the first keyframe to the last.
#[derive(Debug, Default)]
pub(super) struct Frames {
    pub first: usize,
    /// No pose at all stands for a keyframe.
    pub poses: Vec<Pose>,
    pub errors: Vec<f64>,
}

impl Edited {
    /// The global pose of an interpolated frame; `None` for keyframes and for frames outside of a stretch.
    pub fn pose(&self, frame: usize) -> Option<&Pose> {
        let index = frame.checked_sub(self.frames.first)?;
        self.frames.poses.get(index).filter(|pose| !pose.is_empty())
    }

    /// The error of a frame: the sum, over all tips, of the squared distance from where they are in the original. 0 for
    /// frames that are not interpolated.
    pub fn error_of(&self, frame: usize) -> f64 {
        let index = frame.checked_sub(self.frames.first);
        index.and_then(|index| self.frames.errors.get(index)).copied().unwrap_or(0.0)
    }

    /// Whether a keyframe is at `frame`, or has just been passed: in the `span` frames (at least 1) from it on, played
    /// forwards or backwards.
    pub fn is_at_keyframe(&self, frame: usize, span: usize, backwards: bool) -> bool {
        let before = self.keyframes.partition_point(|keyframe| *keyframe < frame);
        let passed = match (self.keyframes.get(before), backwards) {
            (Some(keyframe), _) if *keyframe == frame => Some(frame),
            (next, true) => next.copied(),
            (_, false) => before.checked_sub(1).map(|before| self.keyframes[before]),
        };
        passed.is_some_and(|keyframe| frame.abs_diff(keyframe) < span.max(1))
    }
}
