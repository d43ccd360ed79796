//! Pictures, films and contact sheets: the window's own pictures, without a window.

use std::convert::Infallible;
use std::path::Path;
use std::sync::Arc;

use exam::WorkerProcess;

use super::arguments::{Arguments, Output};
use super::bar::bar;
use super::targets::shown;
use super::{edited, say, text, workspace};
use crate::draw::Painter;
use crate::draw::canvas::Canvas;
use crate::live::board::Board;
use crate::live::mover::Mover;
use crate::live::student::{Points, Status};
use crate::live::version::Version;
use crate::live::worker;
use crate::motion::source::Source;
use crate::output::film::{self, Format, Frames};
use crate::output::frames::FrameRange;
use crate::output::picture;
use crate::output::sheet::{Sheet, spread};
use crate::view::answers::Recorded;
use crate::view::app::{App, Shown};
use crate::view::gallery::Gallery;
use crate::view::screen::Screen;
use crate::view::texts;
use crate::window::keys::Action;

/// Writes what the command line asks for.
pub fn write(arguments: &Arguments, output: &Output, sources: &[Source]) -> Result<(), String> {
    let mut studio = Studio::open(arguments, output, sources)?;
    let path = output.path();
    let written = match output {
        Output::Png(_) => studio.picture(path),
        Output::Gif(_) => studio.film(path, Format::Gif),
        Output::Apng(_) => studio.film(path, Format::Apng),
        Output::Sheet(_) => studio.sheet(path, arguments),
    };
    say(&format!("{}: {}\n", shown(path), written?))
}

/// What pictures are made of.
struct Studio {
    gallery: Gallery,
    /// Those of each motion; none where the reference's figure is shown.
    answers: Vec<Option<Recorded>>,
    screen: Screen,
    size: (usize, usize),
    /// The frames of the first motion that become pictures.
    frames: Vec<usize>,
    /// How long each is shown, in seconds.
    seconds: f64,
}

impl Studio {
    fn open(arguments: &Arguments, output: &Output, sources: &[Source]) -> Result<Studio, String> {
        let mut apps = Vec::new();
        for source in sources {
            let loaded = source.read_behind(apps.last().map(App::stage)).map_err(text)?;
            let tile = arguments.tile(sources.len());
            apps.push(App::new(loaded.stage, source.title(), loaded.warnings, tile));
        }
        let mut gallery = Gallery::new(apps);
        arguments.prepare(&mut gallery)?;
        gallery.apps_mut().iter_mut().for_each(|app| app.settings.still = true);
        let (frames, seconds) = choose(arguments, output, &gallery)?;
        let mut studio = Studio {
            gallery,
            answers: Vec::new(),
            screen: Screen::new(arguments.size()),
            size: arguments.size(),
            frames,
            seconds,
        };
        let package = arguments.exercise;
        match package.mover().filter(|_| !arguments.solution) {
            None if arguments.solution => edited::by_reference(&mut studio.gallery),
            None => edited::by_student(package, &workspace(), &mut studio.gallery),
            Some(mover) => {
                edited::by_reference(&mut studio.gallery);
                // Of an edited motion both figures are the reference's.
                if studio.gallery.apps().iter().all(|app| app.wish().is_none()) {
                    studio.ask(mover);
                }
            }
        }
        Ok(studio)
    }

    /// Asks the student's functions for all that will be seen of them.
    fn ask(&mut self, mover: Mover) {
        let version = Version::default();
        let built = worker::compile(mover.package(), &workspace(), &version);
        let mut worker = built.map(|program| program.worker());
        for motion in 0..self.gallery.apps().len() {
            if !mover.moves(self.gallery.apps()[motion].stage()) {
                self.answers.push(None);
                continue;
            }
            let recorded = match &mut worker {
                Err(trouble) => Recorded::new(mover, Status::Failed(trouble.clone().into())),
                Ok(worker) => self.record(mover, worker, motion),
            };
            let shown = |frame: &usize| self.gallery.frame_at_the_time_of(0, *frame, motion);
            tell(&recorded, self.frames.iter().map(shown));
            self.answers.push(Some(recorded));
        }
        if let Ok(worker) = &mut worker {
            // What is printed while other questions are answered is about nothing that the picture shows.
            version.hush(true);
            let board = Arc::new(Board::of(worker, mover.package()));
            for recorded in self.answers.iter_mut().flatten() {
                recorded.standing.board = Some(board.clone());
            }
            self.gallery.show_points(mover, &Points { board: Some(board), ..Points::default() });
        }
    }

    fn record(&self, mover: Mover, worker: &mut WorkerProcess, motion: usize) -> Recorded {
        let app = &self.gallery.apps()[motion];
        let mut recorded = if mover.is_asked_whole(app.stage()) {
            // Whoever makes all frames at once is asked for all.
            Recorded::ask(mover, worker, app.stage(), 0..app.stage().frame_count())
        } else {
            let frames = self.frames.iter().flat_map(|frame| self.seen_with(motion, *frame));
            Recorded::ask(mover, worker, app.stage(), frames)
        };
        if app.selected().is_some() && app.settings.words {
            for frame in &self.frames {
                recorded.ask_details(
                    worker,
                    app.stage(),
                    self.gallery.frame_at_the_time_of(0, *frame, motion),
                );
            }
        }
        recorded
    }

    /// The frames of a motion that are seen in the picture of one frame of the first motion.
    fn seen_with(&self, motion: usize, frame: usize) -> impl Iterator<Item = usize> + use<> {
        let app = &self.gallery.apps()[motion];
        let mut player = app.player().clone();
        player.go_to(self.gallery.frame_at_the_time_of(0, frame, motion));
        let traced = if app.settings.traces { app.traced_frames() } else { 1 };
        player.traced(traced)
    }

    fn draw(&mut self, frame: usize) {
        self.gallery.go_to(0, frame);
        self.draw_now();
    }

    fn draw_playing(&mut self, frame: usize) {
        self.gallery.go_to(0, frame);
        self.gallery.act(Action::Play);
        self.draw_now();
    }

    fn draw_now(&mut self) {
        let answers = &self.answers;
        let of = |motion: usize| answers.get(motion).and_then(Option::as_ref);
        let shown = |motion: usize| of(motion).map_or(Shown::Reference, |answers| Shown::Student(answers));
        self.screen.update(&mut self.gallery, shown, self.size);
    }

    fn picture(&mut self, path: &Path) -> Result<String, String> {
        let frame = self.frames.first().copied().unwrap_or_default();
        self.draw(frame);
        save(&self.screen, path)?;
        let (width, height) = self.screen.canvas().size();
        Ok(format!("frame {frame}, {width} x {height} pixels"))
    }

    fn film(&mut self, path: &Path, format: Format) -> Result<String, String> {
        let (count, size, seconds) = (self.frames.len(), self.size, self.seconds);
        let progress = bar(count, "{bar:40} {pos} of {len} pictures, {eta} left");
        let draw = |index: usize, canvas: &mut Canvas| {
            self.draw_playing(self.frames[index.min(count - 1)]);
            canvas.paste(self.screen.canvas(), 0, 0);
            Ok::<(), Infallible>(())
        };
        let frames = Frames { count, size, seconds };
        film::write(path, format, frames, draw, |done| progress.set_position(done as u64)).map_err(text)?;
        progress.finish_and_clear();
        let (width, height) = size;
        let pictures = texts::count(count, "picture", "pictures");
        Ok(format!("{pictures} of {width} x {height} pixels, {:.2} seconds", seconds * count as f64))
    }

    fn sheet(&mut self, path: &Path, arguments: &Arguments) -> Result<String, String> {
        let mut sheet = Sheet::new(self.frames.len(), self.size, None);
        self.size = sheet.tile();
        let (frames, mut painter) = (self.frames.clone(), Painter::new());
        for (index, frame) in frames.iter().take(sheet.count()).enumerate() {
            self.draw(*frame);
            // Several motions share a time, and not a frame's number.
            let caption = match self.gallery.apps() {
                [_] => format!("frame {frame}"),
                apps => format!("{:.2} s", *frame as f64 * apps[0].stage().motion().playable_frame_time()),
            };
            sheet.place(index, self.screen.canvas(), &caption, &mut painter);
        }
        let fewer = match sheet.count() < frames.len() {
            true => format!(" (of {}: more do not fit)", arguments.pictures),
            false => String::new(),
        };
        let (count, sheet) = (sheet.count(), sheet.finish());
        let frames = texts::count(count, "frame", "frames");
        picture::save(&sheet, path).map_err(|error| not_written(path, &error))?;
        Ok(format!("{frames}{fewer}, {} x {} pixels", sheet.size().0, sheet.size().1))
    }
}

/// The most pictures that are made: more would take days.
const MOST_PICTURES: usize = 1_000_000;

/// The frames of the first motion that become pictures, and how long each is shown. Of a pair they are those of the longer one.
fn choose(arguments: &Arguments, output: &Output, gallery: &Gallery) -> Result<(Vec<usize>, f64), String> {
    let first = &gallery.apps()[0];
    let motion = first.stage().motion();
    let seconds = motion.playable_frame_time() / arguments.speed;
    let range = arguments.frames.unwrap_or(FrameRange::ALL);
    let all =
        range.resolve(gallery.moving_frames()).map_err(|error| format!("{}: {error}", first.title()))?;
    let film = |format: Format| {
        // Of the chosen frames as many as programs show at their speed.
        let every = format.every(seconds * range.step() as f64);
        Ok::<_, String>((listed(all.clone().step_by(every))?, seconds * (every * range.step()) as f64))
    };
    Ok(match output {
        Output::Png(_) => (vec![arguments.frame()], seconds),
        Output::Gif(_) => film(Format::Gif)?,
        Output::Apng(_) => film(Format::Apng)?,
        Output::Sheet(_) if range.step() > 1 => (listed(all)?, seconds),
        Output::Sheet(_) => {
            let (mut first, mut last) = (all.clone(), all);
            let (first, last) = (first.next().unwrap_or(0), last.next_back().unwrap_or(0));
            (spread(first, last, arguments.pictures.into()), seconds)
        }
    })
}

/// These frames, if they are not too many.
fn listed(frames: impl ExactSizeIterator<Item = usize>) -> Result<Vec<usize>, String> {
    match frames.len() {
        0..=MOST_PICTURES => Ok(frames.collect()),
        count => Err(format!("{count} pictures are too many: choose frames with --frames")),
    }
}

/// Says in the terminal what is wrong with the student's functions, if anything is, and what that means for the frames that
/// become pictures. Others are asked for their traces.
fn tell(recorded: &Recorded, mut frames: impl Iterator<Item = usize>) {
    let general = match &recorded.standing.status {
        Status::Failed(trouble) => Some(trouble),
        _ => None,
    };
    let Some(trouble) = recorded.troubles.values().next().or(general) else { return };
    let shown = match recorded.poses.is_empty() {
        true => "the picture shows only the goal",
        false if frames.any(|frame| !recorded.poses.contains_key(&frame)) => {
            "where that is so, only the goal is shown"
        }
        false => "traces have gaps where that is so",
    };
    super::tell(trouble, shown);
}

fn save(screen: &Screen, path: &Path) -> Result<(), String> {
    picture::save(screen.canvas(), path).map_err(|error| not_written(path, &error))
}

fn not_written(path: &Path, error: &std::io::Error) -> String {
    format!("the picture cannot be written to {}: {error}", shown(path))
}
