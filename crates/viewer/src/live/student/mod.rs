//! The student's functions, built and asked in the background: for the frames that are shown, for points, and for all
//! other frames.
//!
//! Every saved state of the file is a [`Version`] with a number and a thread of its own. What an abandoned version
//! still finds out is not looked at. Poses of older versions stay at hand until the last one has answered too.

mod ask;
mod held;
mod narrow;
mod pieces;
mod plan;
mod posed;
#[cfg(test)]
mod tests;
mod window;
mod work;

use std::collections::BTreeMap;
use std::sync::mpsc::{self, Receiver};
use std::sync::{Arc, Mutex};
use std::thread;

use exam::Subject;

pub(crate) use ask::details as ask_details;
pub(crate) use ask::time_warp;
pub use ask::{PATIENCE, ask};
pub(crate) use narrow::explain;
pub use posed::{Details, Extra, Posed};

use crate::live::board::Board;
use crate::live::mover::Mover;
use crate::live::rebuilder::Rebuilder;
use crate::live::version::Version;
use crate::live::worker::Trouble;
use crate::motion::stage::Stage;
use held::Held;
use plan::{MotionPlan, Plan};
use work::{Desk, Event, Work};

/// How many batches of poses are kept for all motions together. Far ones are forgotten and asked for again when they
/// are needed.
const MOST_BATCHES: usize = 256;

/// For how many frames details are kept.
const MOST_DETAILS: usize = 64;

/// What is going on with the student's functions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Status {
    /// They are being compiled.
    Compiling,
    /// They have been asked, and have not answered for the shown frame yet.
    Asking,
    /// They have answered for the shown frame.
    Answered,
    /// They give no answer for the shown frame.
    Failed(Arc<Trouble>),
}

/// How things stand with the student's functions for one frame.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Standing {
    /// What is going on with the file as it was saved last.
    pub status: Status,
    /// Whether the pose at hand is that of the last save. Otherwise it is an older one, or there is none.
    pub current: bool,
    /// The points of the last save, when they are known.
    pub board: Option<Arc<Board>>,
    /// Those of an earlier save, for as long as those of the last one are not known.
    pub former: Option<Arc<Board>>,
    /// Whether the questions for points are being asked.
    pub grading: bool,
}

/// The points of a student's functions, as far as they are known. They are the same whatever frame or motion is shown.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Points {
    /// Those of the last save, when they are known.
    pub board: Option<Arc<Board>>,
    /// Those of an earlier save, for as long as those of the last one are not known.
    pub former: Option<Arc<Board>>,
    /// Whether the questions for points are being asked.
    pub grading: bool,
}

impl Standing {
    /// The points alone.
    pub fn points(&self) -> Points {
        Points { board: self.board.clone(), former: self.former.clone(), grading: self.grading }
    }
}

/// What the terminal is told, once for every save.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum News {
    /// The points are known.
    Board(Arc<Board>),
    /// The functions do not compile, or the shown frame fails.
    Trouble(Arc<Trouble>),
}

/// The student's functions at work on some motions. Nothing here ever waits for them.
pub struct Student {
    desk: Desk,
    held: Vec<Held>,
    /// Nothing stands for a frame of which they could not be had.
    details: BTreeMap<(usize, usize), Option<Details>>,
    /// For every motion the frame whose details were asked for last.
    asked: Vec<Option<usize>>,
    /// The version that all this is about.
    number: u64,
    ready: bool,
    failed: Option<Arc<Trouble>>,
    given_up: Option<Arc<Trouble>>,
    grading: bool,
    board: Option<Arc<Board>>,
    former: Option<Arc<Board>>,
    events: Receiver<(u64, Event)>,
    rebuilder: Rebuilder,
}

impl Student {
    /// Builds with `open`, on a thread of its own, and asks the subject that it gives, the functions of the exercise `mover`,
    /// about all `stages`. For every save it is called again, never twice at once. `tell` is called on that thread.
    pub fn start<S: Subject>(
        mover: Mover,
        stages: Vec<Arc<Stage>>,
        open: impl FnMut(&Version) -> Result<S, Trouble> + Send + 'static,
        tell: impl FnMut(News) + Send + 'static,
    ) -> Student {
        let plan = Plan::new(mover, stages, most_batches);
        let held = plan.motions.iter().map(|motion| Held::new(motion.window)).collect();
        let asked = vec![None; plan.motions.len()];
        let desk = Desk::new(plan);
        let (sender, events) = mpsc::channel();
        let (open, tell) = (Arc::new(Mutex::new(open)), Arc::new(Mutex::new(tell)));
        let start = {
            let desk = desk.clone();
            move |number, version, before| {
                let (desk, events, tell) = (desk.clone(), sender.clone(), tell.clone());
                let work = Work { mover, number, version, before, desk, events, tell, told: false };
                let open = Arc::clone(&open);
                thread::Builder::new().name("student".into()).spawn(move || work.run(&open)).map(|_| ())
            }
        };
        let begin = {
            let desk = desk.clone();
            move || desk.begin()
        };
        let rebuilder = Rebuilder::new(Box::new(begin), Box::new(start));
        let mut student = Student {
            desk,
            held,
            details: BTreeMap::new(),
            asked,
            number: 0,
            ready: false,
            failed: None,
            given_up: None,
            grading: false,
            board: None,
            former: None,
            events,
            rebuilder,
        };
        student.rebuild();
        student
    }

    /// The file was saved: the version before is abandoned, whatever it is doing, and the new one built and asked.
    pub fn rebuild(&mut self) {
        self.rebuilder.rebuild();
        self.follow();
    }

    /// What another thread can call when the file was saved.
    pub fn rebuilder(&self) -> Rebuilder {
        self.rebuilder.clone()
    }

    /// Begins anew if there is a new version. Gives whether there is.
    fn follow(&mut self) -> bool {
        let number = self.desk.plan().version;
        if std::mem::replace(&mut self.number, number) == number {
            return false;
        }
        self.held.iter_mut().for_each(Held::begin);
        self.details.clear();
        (self.ready, self.failed, self.given_up, self.grading) = (false, None, None, false);
        self.former = self.board.take().or(self.former.take());
        self.asked.fill(None);
        if let Some(error) = self.rebuilder.take_trouble() {
            let headline = "your functions cannot be asked".into();
            self.failed = Some(Arc::new(Trouble { headline, details: vec![error.to_string()] }));
        }
        true
    }

    /// Motion `motion` (from 0) was read again. Its frames are asked anew; nothing is built.
    pub fn replace_stage(&mut self, motion: usize, stage: Arc<Stage>) {
        let mut plan = self.desk.plan();
        let (mover, count) = (plan.mover, plan.motions.len());
        let Some(old) = plan.motions.get_mut(motion) else { return };
        let shown = old.shown.min(stage.frame_count() - 1);
        *old = MotionPlan::new(mover, stage, old.reading + 1, most_batches(count));
        old.shown = shown;
        self.held[motion] = Held::new(old.window);
        drop(plan);
        self.details.retain(|(of, _), _| *of != motion);
        self.asked[motion] = None;
        self.desk.wake();
    }

    /// Takes what has come, and asks for what will be needed around the frame that is shown of each motion. Gives whether
    /// anything has come. Never waits; to be called for every picture.
    pub fn update(&mut self, shown: &[usize]) -> bool {
        let mut news = self.follow();
        while let Ok((number, event)) = self.events.try_recv() {
            if number > self.number {
                // The save was noticed just now, on another thread.
                self.follow();
            }
            if number == self.number {
                self.take(event);
                news = true;
            }
        }
        let mut plan = self.desk.plan();
        let mut moved = false;
        for ((motion, held), frame) in plan.motions.iter_mut().zip(&mut self.held).zip(shown) {
            let frame = (*frame).min(motion.stage.frame_count() - 1);
            moved |= std::mem::replace(&mut motion.shown, frame) != frame;
            for batch in held.forget_far_from(frame) {
                motion.forget(batch);
                moved = true;
            }
        }
        drop(plan);
        if moved {
            self.desk.wake();
        }
        news
    }

    fn take(&mut self, event: Event) {
        // What was asked of a motion before it was read again is of no use.
        let is_late = |at: &plan::Motion, desk: &Desk| {
            desk.plan().motions.get(at.index).is_none_or(|motion| motion.reading != at.reading)
        };
        match event {
            Event::Ready => self.ready = true,
            Event::Failed(trouble) => {
                self.failed = Some(trouble);
                self.grading = false;
            }
            Event::GivenUp(trouble) => self.given_up = Some(trouble),
            Event::Frames(at, ..) | Event::Trouble(at, ..) | Event::Details(at, ..)
                if is_late(&at, &self.desk) => {}
            Event::Frames(at, first, poses) => self.held[at.index].insert(self.number, first, poses),
            Event::Trouble(at, frame, trouble) => self.held[at.index].insert_trouble(frame, trouble),
            Event::Details(at, frame, details) => {
                if self.details.len() >= MOST_DETAILS {
                    // Those that were asked for last are not asked for again.
                    self.details.retain(|(motion, frame), _| self.asked[*motion] == Some(*frame));
                }
                self.details.insert((at.index, frame), details);
            }
            Event::Grading => self.grading = true,
            Event::Graded(board) => {
                self.grading = false;
                self.board = Some(board);
            }
        }
    }

    /// How things stand for frame `frame` (from 0) of motion `motion` (from 0).
    pub fn standing(&self, motion: usize, frame: usize) -> Standing {
        let held = self.held.get(motion);
        let version = held.and_then(|held| held.pose(frame)).map(|(version, _)| version);
        let current = version == Some(self.number);
        let trouble = held.and_then(|held| held.trouble(frame));
        let status = match (&self.failed, trouble.or(self.given_up.as_ref())) {
            _ if current => Status::Answered,
            (Some(trouble), _) | (None, Some(trouble)) => Status::Failed(Arc::clone(trouble)),
            (None, None) if self.ready => Status::Asking,
            (None, None) => Status::Compiling,
        };
        let Points { board, former, grading } = self.points();
        Standing { status, current, board, former, grading }
    }

    /// The points, as far as they are known.
    pub fn points(&self) -> Points {
        let former = self.former.as_ref().filter(|_| self.board.is_none()).cloned();
        Points { board: self.board.clone(), former, grading: self.grading }
    }

    /// The newest pose at hand: what the functions made of the frame as they were saved last, or else before that.
    pub fn pose(&self, motion: usize, frame: usize) -> Option<&Posed> {
        self.held.get(motion)?.pose(frame).map(|(_, posed)| posed)
    }

    /// The version, counted from 1, whose functions made that pose.
    pub fn version(&self, motion: usize, frame: usize) -> Option<u64> {
        self.held.get(motion)?.pose(frame).map(|(version, _)| version)
    }

    /// What single parts give for the frame. Nothing until they have been asked, which begins now, or when they give no
    /// answer, or have nothing to do with the motion.
    pub fn details(&mut self, motion: usize, frame: usize) -> Option<&Details> {
        let held = self.held.get(motion)?;
        let place = (motion, frame);
        let unknown = held.trouble(frame).is_none() && !self.details.contains_key(&place);
        if unknown && self.asked[motion].replace(frame) != Some(frame) {
            self.desk.plan().motions[motion].want_details(frame);
            self.desk.wake();
        }
        self.known_details(motion, frame)
    }

    /// The same, as far as it is known, without asking.
    pub fn known_details(&self, motion: usize, frame: usize) -> Option<&Details> {
        self.details.get(&(motion, frame))?.as_ref()
    }
}

impl Drop for Student {
    /// Ends the worker. Does not wait for a build.
    fn drop(&mut self) {
        self.rebuilder.end();
    }
}

/// How many batches are kept for each of some motions.
fn most_batches(motions: usize) -> usize {
    MOST_BATCHES / motions.max(1)
}
