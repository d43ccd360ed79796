//! Poses between keyframes, fast.
//!
//! What the exercises on forward kinematics and on interpolation compute joint by joint, [`InbetweenClip`] computes
//! for a whole motion, with everything prepared that does not change. It is linked into the process that runs a
//! student's keyframe functions: no error of a pose and no cost of a keyframe is calculated here.
//!
//! # Standing still
//!
//! Where a motion stands still, nothing needs to be interpolated, and nothing is: frames between two keyframes of the
//! same [stretch that stands still](InbetweenClip::is_still) are given as they are. A stretch begins with a frame,
//! and goes on for as long as every joint is as in that frame:
//!
//! - each of its angles within 0.0002 degrees, or, with [`Representation::Quaternion`], its rotation within 0.0005
//!   degrees;
//! - its local position within a millionth of the skeleton's [extent](Skeleton::extent), or within four times the
//!   last digit that an `f32` of the size of that position has, where that is more.
//!
//! That is what angles of some hundred degrees lose by being stored as `f32`, and far less than any camera sees.
#![deny(missing_docs)]

mod gap;
mod lanes;
mod still;
mod tips;
mod turn;

use std::sync::atomic::{AtomicU64, Ordering};

use gap::{Spare, Step, share};
use glam::{Quat, Vec3, Vec4};
use lanes::Rotations;
use skeleton::{
    Clip, Frame, FrameCursor, Joint, LocalPose, Pose, Representation, RotationOrder, Skeleton, Transform,
};

pub use tips::Scratch;
use tips::Tips;
use turn::Halves;

/// A motion whose frames can be posed as they are, or as they would be between keyframes.
///
/// Frames are counted from 0. No number of a frame makes it panic: a frame behind the last one counts as the last
/// one, a frame outside of two keyframes as the nearer of the two, and when the keyframe `end` is not behind `start`
/// there is only `start`. A motion without frames stands in its rest pose.
#[derive(Clone, Debug)]
pub struct InbetweenClip {
    /// No other clip has this number, except for clones.
    id: u64,
    skeleton: Skeleton,
    representation: Representation,
    frame_count: usize,
    /// For each joint the place of its angles among those of a frame, for those that have any.
    places: Vec<Option<usize>>,
    /// How many joints have angles.
    turning: usize,
    /// For each frame the angles of each joint that has any, in degrees. Only where angles are interpolated.
    angles: Vec<[f32; 3]>,
    /// Half of these, and also only there.
    halves: Vec<Halves>,
    /// For each frame the local rotation of each joint.
    rotations: Vec<Quat>,
    /// For each frame the local position of each joint.
    positions: Vec<Vec3>,
    /// For each frame the number of the stretch that stands still with it.
    stretches: Vec<usize>,
    tips: Tips,
    /// For those who bring no memory of their own.
    spare: Spare,
}

static NEXT_ID: AtomicU64 = AtomicU64::new(0);

/// The same, for functions that ask about any [`Clip`].
pub fn clip(skeleton: &Skeleton, frames: &[Frame], representation: Representation) -> Box<dyn Clip> {
    Box::new(InbetweenClip::new(skeleton, frames, representation))
}

/// Makes `pose` the global pose that a local one makes, parents first. Where `local` has no rotation for a joint, it
/// is not turned; where it has no position, the joint is at its offset.
pub fn pose_of(skeleton: &Skeleton, local: &LocalPose, pose: &mut Pose) {
    let rotation = |joint: &Joint| local.rotations.get(joint.id.0).copied().unwrap_or(Quat::IDENTITY);
    let position = |joint: &Joint| local.positions.get(joint.id.0).copied().unwrap_or(joint.offset);
    fill(skeleton, pose, |joint| (rotation(joint), position(joint)));
}

impl InbetweenClip {
    /// Prepares the frames of a motion. Angles that a frame lacks are zero, and positions that it lacks are the
    /// offsets.
    pub fn new(skeleton: &Skeleton, frames: &[Frame], representation: Representation) -> InbetweenClip {
        let joints = skeleton.joints();
        let mut turning = 0;
        let place = |joint: &Joint| {
            let turns = joint.rotation_order != RotationOrder::None;
            turning += usize::from(turns);
            turns.then(|| turning - 1)
        };
        let places: Vec<Option<usize>> = joints.iter().map(place).collect();
        let mut clip = InbetweenClip {
            id: NEXT_ID.fetch_add(1, Ordering::Relaxed),
            skeleton: skeleton.clone(),
            representation,
            frame_count: frames.len(),
            places,
            turning,
            angles: Vec::new(),
            halves: Vec::new(),
            rotations: Vec::with_capacity(frames.len() * joints.len()),
            positions: Vec::with_capacity(frames.len() * joints.len()),
            stretches: Vec::new(),
            tips: Tips::of(skeleton),
            spare: Spare::default(),
        };
        for frame in frames {
            let mut cursor = FrameCursor::new(&frame.angles);
            let mut positions = frame.local_positions.iter().copied();
            for joint in joints {
                let angles = joint.rotation_order.axes().map(|_| cursor.take3());
                if representation == Representation::Euler {
                    clip.angles.extend(angles);
                    clip.halves.extend(angles.map(Halves::of));
                }
                clip.rotations.push(turn::quaternion(joint.rotation_order, angles.unwrap_or_default()));
                clip.positions.push(positions.next().unwrap_or(joint.offset));
            }
        }
        clip.stretches = still::stretches(&clip);
        clip.remember_tips();
        clip
    }

    /// The skeleton that moves.
    pub fn skeleton(&self) -> &Skeleton {
        &self.skeleton
    }

    /// What is interpolated between keyframes.
    pub fn representation(&self) -> Representation {
        self.representation
    }

    /// How many frames there are.
    pub fn frame_count(&self) -> usize {
        self.frame_count
    }

    /// The local pose of `frame`.
    pub fn local(&self, frame: usize) -> LocalPose {
        self.local_by(|joint| self.local_of(frame, joint))
    }

    /// The local pose of `frame` when it is interpolated between the keyframes `start` and `end`.
    pub fn local_between(&self, start: usize, end: usize, frame: usize) -> LocalPose {
        match self.way(start, end, frame) {
            Way::Frame(frame) => self.local(frame),
            Way::Between { start, end, frame } => {
                let t = Vec4::splat(share(start, end, frame));
                self.local_by(|joint| {
                    let (rotations, positions) = Step::new(self, start, end, joint).at(t);
                    (rotations.unwrap_or(Rotations::IDENTITY).lane(0), positions.lane(0))
                })
            }
        }
    }

    /// Whether all frames from `start` to `end` are the same pose, or differ by no more than rounding does: see
    /// [the rule](crate#standing-still). At once, however many they are.
    pub fn is_still(&self, start: usize, end: usize) -> bool {
        let of = |frame: usize| self.stretches.get(frame.min(self.frame_count.saturating_sub(1)));
        of(start) == of(end)
    }

    fn local_by(&self, local: impl Fn(&Joint) -> (Quat, Vec3)) -> LocalPose {
        let (rotations, positions) = self.skeleton.joints().iter().map(local).unzip();
        LocalPose { rotations, positions }
    }

    fn local_of(&self, frame: usize, joint: &Joint) -> (Quat, Vec3) {
        if self.frame_count == 0 {
            return (Quat::IDENTITY, joint.offset);
        }
        let index = frame.min(self.frame_count - 1) * self.skeleton.len() + joint.id.0;
        (self.rotations[index], self.positions[index])
    }

    /// How `frame` is come by between the keyframes `start` and `end`, whatever these three are.
    fn way(&self, start: usize, end: usize, frame: usize) -> Way {
        let last = self.frame_count.saturating_sub(1);
        let start = start.min(last);
        let end = end.clamp(start, last);
        let frame = frame.clamp(start, end);
        if frame == start || frame == end || self.is_still(start, end) {
            return Way::Frame(frame);
        }
        Way::Between { start, end, frame }
    }
}

/// How a frame is come by.
enum Way {
    /// It is this one, as it is.
    Frame(usize),
    /// It is between two others, and all three there are.
    Between { start: usize, end: usize, frame: usize },
}

impl Clip for InbetweenClip {
    fn frame_count(&self) -> usize {
        self.frame_count
    }

    fn original(&self, frame: usize, pose: &mut Pose) {
        fill(&self.skeleton, pose, |joint| self.local_of(frame, joint));
    }

    fn between(&self, start: usize, end: usize, frame: usize, pose: &mut Pose) {
        match self.way(start, end, frame) {
            Way::Frame(frame) => self.original(frame, pose),
            Way::Between { start, end, frame } => self.spare.lend(|gap| {
                pose.reset(self.skeleton.len());
                let posed = gap.pose(self, start, end, frame);
                for joint in self.skeleton.joints() {
                    pose[joint.id] = posed.transform(joint.id.0);
                }
            }),
        }
    }
}

/// Fills `pose`, parents first, from each joint's local rotation and position.
fn fill(skeleton: &Skeleton, pose: &mut Pose, local: impl Fn(&Joint) -> (Quat, Vec3)) {
    pose.reset(skeleton.len());
    for joint in skeleton.joints() {
        let (rotation, position) = local(joint);
        pose[joint.id] = match joint.parent {
            None => Transform { rotation, position },
            Some(parent) => {
                let parent = pose[parent];
                Transform {
                    rotation: parent.rotation * rotation,
                    position: parent.position + parent.rotation * position,
                }
            }
        };
    }
}
