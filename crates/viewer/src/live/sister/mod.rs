//! The two exercises on editing a motion, in step with their file: interpolation and keyframes.
//!
//! Their functions move no figure by themselves. They answer for what is edited, and so every saved version that can be
//! built becomes one [`Hand`] for each motion, with a worker of its own. Nothing is asked here but the questions for points.

mod ask;
mod hand;
mod hands;
mod now;
#[cfg(test)]
mod tests;

use std::path::{Path, PathBuf};

use super::package::Package;
use super::student::Standing;
use super::version::Version;
use super::watch::{Baseline, Watcher};
use super::worker::{self, Program, Trouble};
use super::{Terminal, building_anew, watch};
use crate::edit::Hand;

pub use hands::{Hands, Opened};
pub use now::Now;

/// The student's functions of one of these exercises, the files that are watched, and what the terminal is told.
pub struct Sister {
    hands: Hands,
    watcher: Watcher,
    motions: Vec<Vec<PathBuf>>,
}

/// What has come since the last picture.
#[derive(Default)]
pub struct Come {
    /// The motions (from 0) whose files were saved: these are to be read again.
    pub saved: Vec<usize>,
    /// Motions, and who answers for their edits from now on: newly built functions.
    pub hands: Vec<(usize, Box<dyn Hand>)>,
}

impl Sister {
    /// Builds `package` of the workspace in the folder `workspace`. From now on it is watched, and so are the files
    /// `motions`. What is not the student's part of an edit is done by what `rest` gives, anew for every version and motion.
    ///
    /// Points, troubles and what the student's functions print go to the terminal.
    pub fn open(
        package: Package,
        workspace: &Path,
        motions: Vec<Vec<PathBuf>>,
        rest: impl Fn() -> Box<dyn Hand> + Send + Sync + 'static,
    ) -> Sister {
        let folder = workspace.to_owned();
        Sister::open_with(package, workspace, motions, rest, move |version| {
            worker::compile(package, &folder, version)
        })
    }

    /// The same, with another way to build the package.
    pub fn open_with(
        package: Package,
        workspace: &Path,
        motions: Vec<Vec<PathBuf>>,
        rest: impl Fn() -> Box<dyn Hand> + Send + Sync + 'static,
        mut build: impl FnMut(&Version) -> Result<Program, Trouble> + Send + 'static,
    ) -> Sister {
        // What is saved from here on is noticed; what was saved before is what is built.
        let baseline = Baseline::now(&package.sources(workspace), &motions);
        let count = motions.len();
        let open = move |version: &Version| {
            let program = build(version)?;
            let workers = (0..count).map(|_| program.worker()).collect();
            Ok(Opened { workers, graded: program.silent_worker() })
        };
        let mut terminal = Terminal::default();
        let open = building_anew(package, workspace, open);
        let hands = Hands::start(package, count, open, rest, move |news| terminal.tell(news));
        let watcher = watch(baseline, hands.rebuilder());
        Sister { hands, watcher, motions }
    }

    /// Takes what has come. Never waits; to be called for every picture.
    pub fn update(&mut self) -> Come {
        Come { saved: self.watcher.saved_motions(&self.motions), hands: self.hands.update() }
    }

    /// The exercise.
    pub fn package(&self) -> Package {
        self.hands.package()
    }

    /// How things stand with the functions, where they answer for motion `motion` (from 0).
    pub fn standing(&self, motion: usize) -> Standing {
        self.hands.standing(motion)
    }
}
