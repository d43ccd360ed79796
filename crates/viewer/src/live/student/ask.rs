//! Questions about frames.

use std::ops::Range;
use std::time::Duration;

use exam::fk::{Answer as FkAnswer, LocalAnswer, PosedFrame, Question as FkQuestion};
use exam::{Answer, Failure, Question, Subject};
use skeleton::{Frame, Joint, Skeleton};

use crate::motion::stage::Stage;

/// How long the functions may take for one batch of frames. It is far more than they need.
pub const PATIENCE: Duration = Duration::from_secs(5);

/// How long they may take for a single frame.
pub(super) const FRAME_LIMIT: Duration = Duration::from_secs(2);

/// How long they may take for some joints of a frame, while the one is looked for at which they do not come back.
pub(super) const JOINTS_LIMIT: Duration = Duration::from_millis(500);

/// Asks for the poses of `frames`, here and now, for at most [`PATIENCE`].
///
/// # Errors
///
/// When no answer came, or not for every frame and joint.
pub fn ask(
    subject: &mut impl Subject,
    stage: &Stage,
    frames: Range<usize>,
) -> Result<Vec<PosedFrame>, Failure> {
    poses(subject, stage, frames.map(|index| stage.frame(index)).collect(), PATIENCE)
}

/// Asks for the poses of `frames`. `limit` does not count the time in which a worker starts.
pub(super) fn poses(
    subject: &mut impl Subject,
    stage: &Stage,
    frames: Vec<Frame>,
    limit: Duration,
) -> Result<Vec<PosedFrame>, Failure> {
    warm_up(subject)?;
    let skeleton = stage.motion().skeleton().clone();
    let (joints, expected) = (skeleton.len(), frames.len());
    match put(subject, FkQuestion::Poses { skeleton, frames }, limit)? {
        FkAnswer::Poses(poses)
            if poses.len() == expected && poses.iter().all(|posed| posed.pose.len() == joints) =>
        {
            Ok(poses)
        }
        _ => Err(unfit()),
    }
}

/// Asks part 1 for `joints`, one after the other, over `angles` (degrees).
pub(crate) fn locals(
    subject: &mut impl Subject,
    joints: &[Joint],
    angles: Vec<f32>,
    limit: Duration,
) -> Result<Vec<LocalAnswer>, Failure> {
    warm_up(subject)?;
    match put(subject, FkQuestion::LocalQuaternions { joints: joints.to_vec(), angles }, limit)? {
        FkAnswer::LocalQuaternions(locals) if locals.len() == joints.len() => Ok(locals),
        _ => Err(unfit()),
    }
}

/// Asks what calls none of the student's functions: afterwards there is a worker.
pub(super) fn warm_up(subject: &mut impl Subject) -> Result<(), Failure> {
    put(subject, FkQuestion::Poses { skeleton: Skeleton::new(), frames: Vec::new() }, PATIENCE).map(|_| ())
}

pub(super) fn put(
    subject: &mut impl Subject,
    question: FkQuestion,
    limit: Duration,
) -> Result<FkAnswer, Failure> {
    match subject.ask(&Question::Fk(question), limit)? {
        Answer::Fk(answer) => Ok(answer),
        _ => Err(unfit()),
    }
}

pub(super) fn unfit() -> Failure {
    Failure::Unreadable { why: "the answer does not fit the question".into() }
}
