//! The errors of frames and gaps.

use std::cell::RefCell;
use std::collections::HashMap;

use inbetween::{InbetweenClip, Scratch};
use skeleton::{Frame, Representation, Skeleton};

/// The errors of so many gaps are remembered. Then all are forgotten, and computed again when they are wanted.
const MOST_REMEMBERED: usize = 1 << 19;

/// The errors of one motion in one representation, in the motion's unit, squared.
#[derive(Debug)]
pub struct Errors {
    clip: InbetweenClip,
    memory: RefCell<Memory>,
}

#[derive(Debug, Default)]
struct Memory {
    /// By their first and last keyframe.
    gaps: HashMap<(usize, usize), f64>,
    scratch: Scratch,
    /// The errors of the frames of one gap.
    frames: Vec<f64>,
    poses: u64,
}

impl Errors {
    /// Prepares the frames of a motion.
    pub fn new(skeleton: &Skeleton, frames: &[Frame], representation: Representation) -> Errors {
        Errors { clip: InbetweenClip::new(skeleton, frames, representation), memory: RefCell::default() }
    }

    /// How many frames the motion has.
    pub fn frame_count(&self) -> usize {
        self.clip.frame_count()
    }

    /// The motion.
    pub fn clip(&self) -> &InbetweenClip {
        &self.clip
    }

    /// How far `frame` is off when it is interpolated between the keyframes `start` and `end`: the sum over all tips
    /// of the squared distance. 0 for a keyframe itself. Not a number unless `start` ≤ `frame` ≤ `end`, all three in
    /// the motion.
    pub fn of_frame(&self, start: usize, end: usize, frame: usize) -> f64 {
        if end >= self.frame_count() || frame < start || end < frame {
            return f64::NAN;
        }
        if frame == start || frame == end || self.clip.is_still(start, end) {
            return 0.0;
        }
        self.memory.borrow_mut().posed(&self.clip, start, end, frame)
    }

    /// The sum of the errors of all frames between the keyframes `start` and `end`. Not a number unless `start` ≤
    /// `end`, both in the motion.
    pub fn of_gap(&self, start: usize, end: usize) -> f64 {
        // No sum is more than infinite.
        self.of_gap_up_to(start, end, f64::INFINITY).unwrap_or(f64::INFINITY)
    }

    /// By how much the error grows when the keyframe `frame` is removed while `before` and `after` are those next to
    /// it.
    pub fn cost(&self, before: usize, frame: usize, after: usize) -> f64 {
        self.of_gap(before, after) - self.of_gap(before, frame) - self.of_gap(frame, after)
    }

    /// The accumulated error of a whole reduction. Not a number unless these are keyframes from the first frame to
    /// the last, in ascending order.
    pub fn of_keyframes(&self, keyframes: &[usize]) -> f64 {
        let last = self.frame_count().checked_sub(1);
        let is_whole = keyframes.first().copied() == last.map(|_| 0)
            && keyframes.last().copied() == last
            && keyframes.is_sorted_by(|a, b| a < b);
        // Begun with 0, because a sum of nothing is −0.
        let sum = |sum, gap: &[usize]| sum + self.of_gap(gap[0], gap[1]);
        if is_whole { keyframes.windows(2).fold(0.0, sum) } else { f64::NAN }
    }

    /// How many poses were computed so far, not counting the frames as they are.
    pub fn poses(&self) -> u64 {
        self.memory.borrow().poses
    }

    /// Whether a gap has no error at all.
    pub(crate) fn is_free(&self, start: usize, end: usize) -> bool {
        self.of_gap_up_to(start, end, 0.0) == Some(0.0)
    }

    /// The error of a gap, or `None` when it shows before its end that it is more than `limit`.
    pub(crate) fn of_gap_up_to(&self, start: usize, end: usize, limit: f64) -> Option<f64> {
        if end >= self.frame_count() || end < start {
            return Some(f64::NAN);
        }
        if end - start < 2 || self.clip.is_still(start, end) {
            return Some(0.0);
        }
        let memory = &mut *self.memory.borrow_mut();
        if let Some(&error) = memory.gaps.get(&(start, end)) {
            return Some(error);
        }
        let error = memory.of_gap_up_to(&self.clip, start, end, limit)?;
        if memory.gaps.len() >= MOST_REMEMBERED {
            memory.gaps.clear();
        }
        memory.gaps.insert((start, end), error);
        Some(error)
    }
}

impl Memory {
    fn of_gap_up_to(&mut self, clip: &InbetweenClip, start: usize, end: usize, limit: f64) -> Option<f64> {
        self.frames.clear();
        self.frames.resize(end - start - 1, 0.0);
        // The frames in the middle are mostly farthest off: they show soonest that a gap is too much.
        let middle = if limit < f64::INFINITY { start.midpoint(end) } else { start + 1 };
        let (mut sum, mut posed) = (0.0, 0);
        for frame in (middle..end).chain(start + 1..middle) {
            let error = self.posed(clip, start, end, frame);
            self.frames[frame - start - 1] = error;
            sum += error;
            posed += 1;
            if sum > limit && posed < self.frames.len() {
                return None;
            }
        }
        // In the order of the frames, so that the result is the same whatever the limit is.
        Some(self.frames.iter().fold(0.0, |sum, error| sum + error))
    }

    fn posed(&mut self, clip: &InbetweenClip, start: usize, end: usize, frame: usize) -> f64 {
        self.poses += 1;
        let tips = clip.tips_between(start, end, frame, &mut self.scratch);
        let pairs = tips.iter().zip(clip.tips(frame));
        pairs
            .map(|(tip, original)| f64::from(tip.distance_squared(*original)))
            .fold(0.0, |sum, one| sum + one)
    }
}
