//! Everything that a window shows: motions, the student's functions, and what changes on the disk.

use std::path::{Path, PathBuf};

use crate::live::watch::{Baseline, Change, Watcher};
use crate::live::{Live, OfMotion};
use crate::motion::source::Source;
use crate::view::app::{App, Shown};
use crate::view::gallery::Gallery;
use crate::view::screen::Screen;
use crate::window::input::Gesture;

/// Motions that are shown, and the functions that move them. Whatever of it is saved anew is shown anew.
pub struct Session {
    /// The motions.
    pub gallery: Gallery,
    sources: Vec<Source>,
    functions: Functions,
}

/// Whose functions move the figures.
enum Functions {
    /// The student's. They watch the motions' files too.
    Student(Box<Live>),
    /// The reference's.
    Reference(Watcher),
}

impl Session {
    /// Shows `gallery`, whose motions were read from `sources`, in the same order. The functions of the exercise in the
    /// folder `workspace` move the figures, or else the reference's.
    pub fn open(gallery: Gallery, sources: Vec<Source>, workspace: Option<&Path>) -> Session {
        let files: Vec<PathBuf> = sources.iter().map(|source| source.path.clone()).collect();
        let functions = match workspace {
            Some(workspace) => {
                let stages = gallery.apps().iter().map(|app| app.stage().clone()).collect();
                Functions::Student(Box::new(Live::open(workspace, stages, files)))
            }
            None => Functions::Reference(Watcher::start(Baseline::of_motions(&files), |_| {})),
        };
        Session { gallery, sources, functions }
    }

    /// Takes in what has changed. Never waits for the student's functions.
    pub fn update(&mut self) {
        let saved = match &mut self.functions {
            Functions::Student(live) => {
                let shown: Vec<usize> = self.gallery.apps().iter().map(App::frame).collect();
                for (motion, app) in self.gallery.apps().iter().enumerate() {
                    if app.selected().is_some() {
                        live.student_mut().locals(motion, app.frame());
                    }
                }
                live.update(&shown)
            }
            Functions::Reference(watcher) => {
                let changes: Vec<Change> = watcher.changes().collect();
                let is_saved =
                    |motion: &usize| changes.contains(&Change::Motion(self.sources[*motion].path.clone()));
                (0..self.sources.len()).filter(is_saved).collect()
            }
        };
        saved.into_iter().for_each(|motion| self.read_again(motion));
    }

    fn read_again(&mut self, motion: usize) {
        let app = &mut self.gallery.apps_mut()[motion];
        match self.sources[motion].read() {
            Ok(loaded) => {
                if let Functions::Student(live) = &mut self.functions {
                    live.replace_stage(motion, loaded.stage.clone());
                }
                app.replace(loaded.stage, loaded.warnings);
            }
            Err(error) => {
                eprintln!("{error}");
                app.cannot_read(&error.to_string());
            }
        }
    }

    /// Makes the screen's picture what is to be seen now in a window of `size` pixels. Gives whether it has changed.
    pub fn draw(&mut self, screen: &mut Screen, size: (usize, usize)) -> bool {
        let answers = self.functions.answers(self.sources.len());
        screen.update(&mut self.gallery, |motion| shown(&answers, motion), size)
    }

    /// Does what the mouse asks for, in a window of `size` pixels.
    pub fn gesture(&mut self, gesture: Gesture, size: (usize, usize)) {
        match gesture {
            Gesture::Orbit(right, down) => {
                self.gallery.apps_mut().iter_mut().for_each(|app| app.orbit(right, down));
            }
            Gesture::Pan(right, down) => {
                for tile in self.gallery.tiles(size) {
                    self.gallery.apps_mut()[tile.motion].pan(right, down, tile.size);
                }
            }
            Gesture::Scrub { pressed, now } => self.gallery.scrub(pressed, now, size),
            Gesture::Click(x, y) => {
                let answers = self.functions.answers(self.sources.len());
                for tile in self.gallery.tiles(size) {
                    if let Some(place) = tile.inside((x, y)) {
                        let shown = shown(&answers, tile.motion);
                        self.gallery.apps_mut()[tile.motion].click(shown, place, tile.size);
                    }
                }
            }
        }
    }
}

impl Functions {
    /// The student's answers for each of `count` motions; none when the reference's functions are shown.
    fn answers(&self, count: usize) -> Vec<OfMotion<'_>> {
        match self {
            Functions::Student(live) => (0..count).map(|motion| live.of(motion)).collect(),
            Functions::Reference(_) => Vec::new(),
        }
    }
}

fn shown<'a>(answers: &'a [OfMotion], motion: usize) -> Shown<'a> {
    answers.get(motion).map_or(Shown::Reference, |answers| Shown::Student(answers))
}
