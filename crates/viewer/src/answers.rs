//! What is known of a student's functions on one motion.

use std::collections::BTreeMap;

use exam::fk::{LocalAnswer, PosedFrame};
use skeleton::{FkFunctions, Frame, FrameCursor, Pose, pose_frame};

use crate::stage::Stage;
use crate::student::{Standing, Status};

/// The answers of a student's functions.
pub trait Answers {
    /// How things stand with the functions, when this frame is shown.
    fn standing(&self, frame: usize) -> Standing;

    /// What they made of a frame (from 0), if they have answered.
    fn posed(&self, frame: usize) -> Option<&PosedFrame>;

    /// What part 1 made of every joint in a frame (from 0), if it was asked by itself and has answered.
    fn locals(&self, frame: usize) -> Option<&[LocalAnswer]>;
}

/// Answers that have been given: for pictures, where all questions are asked beforehand.
#[derive(Clone, Debug, PartialEq)]
pub struct Recorded {
    /// How things stand, whatever the frame.
    pub standing: Standing,
    /// What the functions made of the frames that they were asked about.
    pub poses: BTreeMap<usize, PosedFrame>,
    /// What part 1 made of every joint in the frames that it was asked about.
    pub locals: BTreeMap<usize, Vec<LocalAnswer>>,
}

impl Recorded {
    /// No answers yet.
    pub fn new(status: Status) -> Recorded {
        let standing = Standing { status, current: true, board: None, grading: false };
        Recorded { standing, poses: BTreeMap::new(), locals: BTreeMap::new() }
    }

    /// The answers of `functions` to these frames of the motion on `stage`, given here and now. A panic of theirs goes
    /// through.
    pub fn of(functions: &FkFunctions, stage: &Stage, frames: impl IntoIterator<Item = usize>) -> Recorded {
        let mut recorded = Recorded::new(Status::Answered);
        let skeleton = stage.motion().skeleton();
        let mut frame = Frame::default();
        for index in frames {
            stage.read_frame(index, &mut frame);
            let mut pose = Pose::default();
            let leftover = pose_frame(skeleton, &frame, functions, &mut pose);
            let posed = PosedFrame { pose, taken: leftover.taken, available: leftover.available };
            recorded.poses.insert(index, posed);

            let mut cursor = FrameCursor::new(&frame.angles);
            let local = |joint| {
                let before = cursor.taken();
                let rotation = (functions.local_quaternion)(joint, &mut cursor);
                LocalAnswer { rotation, taken: cursor.taken().saturating_sub(before) }
            };
            recorded.locals.insert(index, skeleton.joints().iter().map(local).collect());
        }
        recorded
    }
}

impl Answers for Recorded {
    fn standing(&self, _: usize) -> Standing {
        self.standing.clone()
    }

    fn posed(&self, frame: usize) -> Option<&PosedFrame> {
        self.poses.get(&frame)
    }

    fn locals(&self, frame: usize) -> Option<&[LocalAnswer]> {
        self.locals.get(&frame).map(Vec::as_slice)
    }
}
