//! The student's functions, asked in the background for the frames that are about to be shown.

use std::collections::BTreeMap;
use std::sync::Arc;
use std::sync::mpsc::{self, Receiver, Sender};
use std::thread;
use std::time::Duration;

use exam::fk::PosedFrame;
use exam::{Answer, Failure, Question, Subject};

use crate::stage::Stage;
use crate::worker::Trouble;

/// How long the functions may take for one batch of frames. It is far more than they need.
pub const PATIENCE: Duration = Duration::from_secs(5);

/// About how many joints are asked for at once: few enough for an answer without a wait that one would notice.
const JOINTS_PER_BATCH: usize = 8_000;

/// How many batches are kept. Far ones are forgotten and asked for again when they are needed.
const MOST_BATCHES: usize = 256;

/// How many batches are asked for ahead of the frame that is shown.
const AHEAD: usize = 4;

/// What is going on with the student's functions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Status {
    /// They are being compiled.
    Compiling,
    /// They have been asked, and have not answered for the shown frame yet.
    Asking,
    /// They have answered for the shown frame.
    Answered,
    /// They cannot be asked any more.
    Failed(Trouble),
}

/// T
#[allow(missing_docs)]
#[derive(Clone, Debug, PartialEq)]
pub struct Standing {
    pub status: Status,
    pub current: bool,
    pub board: Option<Arc<crate::board::Board>>,
    pub grading: bool,
}

/// The student's functions at work on one motion. Nothing here ever waits for them. A worker that is still busy when the
/// viewer ends notices that, and ends too.
pub struct Student {
    frame_count: usize,
    batch_size: usize,
    batches: BTreeMap<usize, Vec<PosedFrame>>,
    /// The batch that is being asked for.
    asked: Option<usize>,
    ready: bool,
    trouble: Option<Trouble>,
    requests: Sender<usize>,
    events: Receiver<Event>,
}

enum Event {
    Ready,
    Answered(usize, Vec<PosedFrame>),
    Failed(Trouble),
}

impl Student {
    /// Calls `open` on a thread of its own, and asks the subject that it gives.
    pub fn start<S: Subject>(
        stage: Arc<Stage>,
        open: impl FnOnce() -> Result<S, Trouble> + Send + 'static,
    ) -> Student {
        let batch_size = (JOINTS_PER_BATCH / stage.motion().skeleton().len().max(1)).max(1);
        let frame_count = stage.frame_count();
        let (requests, wanted) = mpsc::channel::<usize>();
        let (sender, events) = mpsc::channel();
        let work = move || {
            // Sending fails when nobody is interested any more.
            let result = open().map_err(Event::Failed).and_then(|mut subject| {
                let _ = sender.send(Event::Ready);
                for batch in wanted {
                    let first = batch * batch_size;
                    let frames = first..(first + batch_size).min(frame_count);
                    let answer =
                        ask(&mut subject, &stage, frames).map_err(|failure| Event::Failed(failure.into()))?;
                    let _ = sender.send(Event::Answered(batch, answer));
                }
                Ok(())
            });
            if let Err(failed) = result {
                let _ = sender.send(failed);
            }
        };
        let thread = thread::Builder::new().name("student".into()).spawn(work);
        let trouble = thread.err().map(|error| Trouble {
            headline: "your functions cannot be asked".into(),
            details: vec![error.to_string()],
        });
        Student {
            frame_count,
            batch_size,
            batches: BTreeMap::new(),
            asked: None,
            ready: false,
            trouble,
            requests,
            events,
        }
    }

    /// Takes the answers that have come, asks for what will be needed around `frame`, and gives how things stand
    /// for it.
    pub fn update(&mut self, frame: usize) -> Status {
        while let Ok(event) = self.events.try_recv() {
            match event {
                Event::Ready => self.ready = true,
                Event::Failed(trouble) => self.trouble = Some(trouble),
                Event::Answered(batch, frames) => {
                    self.asked = None;
                    self.batches.insert(batch, frames);
                    self.forget_far_from(frame / self.batch_size);
                }
            }
        }
        if self.ready && self.asked.is_none() && self.trouble.is_none() {
            self.asked = self.next_needed(frame);
            if let Some(batch) = self.asked {
                // When the thread has ended, its last event tells why.
                let _ = self.requests.send(batch);
            }
        }
        self.status(frame)
    }

    /// What the functions made of `frame`, if they have answered.
    pub fn pose(&self, frame: usize) -> Option<&PosedFrame> {
        self.batches.get(&(frame / self.batch_size))?.get(frame % self.batch_size)
    }

    /// T
    pub fn standing(&self, _m: usize, frame: usize) -> Standing {
        Standing { status: self.status(frame), current: true, board: None, grading: false }
    }
    fn status(&self, frame: usize) -> Status {
        match &self.trouble {
            _ if self.pose(frame).is_some() => Status::Answered,
            Some(trouble) => Status::Failed(trouble.clone()),
            None if self.ready => Status::Asking,
            None => Status::Compiling,
        }
    }

    fn next_needed(&self, frame: usize) -> Option<usize> {
        let count = self.frame_count.div_ceil(self.batch_size);
        let coming = (0..AHEAD.min(count)).map(|ahead| (frame / self.batch_size + ahead) % count);
        coming.into_iter().find(|batch| !self.batches.contains_key(batch))
    }

    fn forget_far_from(&mut self, batch: usize) {
        // The first batch follows the last.
        let count = self.frame_count.div_ceil(self.batch_size);
        let distance = |kept: usize| kept.abs_diff(batch).min(count - kept.abs_diff(batch));
        while self.batches.len() > MOST_BATCHES {
            let Some(farthest) = self.batches.keys().copied().max_by_key(|kept| distance(*kept)) else {
                return;
            };
            self.batches.remove(&farthest);
        }
    }
}

/// Asks for the poses of `frames`, here and now, for at most [`PATIENCE`].
///
/// # Errors
///
/// When no answer came, or not for every frame and joint.
pub fn ask(
    subject: &mut impl Subject,
    stage: &Stage,
    frames: std::ops::Range<usize>,
) -> Result<Vec<PosedFrame>, Failure> {
    let skeleton = stage.motion().skeleton().clone();
    let joints = skeleton.len();
    let frames: Vec<_> = frames.map(|index| stage.frame(index)).collect();
    let expected = frames.len();
    let Answer::Fk(answer) =
        subject.ask(&Question::Fk(exam::fk::Question::Poses { skeleton, frames }), PATIENCE)?;
    match answer {
        exam::fk::Answer::Poses(poses)
            if poses.len() == expected && poses.iter().all(|posed| posed.pose.len() == joints) =>
        {
            Ok(poses)
        }
        _ => Err(Failure::Unreadable { why: "the answer does not fit the question".into() }),
    }
}

impl From<Failure> for Trouble {
    fn from(failure: Failure) -> Trouble {
        // A panic's message may be of any length.
        let text: String = failure.to_string().chars().take(600).collect();
        let mut lines = text.lines().take(8).map(str::to_owned);
        Trouble { headline: lines.next().unwrap_or_default(), details: lines.collect() }
    }
}

#[cfg(test)]
mod tests {
    use std::time::Instant;

    use exam::{Functions, InProcess};
    use glam::Vec3;
    use skeleton::{FkFunctions, PositionChannels};

    use super::*;
    use crate::samples;

    fn stage(frames: usize) -> Arc<Stage> {
        Arc::new(Stage::new(samples::chain(frames, 1.0), PositionChannels::Replace))
    }

    /// Lets the student work until `done`, for as long as a slow machine may need.
    fn update_until(student: &mut Student, frame: usize, done: impl Fn(&Student) -> bool) {
        let start = Instant::now();
        while !done(student) {
            assert!(start.elapsed() < Duration::from_secs(60), "still {:?}", student.status(frame));
            student.update(frame);
            thread::yield_now();
        }
    }

    #[test]
    fn the_answers_are_those_of_the_functions_for_every_frame_of_a_long_motion() {
        let stage = stage(20_000);
        let mut student = Student::start(stage.clone(), || Ok(InProcess(Functions::Fk(solutions::FK))));
        for frame in [0, 19_999, 7_000] {
            update_until(&mut student, frame, |student| student.status(frame) == Status::Answered);
            assert_eq!(student.pose(frame).unwrap().pose, stage.reference(frame));
        }
    }

    #[test]
    fn far_batches_are_forgotten_but_never_those_that_come_next() {
        let stage = stage(JOINTS_PER_BATCH * 80);
        let mut student = Student::start(stage.clone(), || Ok(InProcess(Functions::Fk(solutions::FK))));
        let count = student.frame_count.div_ceil(student.batch_size);
        assert!(count > MOST_BATCHES + AHEAD);
        for batch in 0..count {
            student.batches.insert(batch, Vec::new());
        }
        student.forget_far_from(count - 1);
        assert_eq!(student.batches.len(), MOST_BATCHES);
        assert_eq!(student.next_needed((count - 1) * student.batch_size), None);
    }

    #[test]
    fn a_panic_becomes_a_text_and_the_frames_before_it_stay() {
        fn panics(_: &skeleton::Joint, _: Vec3, _: &skeleton::Pose) -> Vec3 {
            panic!("index out of bounds")
        }
        let functions = FkFunctions { global_position: panics, ..solutions::FK };
        let mut student = Student::start(stage(10), move || Ok(InProcess(Functions::Fk(functions))));
        update_until(&mut student, 0, |student| matches!(student.status(0), Status::Failed(_)));
        let Status::Failed(trouble) = student.status(0) else { panic!() };
        assert!(trouble.headline.contains("student.rs") && trouble.headline.contains("index out of bounds"));
    }

    #[test]
    fn functions_that_do_not_compile_become_a_text() {
        let trouble =
            Trouble { headline: "your code does not compile".into(), details: vec!["error".into()] };
        let told = trouble.clone();
        let mut student = Student::start::<InProcess>(stage(10), move || Err(told));
        assert_eq!(student.status(3), Status::Compiling);
        update_until(&mut student, 3, |student| student.status(3) == Status::Failed(trouble.clone()));
    }

    #[test]
    fn an_answer_with_joints_missing_is_no_answer() {
        struct Short;
        impl Subject for Short {
            fn ask(&mut self, _: &Question, _: Duration) -> Result<Answer, Failure> {
                let posed = PosedFrame { pose: skeleton::Pose::identity(1), taken: 0, available: 0 };
                Ok(Answer::Fk(exam::fk::Answer::Poses(vec![posed])))
            }
        }
        assert!(matches!(ask(&mut Short, &stage(1), 0..1), Err(Failure::Unreadable { .. })));
    }
}
