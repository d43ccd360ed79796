//! Questions about frames. Here it is decided, for every exercise whose functions pose figures, how they are asked.

pub(super) mod acclaim;
pub(super) mod fk;
pub(crate) mod time_warp;

use std::ops::Range;
use std::time::Duration;

use exam::fk::Question as FkQuestion;
use exam::{Answer, Failure, Question, Subject};
use skeleton::Skeleton;

use super::posed::{Details, Posed};
use crate::live::mover::Mover;
use crate::motion::stage::Stage;

/// How long the functions may take for one batch of frames. It is far more than they need.
pub const PATIENCE: Duration = Duration::from_secs(5);

/// How long they may take for a single frame, where it is made by itself.
pub(super) const FRAME_LIMIT: Duration = Duration::from_secs(2);

/// How long they may take for a piece of a frame, while the place is looked for at which they do not come back.
pub(super) const PIECE_LIMIT: Duration = Duration::from_millis(500);

/// Asks for the poses of `frames`, here and now. The functions may take [`PATIENCE`] for these, and where time warping makes a
/// whole motion a moment more, to say where its frames are. A worker that has to be started may take as long once more.
///
/// # Errors
///
/// When no answer came, or not for every frame and joint.
pub fn ask(
    mover: Mover,
    subject: &mut impl Subject,
    stage: &Stage,
    frames: Range<usize>,
) -> Result<Vec<Posed>, Failure> {
    poses(mover, subject, stage, frames, PATIENCE)
}

/// Asks for the poses of `frames`. `limit` does not count the time in which a worker starts.
pub(super) fn poses(
    mover: Mover,
    subject: &mut impl Subject,
    stage: &Stage,
    frames: Range<usize>,
    limit: Duration,
) -> Result<Vec<Posed>, Failure> {
    warm_up(subject)?;
    match mover {
        Mover::Fk => fk::poses(subject, stage, frames.map(|index| stage.frame(index)).collect(), limit),
        Mover::Acclaim => acclaim::poses(subject, stage, frames, limit),
        Mover::TimeWarp => time_warp::poses(subject, stage, frames, limit),
    }
}

/// Asks single parts about frame `frame` of the motion.
pub(crate) fn details(
    mover: Mover,
    subject: &mut impl Subject,
    stage: &Stage,
    frame: usize,
    limit: Duration,
) -> Result<Details, Failure> {
    warm_up(subject)?;
    match mover {
        Mover::Fk => {
            let joints = stage.motion().skeleton().joints();
            fk::locals(subject, joints, stage.frame(frame).angles, limit).map(Details::Locals)
        }
        Mover::Acclaim => acclaim::visits(subject, stage, limit).map(Details::Visits),
        Mover::TimeWarp => time_warp::details(subject, stage, frame, limit),
    }
}

/// Asks what calls none of the student's functions, whichever exercise they are of: afterwards there is a worker.
pub(super) fn warm_up(subject: &mut impl Subject) -> Result<(), Failure> {
    let nothing = FkQuestion::Poses { skeleton: Skeleton::new(), frames: Vec::new() };
    subject.ask(&Question::Fk(nothing), PATIENCE).map(|_| ())
}

/// Puts a question of one exercise. Only an answer of the same exercise is one.
pub(super) fn put<A: TryFrom<Answer>>(
    subject: &mut impl Subject,
    question: impl Into<Question>,
    limit: Duration,
) -> Result<A, Failure> {
    subject.ask(&question.into(), limit)?.try_into().map_err(|_| unfit())
}

pub(super) fn unfit() -> Failure {
    Failure::Unreadable { why: "the answer does not fit the question".into() }
}
