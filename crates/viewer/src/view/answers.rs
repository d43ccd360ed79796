//! What is known of a student's functions on one motion.

use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::ops::Range;
use std::sync::Arc;

use exam::fk::{LocalAnswer, PosedFrame};
use exam::{Failure, Subject};
use skeleton::{FkFunctions, Frame, FrameCursor, Pose, pose_frame};

use crate::live::mover::Mover;
use crate::live::student::{self, Details, PATIENCE, Posed, Standing, Status};
use crate::live::worker::Trouble;
use crate::motion::stage::Stage;

/// The answers of a student's functions.
pub trait Answers {
    /// The exercise that they are of.
    fn mover(&self) -> Mover;

    /// How things stand with the functions, when this frame is shown.
    fn standing(&self, frame: usize) -> Standing;

    /// What they made of a frame (from 0), if they have answered.
    fn posed(&self, frame: usize) -> Option<&Posed>;

    /// Which version of the functions that was: one saved later has a higher number.
    fn version(&self, frame: usize) -> Option<u64>;

    /// What single parts made of a frame (from 0), if they were asked by themselves and have answered.
    fn details(&self, frame: usize) -> Option<&Details>;
}

/// How many joints are asked about at once.
const JOINTS_AT_ONCE: usize = 8_000;

/// With so many endless loops or crashes no more frames are asked: each takes seconds.
const MOST_COSTLY: usize = 3;

/// Answers that have been given: for pictures, where all questions are asked beforehand.
#[derive(Clone, Debug, PartialEq)]
pub struct Recorded {
    /// The exercise that they are of.
    pub mover: Mover,
    /// How things stand, whatever the frame.
    pub standing: Standing,
    /// What the functions made of the frames that they were asked about.
    pub poses: BTreeMap<usize, Posed>,
    /// What is wrong with frames that were not answered.
    pub troubles: BTreeMap<usize, Arc<Trouble>>,
    /// What single parts made of the frames that they were asked about.
    pub details: BTreeMap<usize, Details>,
}

impl Recorded {
    /// No answers yet.
    pub fn new(mover: Mover, status: Status) -> Recorded {
        Recorded {
            mover,
            standing: Standing { status, current: true, board: None, former: None, grading: false },
            poses: BTreeMap::new(),
            troubles: BTreeMap::new(),
            details: BTreeMap::new(),
        }
    }

    /// Asks a subject, the functions of the exercise `mover`, about these frames of the motion on `stage`, in any order, here
    /// and now. A frame that fails is told with what is wrong with it, and the others are asked all the same, until too many
    /// have failed.
    pub fn ask(
        mover: Mover,
        subject: &mut impl Subject,
        stage: &Stage,
        frames: impl IntoIterator<Item = usize>,
    ) -> Recorded {
        let mut recorded = Recorded::new(mover, Status::Answered);
        let most = mover.frames_at_once(stage, JOINTS_AT_ONCE);
        let mut ranges = VecDeque::from(ranges(frames.into_iter().collect(), most));
        let mut costly = 0;
        while let Some(frames) = ranges.pop_front() {
            let failure = match student::ask(mover, subject, stage, frames.clone()) {
                Ok(poses) => {
                    recorded.poses.extend(frames.zip(poses));
                    continue;
                }
                Err(failure) => failure,
            };
            costly += usize::from(!matches!(failure, Failure::Panicked { .. }));
            let all_fail = mover.is_asked_whole(stage);
            if frames.len() > 1 && costly < MOST_COSTLY && !all_fail {
                frames.rev().for_each(|frame| ranges.push_front(frame..frame + 1));
                continue;
            }
            let trouble = Arc::new(student::explain(mover, subject, stage, frames.start, &failure));
            recorded.troubles.insert(frames.start, trouble.clone());
            if costly >= MOST_COSTLY || all_fail {
                // What is left would most likely end like this too.
                recorded.standing.status = Status::Failed(trouble);
                break;
            }
        }
        recorded
    }

    /// Asks single parts by themselves about a frame. Where they fail nothing is known.
    pub fn ask_details(&mut self, subject: &mut impl Subject, stage: &Stage, frame: usize) {
        if let Ok(details) = student::ask_details(self.mover, subject, stage, frame, PATIENCE) {
            self.details.insert(frame, details);
        }
    }

    /// The answers of the functions of forward kinematics to these frames of the motion on `stage`, given here and now. A
    /// panic of theirs goes through.
    pub fn of(functions: &FkFunctions, stage: &Stage, frames: impl IntoIterator<Item = usize>) -> Recorded {
        let mut recorded = Recorded::new(Mover::Fk, Status::Answered);
        let skeleton = stage.motion().skeleton();
        let mut frame = Frame::default();
        for index in frames {
            stage.read_frame(index, &mut frame);
            let mut pose = Pose::default();
            let leftover = pose_frame(skeleton, &frame, functions, &mut pose);
            let posed = PosedFrame { pose, taken: leftover.taken, available: leftover.available };
            recorded.poses.insert(index, posed.into());

            let mut cursor = FrameCursor::new(&frame.angles);
            let local = |joint| {
                let before = cursor.taken();
                let rotation = (functions.local_quaternion)(joint, &mut cursor);
                LocalAnswer { rotation, taken: cursor.taken().saturating_sub(before) }
            };
            let locals = skeleton.joints().iter().map(local).collect();
            recorded.details.insert(index, Details::Locals(locals));
        }
        recorded
    }
}

/// Frames in a row, at most so many in each range.
fn ranges(frames: BTreeSet<usize>, most: usize) -> Vec<Range<usize>> {
    let mut ranges: Vec<Range<usize>> = Vec::new();
    for frame in frames {
        match ranges.last_mut() {
            Some(range) if range.end == frame && range.len() < most => range.end += 1,
            _ => ranges.push(frame..frame + 1),
        }
    }
    ranges
}

impl Answers for Recorded {
    fn mover(&self) -> Mover {
        self.mover
    }

    fn standing(&self, frame: usize) -> Standing {
        let status = match self.troubles.get(&frame) {
            Some(trouble) => Status::Failed(trouble.clone()),
            None if self.poses.contains_key(&frame) => Status::Answered,
            None => self.standing.status.clone(),
        };
        Standing { status, ..self.standing.clone() }
    }

    fn posed(&self, frame: usize) -> Option<&Posed> {
        self.poses.get(&frame)
    }

    fn version(&self, frame: usize) -> Option<u64> {
        self.posed(frame).map(|_| 1)
    }

    fn details(&self, frame: usize) -> Option<&Details> {
        self.details.get(&frame)
    }
}

#[cfg(test)]
mod tests {
    use exam::{Functions, InProcess};
    use skeleton::PositionChannels;

    use super::*;
    use crate::samples;

    #[test]
    fn frames_are_asked_in_rows() {
        let set = |frames: &[usize]| frames.iter().copied().collect::<BTreeSet<_>>();
        assert_eq!(ranges(set(&[5, 1, 2, 3, 9]), 2), [1..3, 3..4, 5..6, 9..10]);
        assert!(ranges(set(&[]), 2).is_empty());
    }

    #[test]
    fn what_a_subject_says_is_what_its_functions_give() {
        let stage = Stage::new(samples::chain(9, 1.0), PositionChannels::Replace);
        let frames = [7, 2, 3, 2];
        let mut subject = InProcess(Functions::Fk(solutions::FK));
        let asked = Recorded::ask(Mover::Fk, &mut subject, &stage, frames);
        assert_eq!(asked.poses, Recorded::of(&solutions::FK, &stage, frames).poses);
        assert_eq!(asked.posed(3).unwrap().pose, stage.reference(3));
        assert_eq!(asked.posed(4), None);
    }

    #[test]
    fn a_frame_that_fails_costs_no_other() {
        fn panics(joint: &skeleton::Joint, frame: &mut FrameCursor) -> glam::Quat {
            let angles = frame.take3();
            // The angles of frame 5.
            assert!(!joint.is_root() || angles[0] != 10.0, "too much");
            glam::Quat::IDENTITY
        }
        let stage = Stage::new(samples::chain(9, 1.0), PositionChannels::Replace);
        let functions = FkFunctions { local_quaternion: panics, ..solutions::FK };
        let asked = Recorded::ask(Mover::Fk, &mut InProcess(Functions::Fk(functions)), &stage, 2..8);
        assert_eq!(asked.poses.keys().copied().collect::<Vec<_>>(), [2, 3, 4, 6, 7]);
        assert_eq!(asked.standing(4).status, Status::Answered);
        let Status::Failed(trouble) = asked.standing(5).status else { panic!() };
        assert!(trouble.headline.contains("too much"));
        assert!(trouble.details[0].contains("at joint Hips, in frame 5"), "{trouble:?}");
    }

    #[test]
    fn loops_and_crashes_are_not_met_again_and_again() {
        struct Crashes(usize);
        impl Subject for Crashes {
            fn ask(&mut self, _: &exam::Question, _: std::time::Duration) -> Result<exam::Answer, Failure> {
                self.0 += 1;
                Err(Failure::Crashed { how: "bang".into() })
            }
        }
        let stage = Stage::new(samples::chain(900, 1.0), PositionChannels::Replace);
        let mut subject = Crashes(0);
        let asked = Recorded::ask(Mover::Fk, &mut subject, &stage, 0..900);
        assert!(subject.0 < 30, "{}", subject.0);
        assert!(matches!(asked.standing(899).status, Status::Failed(_)));
    }
}
