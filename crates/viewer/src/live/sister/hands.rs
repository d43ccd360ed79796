//! The versions of an exercise, built one after the other: each gives hands, and then points.

use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{self, Receiver, Sender};
use std::sync::{Arc, Mutex};
use std::thread;

use exam::Subject;

use super::hand::{Report, StudentHand};
use crate::edit::Hand;
use crate::live::board::Board;
use crate::live::lock;
use crate::live::package::Package;
use crate::live::rebuilder::Rebuilder;
use crate::live::student::{News, Standing, Status};
use crate::live::version::Version;
use crate::live::worker::Trouble;

/// The functions of one version, as often as they are needed: each can be asked while another one is busy.
pub struct Opened<S> {
    /// One for each motion. What these print is for the user.
    pub workers: Vec<S>,
    /// What is asked for points.
    pub graded: S,
}

/// The newest hands of an exercise. Nothing here ever waits for the student's functions.
pub struct Hands {
    package: Package,
    motions: Vec<Asked>,
    /// The version that all this is about, and the newest one.
    number: u64,
    newest: Arc<AtomicU64>,
    ready: bool,
    failed: Option<Arc<Trouble>>,
    grading: bool,
    board: Option<Arc<Board>>,
    former: Option<Arc<Board>>,
    events: Receiver<(u64, Event)>,
    rebuilder: Rebuilder,
}

/// What came of asking this version about one motion.
#[derive(Clone, Default)]
enum Asked {
    #[default]
    NotYet,
    Answered,
    Failed(Arc<Trouble>),
}

/// What a thread found out.
pub(super) enum Event {
    /// It is built.
    Ready(Vec<Box<dyn Hand>>),
    /// It cannot be asked at all.
    Failed(Arc<Trouble>),
    /// It has answered for a motion.
    Answered(usize),
    /// It gave no answer for a motion, or none that can be used.
    Trouble(usize, Arc<Trouble>),
    Grading,
    Graded(Arc<Board>),
}

/// How points are counted.
pub(super) type Grade = fn(&mut dyn Subject, Package) -> Board;

impl Hands {
    /// Builds with `open`, on a thread of its own, for `count` motions. For every save it is called again, never twice at
    /// once. `rest` gives who does what is not the student's part of an edit. `tell` is called on other threads.
    pub fn start<S: Subject + Send + 'static>(
        package: Package,
        count: usize,
        open: impl FnMut(&Version) -> Result<Opened<S>, Trouble> + Send + 'static,
        rest: impl Fn() -> Box<dyn Hand> + Send + Sync + 'static,
        tell: impl FnMut(News) + Send + 'static,
    ) -> Hands {
        Hands::start_with(package, count, open, rest, tell, Board::of)
    }

    /// The same, with another way to count points.
    pub(super) fn start_with<S: Subject + Send + 'static>(
        package: Package,
        count: usize,
        open: impl FnMut(&Version) -> Result<Opened<S>, Trouble> + Send + 'static,
        rest: impl Fn() -> Box<dyn Hand> + Send + Sync + 'static,
        tell: impl FnMut(News) + Send + 'static,
        grade: Grade,
    ) -> Hands {
        let (sender, events): (Sender<(u64, Event)>, _) = mpsc::channel();
        let (open, rest) = (Arc::new(Mutex::new(open)), Arc::new(rest));
        let tell = Arc::new(Mutex::new(tell));
        let start = move |number, version: Version, before| {
            let report = Report::new(number, version, sender.clone(), tell.clone());
            let work = Work { package, report, before, grade };
            let (open, rest) = (Arc::clone(&open), Arc::clone(&rest));
            thread::Builder::new().name("student".into()).spawn(move || work.run(&open, &*rest)).map(|_| ())
        };
        let newest = Arc::new(AtomicU64::new(0));
        let begin = {
            let newest = Arc::clone(&newest);
            move || newest.fetch_add(1, Ordering::SeqCst) + 1
        };
        let rebuilder = Rebuilder::new(Box::new(begin), Box::new(start));
        let mut hands = Hands {
            package,
            motions: vec![Asked::default(); count],
            number: 0,
            newest,
            ready: false,
            failed: None,
            grading: false,
            board: None,
            former: None,
            events,
            rebuilder,
        };
        hands.rebuilder.rebuild();
        hands.follow();
        hands
    }

    /// What can be called, on any thread, when the file was saved: the version before is abandoned, whatever it is doing.
    pub fn rebuilder(&self) -> Rebuilder {
        self.rebuilder.clone()
    }

    /// The exercise.
    pub fn package(&self) -> Package {
        self.package
    }

    /// Takes what has come: motions (from 0), and who answers for their edits from now on. Never waits.
    pub fn update(&mut self) -> Vec<(usize, Box<dyn Hand>)> {
        self.follow();
        let mut hands = Vec::new();
        while let Ok((number, event)) = self.events.try_recv() {
            if number > self.number {
                // The save was noticed just now, on another thread. Nobody answers for what was built before.
                self.follow();
                hands.clear();
            }
            if number < self.number {
                continue;
            }
            match event {
                Event::Ready(ready) => {
                    self.ready = true;
                    hands = ready.into_iter().enumerate().collect();
                }
                other => self.take(other),
            }
        }
        hands
    }

    /// Begins anew if there is a new version.
    fn follow(&mut self) {
        let number = self.newest.load(Ordering::SeqCst);
        if std::mem::replace(&mut self.number, number) == number {
            return;
        }
        self.motions.fill(Asked::NotYet);
        (self.ready, self.failed, self.grading) = (false, None, false);
        self.former = self.board.take().or(self.former.take());
        if let Some(error) = self.rebuilder.take_trouble() {
            let headline = "your functions cannot be asked".into();
            self.failed = Some(Arc::new(Trouble { headline, details: vec![error.to_string()] }));
        }
    }

    fn take(&mut self, event: Event) {
        match event {
            Event::Ready(_) => {}
            Event::Failed(trouble) => self.failed = Some(trouble),
            Event::Answered(motion) => self.set(motion, Asked::Answered),
            Event::Trouble(motion, trouble) => self.set(motion, Asked::Failed(trouble)),
            Event::Grading => self.grading = true,
            Event::Graded(board) => {
                self.grading = false;
                self.board = Some(board);
            }
        }
    }

    fn set(&mut self, motion: usize, new: Asked) {
        if let Some(old) = self.motions.get_mut(motion) {
            *old = new;
        }
    }

    /// How things stand with the functions, where they answer for motion `motion` (from 0).
    pub fn standing(&self, motion: usize) -> Standing {
        let asked = self.motions.get(motion).cloned().unwrap_or_default();
        let status = match (&self.failed, asked) {
            (Some(trouble), _) => Status::Failed(Arc::clone(trouble)),
            (None, Asked::Failed(trouble)) => Status::Failed(trouble),
            (None, Asked::Answered) => Status::Answered,
            (None, Asked::NotYet) if self.ready => Status::Asking,
            (None, Asked::NotYet) => Status::Compiling,
        };
        let current = status == Status::Answered;
        let former = self.former.as_ref().filter(|_| self.board.is_none()).cloned();
        Standing { status, current, board: self.board.clone(), former, grading: self.grading }
    }
}

impl Drop for Hands {
    /// Ends the workers. Does not wait for a build.
    fn drop(&mut self) {
        self.rebuilder.end();
    }
}

/// All that the thread of a version needs.
struct Work {
    package: Package,
    report: Report,
    /// The version before, whose last acts are still to be done.
    before: Version,
    grade: Grade,
}

impl Work {
    fn run<S: Subject + Send + 'static>(
        self,
        open: &Mutex<impl FnMut(&Version) -> Result<Opened<S>, Trouble>>,
        rest: &impl Fn() -> Box<dyn Hand>,
    ) {
        self.before.end();
        let version = self.report.version();
        // One is built after the other: what was saved in the meantime needs no build of its own.
        let opened = {
            let mut open = lock(open);
            if version.is_abandoned() {
                return;
            }
            open(version)
        };
        let Opened { workers, mut graded } = match opened {
            Ok(opened) => opened,
            Err(trouble) => {
                let trouble = Arc::new(trouble);
                self.report.send(Event::Failed(Arc::clone(&trouble)));
                return self.report.tell(News::Trouble(trouble));
            }
        };
        let hand = |(motion, worker)| -> Box<dyn Hand> {
            Box::new(StudentHand::new(self.package, motion, worker, rest(), self.report.clone()))
        };
        self.report.send(Event::Ready(workers.into_iter().enumerate().map(hand).collect()));
        self.report.send(Event::Grading);
        let board = Arc::new((self.grade)(&mut graded, self.package));
        self.report.send(Event::Graded(Arc::clone(&board)));
        self.report.tell(News::Board(board));
    }
}
