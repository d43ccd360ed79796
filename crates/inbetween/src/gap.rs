//! All joints between two keyframes, a few frames at a time.

use std::sync::Mutex;

use glam::{Vec3, Vec4};
use skeleton::{Joint, Representation, Transform};

use crate::InbetweenClip;
use crate::lanes::{LANES, Positions, Rotations};
use crate::turn::Turn;

/// Memory for the poses of one gap, to be used again for the next one.
#[derive(Clone, Debug, Default)]
pub(crate) struct Gap {
    /// The clip's number and the two keyframes.
    of: Option<(u64, usize, usize)>,
    /// One for each joint.
    steps: Vec<Step>,
    /// The first of the frames that are posed, counted from the first keyframe; none are yet when it is 0.
    first: usize,
    poses: Vec<(Rotations, Positions)>,
}

/// A [`Gap`] for whoever asks, on any thread. Two who ask at the same time do not wait for each other.
#[derive(Debug, Default)]
pub(crate) struct Spare(Mutex<Gap>);

impl Spare {
    pub(crate) fn lend(&self, user: impl FnOnce(&mut Gap)) {
        match self.0.try_lock() {
            Ok(mut gap) => user(&mut gap),
            Err(_) => user(&mut Gap::default()),
        }
    }
}

/// The memory is not shared with the original.
impl Clone for Spare {
    fn clone(&self) -> Spare {
        Spare::default()
    }
}

/// What it takes to place a joint.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Step {
    parent: Option<usize>,
    turn: Turn,
    from: Vec3,
    way: Vec3,
}

impl Step {
    /// From the keyframe `start` of `clip` to the keyframe `end`, both of which there are.
    pub(crate) fn new(clip: &InbetweenClip, start: usize, end: usize, joint: &Joint) -> Step {
        let joints = clip.skeleton.len();
        let [from, to] = [start, end].map(|frame| frame * joints + joint.id.0);
        let turn = match (clip.places[joint.id.0], clip.representation) {
            (None, _) => Turn::Not,
            (Some(_), Representation::Quaternion) => Turn::arc(clip.rotations[from], clip.rotations[to]),
            (Some(place), Representation::Euler) => {
                let [from, to] = [start, end].map(|frame| frame * clip.turning + place);
                Turn::angles(joint.rotation_order, clip.angles[from], clip.halves[from], clip.angles[to])
            }
        };
        let way = clip.positions[to] - clip.positions[from];
        Step { parent: joint.parent.map(|parent| parent.0), turn, from: clip.positions[from], way }
    }

    /// The local rotations, where the joint is turned, and positions.
    #[inline]
    pub(crate) fn at(&self, t: Vec4) -> (Option<Rotations>, Positions) {
        (self.turn.at(t), Positions::along(self.from, self.way, t))
    }
}

impl Gap {
    /// Poses `frame`, which is between the keyframes `start` and `end` of `clip`, together with some that follow it.
    pub(crate) fn pose(&mut self, clip: &InbetweenClip, start: usize, end: usize, frame: usize) -> Posed<'_> {
        if self.of != Some((clip.id, start, end)) {
            self.of = Some((clip.id, start, end));
            self.first = 0;
            self.steps.clear();
            self.steps.extend(clip.skeleton.joints().iter().map(|joint| Step::new(clip, start, end, joint)));
        }
        let frame = frame - start;
        let first = frame - (frame - 1) % LANES;
        if self.first != first {
            self.first = first;
            let t = |lane: usize| share(0, end - start, first + lane);
            self.pose_all(Vec4::from_array(std::array::from_fn(t)));
        }
        Posed { poses: &self.poses, lane: frame - first }
    }

    /// Parents first.
    fn pose_all(&mut self, t: Vec4) {
        self.poses.clear();
        for step in &self.steps {
            let (rotation, position) = step.at(t);
            let parent = step.parent.map(|parent| self.poses[parent]);
            self.poses.push(match parent {
                None => (rotation.unwrap_or(Rotations::IDENTITY), position),
                Some((turned, at)) => {
                    (rotation.map_or(turned, |rotation| turned * rotation), at + turned * position)
                }
            });
        }
    }
}

/// How far a frame is from `start` to `end`: 0 is the first, 1 is the second.
pub(crate) fn share(start: usize, end: usize, frame: usize) -> f32 {
    (frame - start) as f32 / (end - start) as f32
}

/// The pose of one frame.
pub(crate) struct Posed<'a> {
    poses: &'a [(Rotations, Positions)],
    lane: usize,
}

impl Posed<'_> {
    /// Where a joint is.
    pub(crate) fn position(&self, joint: usize) -> Vec3 {
        self.poses[joint].1.lane(self.lane)
    }

    /// Where a joint is and how it is turned.
    pub(crate) fn transform(&self, joint: usize) -> Transform {
        let (rotations, positions) = self.poses[joint];
        Transform { rotation: rotations.lane(self.lane), position: positions.lane(self.lane) }
    }
}
