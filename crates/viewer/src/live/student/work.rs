//! The thread that builds one version and asks it.

use std::io;
use std::ops::Range;
use std::sync::mpsc::Sender;
use std::sync::{Arc, Condvar, Mutex, MutexGuard};
use std::time::Duration;

use exam::{Answer, Failure, Question, Subject};

use super::News;
use super::ask::{self, FRAME_LIMIT, PATIENCE};
use super::narrow::{self, Place};
use super::plan::{Motion, Plan, Task};
use super::posed::{Details, Posed};
use crate::live::board::Board;
use crate::live::lock;
use crate::live::mover::Mover;
use crate::live::version::Version;
use crate::live::worker::Trouble;

/// The plan, and word that there is something new in it.
#[derive(Clone)]
pub(super) struct Desk(Arc<(Mutex<Plan>, Condvar)>);

/// What a thread found out.
pub(super) enum Event {
    Ready,
    /// The functions cannot be asked at all.
    Failed(Arc<Trouble>),
    /// No more frames are asked: this is why.
    GivenUp(Arc<Trouble>),
    Frames(Motion, usize, Vec<Posed>),
    Trouble(Motion, usize, Arc<Trouble>),
    Details(Motion, usize, Option<Details>),
    Grading,
    Graded(Arc<Board>),
}

/// All that the thread of a version needs.
pub(super) struct Work {
    pub(super) mover: Mover,
    pub(super) number: u64,
    pub(super) version: Version,
    /// The version before, whose last acts are still to be done.
    pub(super) before: Version,
    pub(super) desk: Desk,
    pub(super) events: Sender<(u64, Event)>,
    pub(super) tell: Arc<Mutex<dyn FnMut(News) + Send>>,
    pub(super) told: bool,
}

impl Desk {
    pub(super) fn new(plan: Plan) -> Desk {
        Desk(Arc::new((Mutex::new(plan), Condvar::new())))
    }

    pub(super) fn plan(&self) -> MutexGuard<'_, Plan> {
        lock(&self.0.0)
    }

    /// A new version begins. Gives its number.
    pub(super) fn begin(&self) -> u64 {
        let number = {
            let mut plan = self.plan();
            plan.begin();
            plan.version
        };
        self.wake();
        number
    }

    /// There is something new in the plan.
    pub(super) fn wake(&self) {
        self.0.1.notify_all();
    }

    /// Waits for something to ask version `number`. Nothing, when that is no longer the last one.
    fn next(&self, number: u64, version: &Version) -> Option<Task> {
        let mut plan = self.plan();
        while plan.version == number && !version.is_abandoned() {
            if let Some(task) = plan.next(version.is_talkative()) {
                match &task {
                    Task::Details { at, .. } => plan.motions[at.index].details = None,
                    Task::Grade => plan.graded = true,
                    Task::Frames { .. } | Task::Place { .. } => {}
                }
                return Some(task);
            }
            plan = self.0.1.wait(plan).unwrap_or_else(std::sync::PoisonError::into_inner);
        }
        None
    }
}

impl Work {
    /// Builds one version after the other, each with `open`, and asks it until it is abandoned.
    pub(super) fn run<S: Subject>(mut self, open: &Mutex<impl FnMut(&Version) -> Result<S, Trouble>>) {
        self.before.end();
        // One is built after the other: what was saved in the meantime needs no build of its own.
        let opened = {
            let mut open = lock(open);
            if self.version.is_abandoned() {
                return;
            }
            open(&self.version)
        };
        match opened {
            Ok(mut subject) => {
                self.send(Event::Ready);
                while let Some(task) = self.desk.next(self.number, &self.version) {
                    if self.perform(task, &mut subject).is_err() {
                        return;
                    }
                }
            }
            Err(trouble) => self.fail(trouble),
        }
    }

    /// # Errors
    ///
    /// When the functions cannot be asked any more.
    fn perform(&mut self, task: Task, subject: &mut impl Subject) -> Result<(), Gone> {
        self.version.hush(!matches!(task, Task::Frames { on_show: true, .. }));
        match task {
            Task::Frames { at, frames, on_show } => self.frames(at, frames, on_show, subject)?,
            Task::Place { at, frame, failure } => self.place(at, frame, failure, subject),
            Task::Details { at, frame } => {
                let details = ask::details(self.mover, subject, &at.stage, frame, FRAME_LIMIT);
                if let Err(failure) = &details {
                    self.check(failure)?;
                    self.desk.plan().count(failure);
                    self.tell_of_giving_up(failure.clone().into());
                }
                self.send(Event::Details(at, frame, details.ok()));
            }
            Task::Grade => {
                self.send(Event::Grading);
                let package = self.mover.package();
                let board = Arc::new(Board::of(&mut Attentive { subject, work: self }, package));
                self.send(Event::Graded(Arc::clone(&board)));
                self.tell(News::Board(board));
            }
        }
        Ok(())
    }

    fn frames(
        &mut self,
        at: Motion,
        frames: Range<usize>,
        on_show: bool,
        subject: &mut impl Subject,
    ) -> Result<(), Gone> {
        if on_show {
            self.desk.plan().hear(&at, frames.start);
        }
        let (asked, limit) = self.with_all(&at, frames.clone());
        match ask::poses(self.mover, subject, &at.stage, asked.clone(), limit) {
            Ok(poses) => {
                self.answered(at, asked, poses);
                if on_show {
                    // What was written to the standard error is under way for a little longer than the answer.
                    let _ = ask::warm_up(subject);
                }
            }
            Err(failure) => {
                self.check(&failure)?;
                self.desk.plan().fail(&at, frames.clone(), &failure);
                if frames.len() == 1 {
                    self.show(at, frames.start, &failure, Place::default());
                }
            }
        }
        Ok(())
    }

    fn place(&mut self, at: Motion, frame: usize, failure: Arc<Failure>, subject: &mut impl Subject) {
        let place = narrow::find(self.mover, subject, &at.stage, frame, &failure);
        if place == Place::default() {
            let (asked, limit) = self.with_all(&at, frame..frame + 1);
            if let Ok(poses) = ask::poses(self.mover, subject, &at.stage, asked.clone(), limit) {
                // It comes back after all: the machine was busy with something else, or the functions are moody.
                return self.answered(at, asked, poses);
            }
        }
        let trouble = self.show(at.clone(), frame, &failure, place);
        self.desk.plan().narrowed(&at, frame, failure);
        if !std::mem::replace(&mut self.told, true) {
            self.tell(News::Trouble(trouble));
        }
    }

    /// What to ask in order to know of `frames`, and for how long. Where all frames are made at once, whichever are wanted, it
    /// is all of them: so they are made once, and have the time that all of them take.
    fn with_all(&self, at: &Motion, frames: Range<usize>) -> (Range<usize>, Duration) {
        if self.mover.is_asked_whole(&at.stage) {
            return (0..at.stage.frame_count(), PATIENCE);
        }
        let patient = frames.len() > 1 && !self.desk.plan().is_wary();
        (frames, if patient { PATIENCE } else { FRAME_LIMIT })
    }

    fn answered(&self, at: Motion, frames: Range<usize>, poses: Vec<Posed>) {
        self.desk.plan().settle(&at, frames.clone());
        self.send(Event::Frames(at, frames.start, poses));
    }

    /// Whether the functions can still be asked after `failure`.
    fn check(&mut self, failure: &Failure) -> Result<(), Gone> {
        if self.version.is_abandoned() {
            return Err(Gone);
        }
        if matches!(failure, Failure::NoAnswer { .. }) {
            self.fail(failure.clone().into());
            return Err(Gone);
        }
        Ok(())
    }

    fn fail(&mut self, trouble: Trouble) {
        let trouble = Arc::new(trouble);
        self.send(Event::Failed(Arc::clone(&trouble)));
        self.tell(News::Trouble(trouble));
    }

    /// Sends what is known about a frame that fails.
    fn show(&mut self, at: Motion, frame: usize, failure: &Failure, place: Place) -> Arc<Trouble> {
        let trouble = Arc::new(narrow::trouble(self.mover, &at.stage, frame, failure, place));
        self.send(Event::Trouble(at, frame, Arc::clone(&trouble)));
        self.tell_of_giving_up(Trouble::clone(&trouble));
        trouble
    }

    /// Says why no more frames are asked, if none are. `last` is what has happened last.
    fn tell_of_giving_up(&self, last: Trouble) {
        if self.desk.plan().has_given_up() {
            let details = vec!["other frames end like this too, so this one was not asked".into()];
            self.send(Event::GivenUp(Arc::new(Trouble { details, ..last })));
        }
    }

    fn send(&self, event: Event) {
        // This fails when the viewer has gone.
        let _ = self.events.send((self.number, event));
    }

    fn tell(&self, news: News) {
        let mut tell = lock(&self.tell);
        if !self.version.is_abandoned() {
            tell(news);
        }
    }
}

/// The functions cannot be asked any more.
struct Gone;

/// Answers the questions for points, but what is on show comes first.
struct Attentive<'a, S> {
    subject: &'a mut S,
    work: &'a mut Work,
}

impl<S: Subject> Attentive<'_, S> {
    fn look_up(&mut self) -> Result<(), Failure> {
        loop {
            let version = &self.work.version;
            let task = self.work.desk.plan().urgent(version.is_talkative());
            let task = task.filter(|_| !version.is_abandoned());
            let Some(task) = task else { break };
            if self.work.perform(task, self.subject).is_err() {
                break;
            }
        }
        self.work.version.hush(true);
        match self.work.version.is_abandoned() {
            true => Err(Failure::NoAnswer { why: io::ErrorKind::Interrupted.to_string() }),
            false => Ok(()),
        }
    }
}

impl<S: Subject> Subject for Attentive<'_, S> {
    fn ask(&mut self, question: &Question, limit: Duration) -> Result<Answer, Failure> {
        self.look_up()?;
        self.subject.ask(question, limit)
    }

    fn ask_all(&mut self, questions: &[&Question], limit: Duration) -> (Vec<Answer>, Option<Failure>) {
        match self.look_up() {
            Ok(()) => self.subject.ask_all(questions, limit),
            Err(failure) => (Vec::new(), Some(failure)),
        }
    }

    fn restart(&mut self) {
        self.subject.restart();
    }
}
