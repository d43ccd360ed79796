//! The forward-kinematics exercise: what can be asked of its three functions.

use glam::{Quat, Vec3};
use serde::{Deserialize, Serialize};
use skeleton::{FkFunctions, Frame, FrameCursor, Joint, Leftover, Pose, Skeleton, pose_frame};

/// A question to one of the three functions, or to all of them together.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Question {
    /// Part 1, asked for one joint after the other with one cursor over `angles` (degrees).
    LocalQuaternions {
        /// The joints in the order in which they are asked.
        joints: Vec<Joint>,
        /// The angles of the frame, in degrees.
        angles: Vec<f32>,
    },
    /// Part 2, asked for one joint.
    GlobalQuaternion {
        /// The joint.
        joint: Joint,
        /// Its local rotation.
        local: Quat,
        /// The global transforms of the joints before it.
        pose: Pose,
    },
    /// Part 3, asked for one joint.
    GlobalPosition {
        /// The joint.
        joint: Joint,
        /// Its position relative to its parent, in the parent's axes.
        local_position: Vec3,
        /// The global transforms of the joints before it, and its own global rotation.
        pose: Pose,
    },
    /// All three parts together, over several frames.
    Poses {
        /// The skeleton that moves.
        skeleton: Skeleton,
        /// The frames to pose.
        frames: Vec<Frame>,
    },
}

/// The answer to a [`Question`] of the same name.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Answer {
    /// One local rotation per joint.
    LocalQuaternions(Vec<LocalAnswer>),
    /// The global rotation.
    GlobalQuaternion(Quat),
    /// The global position.
    GlobalPosition(Vec3),
    /// One pose per frame.
    Poses(Vec<PosedFrame>),
}

/// What part 1 gave for one joint.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct LocalAnswer {
    /// The local rotation.
    pub rotation: Quat,
    /// How many angles the function took from the frame for this joint.
    pub taken: usize,
}

/// What the three parts together gave for one frame.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PosedFrame {
    /// The global transforms.
    pub pose: Pose,
    /// How many angles the functions took over the whole frame.
    pub taken: usize,
    /// How many angles the frame holds.
    pub available: usize,
}

impl Question {
    /// Asks `functions`, here and now. A panic of theirs goes through.
    pub fn ask(&self, functions: &FkFunctions) -> Answer {
        match self {
            Question::LocalQuaternions { joints, angles } => {
                let mut cursor = FrameCursor::new(angles);
                let answers = joints.iter().map(|joint| {
                    let before = cursor.taken();
                    let rotation = (functions.local_quaternion)(joint, &mut cursor);
                    LocalAnswer { rotation, taken: cursor.taken().saturating_sub(before) }
                });
                Answer::LocalQuaternions(answers.collect())
            }
            Question::GlobalQuaternion { joint, local, pose } => {
                Answer::GlobalQuaternion((functions.global_quaternion)(joint, *local, pose))
            }
            Question::GlobalPosition { joint, local_position, pose } => {
                Answer::GlobalPosition((functions.global_position)(joint, *local_position, pose))
            }
            Question::Poses { skeleton, frames } => {
                let answers = frames.iter().map(|frame| {
                    let mut pose = Pose::default();
                    let Leftover { taken, available } = pose_frame(skeleton, frame, functions, &mut pose);
                    PosedFrame { pose, taken, available }
                });
                Answer::Poses(answers.collect())
            }
        }
    }

    /// More bytes than any honest answer to this question takes on the wire.
    pub(crate) fn answer_limit(&self) -> usize {
        // A transform is 7 numbers of 4 bytes; a count is at most 10 bytes.
        const PER_JOINT: usize = 28 + 10;
        let joints = match self {
            Question::LocalQuaternions { joints, .. } => joints.len(),
            Question::GlobalQuaternion { .. } | Question::GlobalPosition { .. } => 1,
            Question::Poses { skeleton, frames } => frames.len() * (skeleton.len() + 1),
        };
        1024 + PER_JOINT * joints
    }
}
