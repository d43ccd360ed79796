//! The exercise on interpolation: what can be asked of its three functions.

use glam::Quat;
use serde::{Deserialize, Serialize};
use skeleton::{
    Frame, FrameCursor, InterpolationFunctions, LocalPose, Representation, RotationOrder, Skeleton,
};

/// A question to one of the three functions.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Question {
    /// Part 1.
    Angles {
        /// The angles in one frame, in degrees.
        from: [f32; 3],
        /// The angles in another frame, in degrees.
        to: [f32; 3],
        /// How far it is from the one to the other.
        t: f32,
    },
    /// Part 2.
    Slerp {
        /// One rotation.
        from: Quat,
        /// The other one.
        to: Quat,
        /// How far it is from the one to the other.
        t: f32,
    },
    /// Part 3, and what parts 1 and 2 make of the same joints: a mistake in them is not to cost points again.
    Frame {
        /// The skeleton that moves.
        skeleton: Skeleton,
        /// One frame.
        from: Frame,
        /// The other one.
        to: Frame,
        /// How far it is from the one to the other.
        t: f32,
        /// What of the rotations is interpolated.
        representation: Representation,
        /// The local rotations of both frames, of every joint: with quaternions part 2 is asked about them.
        ends: [Vec<Quat>; 2],
    },
    /// Part 3, for several frames between the same two.
    Between {
        /// The skeleton that moves.
        skeleton: Skeleton,
        /// One frame.
        from: Frame,
        /// The other one.
        to: Frame,
        /// How far each is from the one to the other.
        ts: Vec<f32>,
        /// What of the rotations is interpolated.
        representation: Representation,
    },
}

/// The answer to a [`Question`] of the same name.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Answer {
    /// The angles, in degrees.
    Angles([f32; 3]),
    /// The rotation.
    Slerp(Quat),
    /// The frame between.
    Frame(FrameAnswer),
    /// The frames between.
    Between(Vec<LocalPose>),
}

/// What part 3 gave, and what parts 1 and 2 gave for the same joints.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FrameAnswer {
    /// All joints, by part 3.
    pub local: LocalPose,
    /// With Euler angles: those of every joint that has any, by part 1.
    pub angles: Vec<[f32; 3]>,
    /// With quaternions: the rotation of every joint that has angles, by part 2. Twice, because *q* and −*q* are the same
    /// rotation and part 3 may have come to either of them: from one end to the other, and to the negative of the other.
    pub rotations: Vec<[Quat; 2]>,
}

impl Question {
    /// Asks `functions`, here and now. A panic of theirs goes through.
    pub fn ask(&self, functions: &InterpolationFunctions) -> Answer {
        match self {
            Question::Angles { from, to, t } => {
                Answer::Angles((functions.interpolate_angles)(*from, *to, *t))
            }
            Question::Slerp { from, to, t } => Answer::Slerp((functions.slerp)(*from, *to, *t)),
            Question::Frame { skeleton, from, to, t, representation, ends } => {
                let local = (functions.interpolate_frame)(skeleton, from, to, *t, *representation);
                let mut answer = FrameAnswer { local, ..FrameAnswer::default() };
                let mut cursors = [from, to].map(|frame| FrameCursor::new(&frame.angles));
                for joint in
                    skeleton.joints().iter().filter(|joint| joint.rotation_order != RotationOrder::None)
                {
                    let [from, to] = cursors.each_mut().map(FrameCursor::take3);
                    match representation {
                        Representation::Euler => {
                            answer.angles.push((functions.interpolate_angles)(from, to, *t));
                        }
                        Representation::Quaternion => {
                            let [from, to] = [0, 1]
                                .map(|end: usize| ends[end].get(joint.id.0).copied().unwrap_or_default());
                            answer.rotations.push([to, -to].map(|to| (functions.slerp)(from, to, *t)));
                        }
                    }
                }
                Answer::Frame(answer)
            }
            Question::Between { skeleton, from, to, ts, representation } => {
                let at = |t: &f32| (functions.interpolate_frame)(skeleton, from, to, *t, *representation);
                Answer::Between(ts.iter().map(at).collect())
            }
        }
    }

    /// More bytes than any honest answer to this question takes on the wire.
    pub(crate) fn answer_limit(&self) -> usize {
        // Three rotations and a position of 4 bytes a number, and what holds them together.
        const PER_JOINT: usize = 64;
        let joints = match self {
            Question::Angles { .. } | Question::Slerp { .. } => 1,
            Question::Frame { skeleton, .. } => skeleton.len(),
            Question::Between { skeleton, ts, .. } => (skeleton.len() + 1) * ts.len(),
        };
        1024 + PER_JOINT * joints
    }
}
