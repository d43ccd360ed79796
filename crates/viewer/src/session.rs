//! Everything that a window shows: motions, the student's functions, and what changes on the disk.

use exam::fk::{LocalAnswer, PosedFrame};

use crate::answers::Answers;
use crate::app::Shown;
use crate::gallery::Gallery;
use crate::input::Gesture;
use crate::screen::Screen;
use crate::student::{Standing, Student};

/// Motions that are shown, and the functions that move them.
pub struct Session {
    /// The motions.
    pub gallery: Gallery,
    student: Option<Student>,
}

impl Session {
    /// T
    pub fn open(
        gallery: Gallery,
        _sources: Vec<crate::source::Source>,
        workspace: Option<std::path::PathBuf>,
    ) -> Session {
        let stage = gallery.apps()[0].stage().clone();
        let student = workspace.map(|w| Student::start(stage, move || crate::worker::compile(&w)));
        Session { gallery, student }
    }

    /// Shows `gallery`. With `student`, the student's functions move the figures; without, the reference's do.
    pub fn new(gallery: Gallery, student: Option<Student>) -> Session {
        Session { gallery, student }
    }

    /// Takes in what has changed. Never waits.
    pub fn update(&mut self) {
        if let Some(student) = &mut self.student {
            student.update(self.gallery.apps()[0].frame());
        }
    }

    /// Makes the screen's picture what is to be seen now in a window of `size` pixels. Gives whether it has changed.
    pub fn draw(&mut self, screen: &mut Screen, size: (usize, usize)) -> bool {
        let answers = OfMotion::all(&self.student, self.gallery.apps().len());
        screen.update(&mut self.gallery, |motion| shown(&answers, motion), size)
    }

    /// Does what the mouse asks for, in a window of `size` pixels.
    pub fn gesture(&mut self, gesture: Gesture, size: (usize, usize)) {
        match gesture {
            Gesture::Orbit(right, down) => {
                self.gallery.apps_mut().iter_mut().for_each(|app| app.orbit(right, down))
            }
            Gesture::Pan(right, down) => {
                for tile in self.gallery.tiles(size) {
                    self.gallery.apps_mut()[tile.motion].pan(right, down, tile.size);
                }
            }
            Gesture::Scrub { pressed, now } => self.gallery.scrub(pressed, now, size),
            Gesture::Click(x, y) => {
                let answers = OfMotion::all(&self.student, self.gallery.apps().len());
                for tile in self.gallery.tiles(size) {
                    if let Some(place) = tile.inside((x, y)) {
                        self.gallery.apps_mut()[tile.motion].click(
                            shown(&answers, tile.motion),
                            place,
                            tile.size,
                        );
                    }
                }
            }
        }
    }
}

/// The student's answers for one motion.
struct OfMotion<'a> {
    student: &'a Student,
    motion: usize,
}

impl OfMotion<'_> {
    fn all(student: &Option<Student>, count: usize) -> Vec<OfMotion<'_>> {
        let of = |student| (0..count).map(move |motion| OfMotion { student, motion });
        student.iter().flat_map(of).collect()
    }
}

fn shown<'a>(answers: &'a [OfMotion], motion: usize) -> Shown<'a> {
    answers.get(motion).map_or(Shown::Reference, |answers| Shown::Student(answers))
}

impl Answers for OfMotion<'_> {
    fn standing(&self, frame: usize) -> Standing {
        self.student.standing(self.motion, frame)
    }

    fn posed(&self, frame: usize) -> Option<&PosedFrame> {
        self.student.pose(frame)
    }

    fn locals(&self, _frame: usize) -> Option<&[LocalAnswer]> {
        None
    }
}
