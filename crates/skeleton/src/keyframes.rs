//! Keyframes: what an algorithm that chooses them is told about a motion.

use std::fmt;

use crate::{Frame, Pose, Representation, Skeleton};

/// The errors of single frames, for any two keyframes around them.
#[derive(Clone, Copy)]
pub struct FrameErrors<'a>(&'a dyn Fn(usize, usize, usize) -> f64);

impl<'a> FrameErrors<'a> {
    /// `error(start, end, frame)` is asked for frames between two keyframes: start < frame < end.
    pub fn new(error: &'a dyn Fn(usize, usize, usize) -> f64) -> Self {
        FrameErrors(error)
    }

    /// How far `frame` is from the original when it is interpolated between the keyframes `start` and `end`: the error
    /// of part 1. A keyframe itself is not interpolated: its error is 0.
    ///
    /// # Panics
    ///
    /// When the frame is not between the two.
    #[track_caller]
    pub fn between(&self, start: usize, end: usize, frame: usize) -> f64 {
        assert!(
            start <= frame && frame <= end,
            "errors.between({start}, {end}, {frame}): frame {frame} is not between {start} and {end}"
        );
        if frame == start || frame == end { 0.0 } else { (self.0)(start, end, frame) }
    }
}

impl fmt::Debug for FrameErrors<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("FrameErrors")
    }
}

/// What it costs to remove keyframes.
#[derive(Clone, Copy)]
pub struct RemovalCosts<'a>(&'a dyn Fn(usize, usize, usize) -> f64);

impl<'a> RemovalCosts<'a> {
    /// `cost(before, frame, after)` is asked with before < frame < after.
    pub fn new(cost: &'a dyn Fn(usize, usize, usize) -> f64) -> Self {
        RemovalCosts(cost)
    }

    /// What it costs to remove the keyframe `frame` while `before` and `after` are the keyframes next to it: part 2.
    ///
    /// # Panics
    ///
    /// When the three do not come one after the other.
    #[track_caller]
    pub fn of(&self, before: usize, frame: usize, after: usize) -> f64 {
        assert!(
            before < frame && frame < after,
            "costs.of({before}, {frame}, {after}): these three do not come one after the other"
        );
        (self.0)(before, frame, after)
    }
}

impl fmt::Debug for RemovalCosts<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("RemovalCosts")
    }
}

/// The three functions of the assignment on keyframes.
#[derive(Clone, Copy, Debug)]
pub struct KeyframesFunctions {
    /// Part 1: how far an interpolated pose is from the original one.
    pub pose_error: fn(&Skeleton, &Pose, &Pose) -> f64,
    /// Part 2: by how much the accumulated error grows when a keyframe is removed: before, the keyframe, after.
    pub removal_cost: fn(usize, usize, usize, &FrameErrors) -> f64,
    /// Part 3: of so many frames, which ones stay as keyframes when only so many may.
    pub reduce: fn(usize, usize, &RemovalCosts) -> Vec<usize>,
}

/// The poses of a motion, as it is and as it would be between keyframes.
pub trait Clip {
    /// How many frames there are.
    fn frame_count(&self) -> usize;

    /// Makes `pose` the pose of `frame` (from 0).
    fn original(&self, frame: usize, pose: &mut Pose);

    /// Makes `pose` that of `frame` when it is interpolated between the keyframes `start` and `end`.
    fn between(&self, start: usize, end: usize, frame: usize, pose: &mut Pose);
}

/// Makes a [`Clip`] of the frames of a motion.
pub type MakeClip = fn(&Skeleton, &[Frame], Representation) -> Box<dyn Clip>;
