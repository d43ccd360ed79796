//! The student's functions in step with the file: every save is built, asked and graded.
//!
//! Those that pose figures by themselves move what is shown: [`Live`]. Those of the two exercises on editing a motion make
//! what is edited: [`sister`].

pub mod board;
mod diagnostic;
pub mod mover;
pub mod package;
pub mod rebuilder;
pub mod sister;
pub mod student;
pub mod version;
pub mod watch;
pub mod worker;

use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use exam::WorkerProcess;

use crate::motion::stage::Stage;
use crate::view::answers::Answers;
use board::Board;
use mover::Mover;
use package::Package;
use rebuilder::Rebuilder;
use student::{Details, News, Posed, Standing, Student};
use version::Version;
use watch::{Baseline, Change, Watcher};
use worker::Trouble;

/// The student's functions, the files that are watched, and what the terminal is told.
pub struct Live {
    mover: Mover,
    student: Student,
    watcher: Watcher,
    motions: Vec<Vec<PathBuf>>,
}

impl Live {
    /// Builds the exercise `mover` of the workspace in the folder `workspace`, and asks it about `stages`. From now on the
    /// exercise is watched, and so are the files that each of the stages was read from: `motions`, in the same order.
    ///
    /// Points, troubles and what the student's functions print go to the terminal.
    pub fn open(mover: Mover, workspace: &Path, stages: Vec<Arc<Stage>>, motions: Vec<Vec<PathBuf>>) -> Live {
        let (package, folder) = (mover.package(), workspace.to_owned());
        let build =
            move |version: &_| worker::compile(package, &folder, version).map(|program| program.worker());
        Live::open_with(mover, workspace, stages, motions, build)
    }

    /// The same, with another way to build the exercise.
    pub fn open_with(
        mover: Mover,
        workspace: &Path,
        stages: Vec<Arc<Stage>>,
        motions: Vec<Vec<PathBuf>>,
        build: impl FnMut(&Version) -> Result<WorkerProcess, Trouble> + Send + 'static,
    ) -> Live {
        // What is saved from here on is noticed; what was saved before is what is built.
        let baseline = Baseline::now(&mover.package().sources(workspace), &motions);
        let build = building_anew(mover.package(), workspace, build);
        let mut terminal = Terminal::default();
        let student = Student::start(mover, stages, build, move |news| terminal.tell(news));
        let watcher = watch(baseline, student.rebuilder());
        Live { mover, student, watcher, motions }
    }

    /// Takes what has come, and gives the motions (from 0) whose files were saved: these are to be read again and handed to
    /// [`replace_stage`](Live::replace_stage). `shown` is the frame that is shown of each motion. Never waits; to be called
    /// for every picture.
    pub fn update(&mut self, shown: &[usize]) -> Vec<usize> {
        let saved = self.watcher.saved_motions(&self.motions);
        self.student.update(shown);
        saved
    }

    /// Motion `motion` (from 0) was read again.
    pub fn replace_stage(&mut self, motion: usize, stage: Arc<Stage>) {
        self.student.replace_stage(motion, stage);
    }

    /// What is known of them on motion `motion` (from 0).
    pub fn of(&self, motion: usize) -> OfMotion<'_> {
        OfMotion { mover: self.mover, student: &self.student, motion }
    }

    /// The exercise.
    pub fn mover(&self) -> Mover {
        self.mover
    }

    /// Whether the functions have anything to do with the motion on `stage`.
    pub fn moves(&self, stage: &Stage) -> bool {
        self.mover.moves(stage)
    }

    /// The student's functions.
    pub fn student(&self) -> &Student {
        &self.student
    }

    /// The same, who can be asked for the [details](Student::details) of a frame.
    pub fn student_mut(&mut self) -> &mut Student {
        &mut self.student
    }
}

/// The same way to build, which builds every save after the first time, whatever the time of the file is.
fn building_anew<T>(
    package: Package,
    workspace: &Path,
    mut build: impl FnMut(&Version) -> Result<T, Trouble> + Send + 'static,
) -> impl FnMut(&Version) -> Result<T, Trouble> + Send + 'static {
    let (folder, mut saved) = (workspace.to_owned(), false);
    move |version: &Version| {
        if std::mem::replace(&mut saved, true) {
            worker::make_stale(package, &folder);
        }
        build(version)
    }
}

/// Has the exercise built again whenever it is saved, from `baseline` on.
fn watch(baseline: Baseline, rebuilder: Rebuilder) -> Watcher {
    let at_once = move |change: &Change| {
        if *change == Change::Exercise {
            rebuilder.rebuild();
        }
    };
    let watcher = Watcher::start(baseline, at_once);
    if let Some(note) = watcher.note() {
        eprintln!("{note}");
    }
    watcher
}

/// What is known of the student's functions on one motion.
pub struct OfMotion<'a> {
    mover: Mover,
    student: &'a Student,
    motion: usize,
}

impl Answers for OfMotion<'_> {
    fn mover(&self) -> Mover {
        self.mover
    }

    fn standing(&self, frame: usize) -> Standing {
        self.student.standing(self.motion, frame)
    }

    fn posed(&self, frame: usize) -> Option<&Posed> {
        self.student.pose(self.motion, frame)
    }

    fn version(&self, frame: usize) -> Option<u64> {
        self.student.version(self.motion, frame)
    }

    fn details(&self, frame: usize) -> Option<&Details> {
        self.student.known_details(self.motion, frame)
    }
}

/// What the terminal was told last.
#[derive(Default)]
struct Terminal {
    board: Option<Arc<Board>>,
}

impl Terminal {
    fn tell(&mut self, news: News) {
        match news {
            // Colours only where they can be seen: anstream knows terminals and NO_COLOR.
            News::Board(board) => {
                anstream::print!("{}", board.news_since(self.board.as_deref()));
                self.board = Some(board);
            }
            News::Trouble(trouble) if trouble.is_in_terminal() => eprintln!("{}", trouble.headline),
            News::Trouble(trouble) => {
                eprintln!("{}", trouble.headline);
                trouble.details.iter().for_each(|line| eprintln!("  {line}"));
            }
        }
    }
}

fn lock<T: ?Sized>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
