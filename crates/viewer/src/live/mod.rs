//! The student's functions in step with the file: every save is built, asked and graded.

pub mod board;
mod diagnostic;
pub mod student;
pub mod watch;
pub mod worker;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use exam::WorkerProcess;
use exam::fk::{LocalAnswer, PosedFrame};

use crate::motion::stage::Stage;
use crate::view::answers::Answers;
use board::Board;
use student::{News, Standing, Student, Version};
use watch::{Baseline, Change, Watcher};
use worker::Trouble;

/// The student's functions, the files that are watched, and what the terminal is told.
pub struct Live {
    student: Student,
    watcher: Watcher,
    motions: Vec<PathBuf>,
}

impl Live {
    /// Builds the exercise of the workspace in the folder `workspace`, and asks it about `stages`. From now on the
    /// exercise is watched, and so are the files `motions` that the stages were read from, in the same order.
    ///
    /// Points, troubles and what the student's functions print go to the terminal.
    pub fn open(workspace: &Path, stages: Vec<Arc<Stage>>, motions: Vec<PathBuf>) -> Live {
        let folder = workspace.to_owned();
        Live::open_with(workspace, stages, motions, move |version| worker::compile(&folder, version))
    }

    /// The same, with another way to build the exercise.
    pub fn open_with(
        workspace: &Path,
        stages: Vec<Arc<Stage>>,
        motions: Vec<PathBuf>,
        mut build: impl FnMut(&Version) -> Result<WorkerProcess, Trouble> + Send + 'static,
    ) -> Live {
        // What is saved from here on is noticed; what was saved before is what is built.
        let baseline = Baseline::now(&workspace.join("exercises").join("fk").join("src"), &motions);
        let (folder, mut saved) = (workspace.to_owned(), false);
        let build = move |version: &Version| {
            if std::mem::replace(&mut saved, true) {
                worker::make_stale(&folder);
            }
            build(version)
        };
        let mut terminal = Terminal::default();
        let student = Student::start(stages, build, move |news| terminal.tell(news));
        let rebuilder = student.rebuilder();
        let at_once = move |change: &Change| {
            if *change == Change::Exercise {
                rebuilder.rebuild();
            }
        };
        let watcher = Watcher::start(baseline, at_once);
        if let Some(note) = watcher.note() {
            eprintln!("{note}");
        }
        Live { student, watcher, motions }
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
        OfMotion { student: &self.student, motion }
    }

    /// The student's functions.
    pub fn student(&self) -> &Student {
        &self.student
    }

    /// Asks for the local rotations of a frame: see [`Student::locals`].
    pub fn student_mut(&mut self) -> &mut Student {
        &mut self.student
    }
}

/// What is known of the student's functions on one motion.
pub struct OfMotion<'a> {
    student: &'a Student,
    motion: usize,
}

impl Answers for OfMotion<'_> {
    fn standing(&self, frame: usize) -> Standing {
        self.student.standing(self.motion, frame)
    }

    fn posed(&self, frame: usize) -> Option<&PosedFrame> {
        self.student.pose(self.motion, frame)
    }

    fn version(&self, frame: usize) -> Option<u64> {
        self.student.version(self.motion, frame)
    }

    fn locals(&self, frame: usize) -> Option<&[LocalAnswer]> {
        self.student.known_locals(self.motion, frame)
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
