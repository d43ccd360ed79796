//! Forward kinematics.

use std::time::Duration;

use exam::fk::{Answer as FkAnswer, LocalAnswer, PosedFrame, Question as FkQuestion};
use exam::{Failure, Subject};
use skeleton::{Frame, Joint};

use super::{put, unfit};
use crate::live::student::posed::{Extra, Posed};
use crate::motion::stage::Stage;

/// Asks for the poses of `frames`.
pub(in crate::live::student) fn poses(
    subject: &mut impl Subject,
    stage: &Stage,
    frames: Vec<Frame>,
    limit: Duration,
) -> Result<Vec<Posed>, Failure> {
    let skeleton = stage.motion().skeleton().clone();
    let (joints, expected) = (skeleton.len(), frames.len());
    match put(subject, FkQuestion::Poses { skeleton, frames }, limit)? {
        FkAnswer::Poses(poses)
            if poses.len() == expected && poses.iter().all(|posed| posed.pose.len() == joints) =>
        {
            Ok(poses.into_iter().map(Posed::from).collect())
        }
        _ => Err(unfit()),
    }
}

/// Asks part 1 for `joints`, one after the other, over `angles` (degrees).
pub(in crate::live::student) fn locals(
    subject: &mut impl Subject,
    joints: &[Joint],
    angles: Vec<f32>,
    limit: Duration,
) -> Result<Vec<LocalAnswer>, Failure> {
    match put(subject, FkQuestion::LocalQuaternions { joints: joints.to_vec(), angles }, limit)? {
        FkAnswer::LocalQuaternions(locals) if locals.len() == joints.len() => Ok(locals),
        _ => Err(unfit()),
    }
}

impl From<PosedFrame> for Posed {
    fn from(PosedFrame { pose, taken, available }: PosedFrame) -> Posed {
        Posed { pose, extra: Extra::Angles { taken, available } }
    }
}
