//! Everything that a window shows: motions, the student's functions, and what changes on the disk.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::mpsc::{self, Receiver, TryRecvError};
use std::thread;

use crate::edit::{Engine, Hand, ReferenceHand};
use crate::live::package::Package;
use crate::live::sister::{Come, Sister};
use crate::live::watch::{Baseline, Watcher};
use crate::live::{Live, OfMotion};
use crate::motion::source::{Loaded, Source, Unreadable};
use crate::motion::stage::Stage;
use crate::view::app::{self, App, Shown};
use crate::view::gallery::Gallery;
use crate::view::screen::Screen;
use crate::view::warp::Warp;
use crate::window::input::Gesture;

/// Motions that are shown, and the functions that move them. Whatever of it is saved anew is shown anew.
pub struct Session {
    /// The motions.
    pub gallery: Gallery,
    sources: Vec<Source>,
    /// What is known of the motions by those that edit them, and by the student's functions.
    stages: Vec<Arc<Stage>>,
    /// Files that are being read again: long ones take a moment, for which no picture waits.
    readings: Vec<Option<Receiver<Reading>>>,
    /// What edits each motion.
    engines: Vec<Engine>,
    functions: Functions,
}

type Reading = Result<Loaded, Unreadable>;

/// Whose functions move the figures, and edit the motions. They watch the motions' files too.
enum Functions {
    /// The student's move the figures. The reference's edit.
    Student(Box<Live>),
    /// The student's have a part in editing. The reference's do the rest.
    Sister(Box<Sister>),
    /// The reference's. The files of each motion are watched.
    Reference(Watcher, Vec<Vec<PathBuf>>),
}

impl Session {
    /// Shows `gallery`, whose motions were read from `sources`, in the same order. The functions of the exercise `followed`,
    /// in the workspace in that folder, do their part, and the reference's all the rest.
    pub fn open(gallery: Gallery, sources: Vec<Source>, followed: Option<(Package, &Path)>) -> Session {
        let files: Vec<Vec<PathBuf>> = sources.iter().map(Source::files).collect();
        let stages: Vec<Arc<Stage>> = gallery.apps().iter().map(|app| app.stage().clone()).collect();
        let functions = match followed {
            Some((package, workspace)) => match package.mover() {
                Some(mover) => {
                    Functions::Student(Box::new(Live::open(mover, workspace, stages.clone(), files)))
                }
                None => Functions::Sister(Box::new(Sister::open(package, workspace, files, reference))),
            },
            None => {
                let watcher = Watcher::start(Baseline::of_motions(&files), |_| {});
                Functions::Reference(watcher, files)
            }
        };
        let readings = sources.iter().map(|_| None).collect();
        // Until a student's functions are built, nobody edits.
        let hand = || (!matches!(functions, Functions::Sister(_))).then(reference);
        let engine = |app: &App| Engine::start(app.stage().clone(), hand());
        let engines = gallery.apps().iter().map(engine).collect();
        Session { gallery, sources, stages, readings, engines, functions }
    }

    /// Takes in what has changed. Never waits.
    pub fn update(&mut self) {
        self.hand_on();
        let saved = match &mut self.functions {
            Functions::Student(live) => {
                let shown: Vec<usize> = self.gallery.apps().iter().map(App::frame).collect();
                for (motion, app) in self.gallery.apps().iter().enumerate() {
                    if app.selected().is_some() {
                        live.student_mut().details(motion, app.frame());
                    }
                }
                live.update(&shown)
            }
            Functions::Sister(sister) => {
                let Come { saved, hands } = sister.update();
                for (motion, hand) in hands {
                    self.engines[motion].set_hand(hand);
                }
                saved
            }
            Functions::Reference(watcher, files) => watcher.saved_motions(files),
        };
        // A warped motion follows its original.
        for motion in saved.into_iter().filter(|motion| self.sources[*motion].warp.is_none()) {
            self.readings[motion] = Some(read_in_background(self.sources[motion].clone()));
        }
        (0..self.readings.len()).for_each(|motion| self.take_reading(motion));
        self.hand_on();
        for (motion, (app, engine)) in self.gallery.apps_mut().iter_mut().zip(&mut self.engines).enumerate() {
            engine.want(app.wish());
            engine.update();
            app.show_edit(engine.state());
            match &self.functions {
                Functions::Sister(sister) => {
                    let (package, standing) = (sister.package(), sister.standing(motion));
                    app.show_sister(Some(app::Sister { package, standing }));
                }
                Functions::Student(_) | Functions::Reference(..) => {}
            }
        }
        if let Functions::Student(live) = &self.functions {
            self.gallery.show_points(live.mover(), &live.student().points());
        }
    }

    /// Shows what a file holds now, when it has been read.
    fn take_reading(&mut self, motion: usize) {
        let read = match self.readings[motion].as_ref().map(Receiver::try_recv) {
            None | Some(Err(TryRecvError::Empty)) => return,
            Some(read) => read,
        };
        self.readings[motion] = None;
        let behind = self.sources.get(motion + 1).and_then(|source| source.warp);
        match read {
            // There was no thread to read it: the next save is another chance.
            Err(_) => {}
            Ok(Ok(loaded)) => {
                let warp =
                    behind.map(|warping| Warp::of_motion(&warping, loaded.stage.motion().frame_count()));
                self.gallery.replace(motion, &loaded.stage, loaded.warnings, warp);
            }
            Ok(Err(error)) => {
                eprintln!("{error}");
                let tiles = motion..=motion + usize::from(behind.is_some());
                tiles.for_each(|tile| self.gallery.apps_mut()[tile].cannot_read(&error.to_string()));
            }
        }
    }

    /// Lets everybody know of motions that have changed: on the disk, or by keys.
    fn hand_on(&mut self) {
        let apps = self.gallery.apps().iter().enumerate();
        for ((motion, app), known) in apps.zip(&mut self.stages) {
            if Arc::ptr_eq(app.stage(), known) {
                continue;
            }
            known.clone_from(app.stage());
            if let Functions::Student(live) = &mut self.functions {
                live.replace_stage(motion, known.clone());
            }
            self.engines[motion].replace_stage(known.clone());
        }
    }

    /// Makes the screen's picture what is to be seen now in a window of `size` pixels. Gives whether it has changed.
    pub fn draw(&mut self, screen: &mut Screen, size: (usize, usize)) -> bool {
        let answers = self.functions.answers(&self.stages);
        screen.update(&mut self.gallery, |motion| shown(&answers, motion), size)
    }

    /// Does what the mouse asks for, in a window of `size` pixels.
    pub fn gesture(&mut self, gesture: Gesture, size: (usize, usize)) {
        match gesture {
            Gesture::Orbit(right, down) => {
                self.gallery.apps_mut().iter_mut().for_each(|app| app.orbit(right, down));
            }
            Gesture::Pan(right, down) => {
                // Those that are not shown are to stay in step.
                let tile = self.gallery.tiles(size).next().map_or(size, |tile| tile.size);
                self.gallery.apps_mut().iter_mut().for_each(|app| app.pan(right, down, tile));
            }
            Gesture::Scrub { pressed, now } => self.gallery.scrub(pressed, now, size),
            Gesture::Click(x, y) => {
                let answers = self.functions.answers(&self.stages);
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

fn reference() -> Box<dyn Hand> {
    Box::new(ReferenceHand::default())
}

fn read_in_background(source: Source) -> Receiver<Reading> {
    let (sender, reading) = mpsc::channel();
    // When a newer save is being read already, nobody wants this one.
    let read = move || drop(sender.send(source.read()));
    // Without a thread the sender goes at once, which is noticed.
    let _ = thread::Builder::new().name("motion".into()).spawn(read);
    reading
}

impl Functions {
    /// The student's answers for the motion on each of `stages`; none where the reference's functions are shown.
    fn answers(&self, stages: &[Arc<Stage>]) -> Vec<Option<OfMotion<'_>>> {
        match self {
            Functions::Student(live) => {
                let of = |(motion, stage): (usize, &Arc<Stage>)| live.moves(stage).then(|| live.of(motion));
                stages.iter().enumerate().map(of).collect()
            }
            Functions::Sister(_) | Functions::Reference(..) => Vec::new(),
        }
    }
}

fn shown<'a>(answers: &'a [Option<OfMotion>], motion: usize) -> Shown<'a> {
    let answers = answers.get(motion).and_then(Option::as_ref);
    answers.map_or(Shown::Reference, |answers| Shown::Student(answers))
}
