//! What the command line says.

use std::path::{Path, PathBuf};

use clap::{Parser, ValueEnum};
use skeleton::PositionChannels;

use super::convert::OutArguments;
use super::files;
use super::keyframes::KeyframeArguments;
use super::targets::Target;
use super::values::{Side, parse_rate, parse_scale, parse_size, parse_speed};
use super::warp::WarpArguments;
use crate::live::mover::Mover;
use crate::live::package::Package;
use crate::motion::source::{Source, USUAL_RATE};
use crate::motion::upright::Up;
use crate::output::frames::{self, FrameRange};
use crate::scene::Style;
use crate::view::app::{EditSettings, Settings};
use crate::view::gallery::Gallery;
use crate::window::keys;

/// Shows a motion moved by YOUR functions in exercises/fk/src/fk.rs, with the right answer, the goal, as a ghost.
///
/// Your file is compiled again whenever you save it, and the picture follows.
#[derive(Clone, Debug, Parser)]
#[command(name = "cargo view", bin_name = "cargo view", after_help = keys_for_terminal())]
pub struct Arguments {
    /// The motion: a .bvh file, or an .asf file with the skeleton and an .amc file with its motion; several are shown side by
    /// side [default: data/running.bvh, data/dance.bvh for the exercise on interpolation, data/walk.amc for
    /// those on Acclaim and time warping]
    #[arg(value_name = "FILE")]
    files: Vec<PathBuf>,

    /// The exercise whose functions are yours; the reference does the rest
    #[arg(long, value_enum, value_name = "NAME", default_value_t)]
    pub exercise: Package,

    /// Shows what the reference solution does instead of yours, in every exercise
    #[arg(long)]
    pub solution: bool,

    /// Prints the skeleton and what is in the file, and opens no window
    #[arg(long, group = "output")]
    pub print: bool,

    /// Writes a picture of one frame, and opens no window: works without a display
    #[arg(long, value_name = "PICTURE", group = "output")]
    png: Option<PathBuf>,

    /// Writes a film that every program shows
    #[arg(long, value_name = "FILM", group = "output")]
    gif: Option<PathBuf>,

    /// Writes a film in all its colours, for browsers
    #[arg(long, value_name = "FILM", group = "output")]
    apng: Option<PathBuf>,

    /// Writes one picture that shows several frames side by side
    #[arg(long, value_name = "PICTURE", group = "output")]
    sheet: Option<PathBuf>,

    /// The frame to begin with, or for the picture: counted from 0 [default: 0]
    #[arg(long, value_name = "N", conflicts_with_all = ["gif", "apng", "sheet", "print"], allow_negative_numbers = true)]
    frame: Option<usize>,

    /// The frames of a film or a sheet: 100..200 (both included), 100.., ..50, or 100..200/4 for every fourth [default:
    /// all]
    #[arg(long, value_name = "RANGE", conflicts_with_all = ["png", "print"])]
    pub frames: Option<FrameRange>,

    /// How many pictures a sheet has
    #[arg(long, value_name = "N", default_value_t = 12, requires = "sheet", value_parser = clap::value_parser!(u16).range(1..=400))]
    pub pictures: u16,

    /// How fast a film is, compared with the motion
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0, value_parser = parse_speed)]
    pub speed: f64,

    /// Width and height of the window or the picture, in pixels; of each picture of a sheet [default: 1280x720, and
    /// 320x240 on a sheet, times the scale]
    #[arg(long, value_name = "WxH", value_parser = parse_size)]
    size: Option<(usize, usize)>,

    /// How large texts are: 2 for a display with very small pixels
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0, value_parser = parse_scale)]
    scale: f32,

    /// From where to look: degrees around the figure, degrees above the ground, and a zoom, as 90,20 or 90,20,1.5
    #[arg(long, value_name = "AROUND,ABOVE[,ZOOM]", allow_hyphen_values = true)]
    camera: Option<Side>,

    /// Draws plain lines instead of bodies
    #[arg(long)]
    lines: bool,

    /// The joint to look at, by its name
    #[arg(long, value_name = "NAME")]
    joint: Option<String>,

    /// Leaves things out of the picture
    #[arg(long, value_name = "THINGS", value_delimiter = ',')]
    hide: Vec<Thing>,

    /// Puts things into the picture that are not there at first
    #[arg(long, value_name = "THINGS", value_delimiter = ',')]
    show: Vec<Thing>,

    /// What a position channel does to the joint's OFFSET
    #[arg(long, value_enum, default_value_t = Positions::Replace)]
    positions: Positions,

    /// Frames per second of an .amc file, which does not say it [default: 120]
    #[arg(long, value_name = "N", value_parser = parse_rate, allow_negative_numbers = true)]
    rate: Option<f64>,

    /// The axis that points up in the file [default: told by the figure]
    #[arg(long, value_enum)]
    up: Option<Up>,

    /// What is said about time warps. Here and below, because options behind them would stand under their headings.
    #[command(flatten)]
    pub warp: WarpArguments,

    /// What is said about new motions.
    #[command(flatten)]
    pub out: OutArguments,

    /// What is said about keyframes.
    #[command(flatten)]
    pub keyframes: KeyframeArguments,
}

/// Something that can be in the picture or not.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Thing {
    /// The right answer, as a ghost
    #[value(alias = "ghost")]
    Goal,
    /// The joints' axes
    Axes,
    /// Where the tips have been
    Traces,
    /// Your points
    Points,
    /// What the keys do
    Help,
    /// All texts, the scale and the bar
    Words,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Positions {
    /// It takes its place: what most files mean
    Replace,
    /// It is added to it: what a few programs do
    Add,
}

/// What is written instead of opening a window.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Output {
    /// A picture.
    Png(PathBuf),
    /// A film.
    Gif(PathBuf),
    /// A film.
    Apng(PathBuf),
    /// A contact sheet.
    Sheet(PathBuf),
}

impl Arguments {
    /// The motions to show.
    ///
    /// # Errors
    ///
    /// When the skeleton of a motion of bones is not found, or there are no motions of bones for what is said of these.
    pub fn sources(&self, workspace: &Path) -> Result<Vec<Source>, String> {
        let name = match self.exercise {
            // A short motion with full turns shows most of what can be wrong between two frames.
            Package::Interpolation => "dance.bvh",
            Package::Acclaim | Package::TimeWarp => "walk.amc",
            Package::Fk | Package::Keyframes => "running.bvh",
        };
        let default = || vec![workspace.join("data").join(name)];
        let files = if self.files.is_empty() { default() } else { self.files.clone() };
        let source = |path| Source {
            rate: self.rate.unwrap_or(USUAL_RATE),
            positions: self.positions.into(),
            up: self.up,
            ..Source::new(path)
        };
        let sources = files::sources(&files, source)?;
        if self.rate.is_some() && !sources.iter().any(Source::has_bones) {
            let title = sources.first().map(Source::title).unwrap_or_default();
            return Err(format!(
                "--rate is for .amc files, which do not say how fast they are; {title} says it: Frame Time"
            ));
        }
        Ok(self.warp.beside(sources, self.exercise.mover().and_then(Mover::usual_warp)))
    }

    /// What to write, when there is to be no window.
    pub fn output(&self) -> Option<Output> {
        let png = self.png.clone().map(Output::Png);
        let gif = self.gif.clone().map(Output::Gif);
        let apng = self.apng.clone().map(Output::Apng);
        png.or(gif).or(apng).or(self.sheet.clone().map(Output::Sheet))
    }

    /// The motions, curves and tables to write.
    pub fn new_files(&self) -> Vec<Target<'_>> {
        self.out.targets().into_iter().chain(self.keyframes.targets()).collect()
    }

    /// The frame to begin with.
    pub fn frame(&self) -> usize {
        self.frame.unwrap_or(0)
    }

    /// Width and height of the window or the picture, or of each picture of a sheet.
    pub fn size(&self) -> (usize, usize) {
        let usual = if self.sheet.is_some() { (320.0, 240.0) } else { (1280.0, 720.0) };
        // Where texts are twice as large, there is to be as much room for them.
        let scaled = |side: f32| (side * self.scale.max(1.0)) as usize;
        self.size.unwrap_or((scaled(usual.0), scaled(usual.1)))
    }

    /// The size of each of `count` motions in one picture.
    pub fn tile(&self, count: usize) -> (usize, usize) {
        let ((width, height), (columns, rows)) = (self.size(), Gallery::grid(count, self.size()));
        (width / columns, height / rows)
    }

    /// Sets all motions up: what is drawn of them, the frame, the joint, and the side to look from.
    ///
    /// # Errors
    ///
    /// When the first one has no such frame, nor the same one warped; and when none of them has a joint of that name.
    pub fn prepare(&self, gallery: &mut Gallery) -> Result<(), String> {
        // Nothing is known of a file that cannot be read.
        if let Some(first) = gallery.apps().first().filter(|app| app.unreadable().is_empty()) {
            frames::check(self.frame(), gallery.moving_frames())
                .map_err(|error| format!("{}: {error}", first.title()))?;
        }
        for app in gallery.apps_mut() {
            app.settings = self.settings();
        }
        gallery.go_to(0, self.frame());
        if let Some(Side { around, above, zoom }) = self.camera {
            let tiles: Vec<_> = gallery.tiles(self.size()).collect();
            for tile in tiles {
                gallery.apps_mut()[tile.motion].look_from(around, above, zoom, tile.size);
            }
        }
        match &self.joint {
            Some(name) => select(gallery, name),
            None => Ok(()),
        }
    }

    fn settings(&self) -> Settings {
        let mut settings = Settings::default();
        for (things, shown) in [(&self.show, true), (&self.hide, false)] {
            for thing in things {
                *match thing {
                    Thing::Goal => &mut settings.ghost,
                    Thing::Axes => &mut settings.axes,
                    Thing::Traces => &mut settings.traces,
                    Thing::Points => &mut settings.points,
                    Thing::Help => &mut settings.help,
                    Thing::Words => &mut settings.words,
                } = shown;
            }
        }
        settings.edit = self.keyframes.begin(EditSettings::for_exercise(self.exercise));
        settings.bones = self.exercise.mover().is_some_and(Mover::needs_bones);
        settings.style = if self.lines { Style::Lines } else { Style::Lit };
        settings.text_scale = self.scale;
        // Captions say what there is to say on a sheet.
        settings.words &= self.sheet.is_none();
        settings
    }
}

/// Looks at the joint `name` in every motion that has it.
fn select(gallery: &mut Gallery, name: &str) -> Result<(), String> {
    let mut found = false;
    for app in gallery.apps_mut() {
        let joint = app.stage().motion().skeleton().joints().iter().position(|joint| joint.name == name);
        app.select(joint);
        found |= joint.is_some();
    }
    // Nothing is known of a file that cannot be read.
    let first = gallery.apps().iter().find(|app| app.unreadable().is_empty());
    let (Some(app), false) = (first, found) else { return Ok(()) };
    let joints = app.stage().motion().skeleton().joints().iter().filter(|joint| !joint.is_end_site);
    let names: Vec<&str> = joints.map(|joint| joint.name.as_str()).collect();
    let (name, names) = (parser::printable(name), parser::printable(&names.join(", ")));
    Err(format!("there is no joint {name:?}: {} has {names}", app.title()))
}

fn keys_for_terminal() -> String {
    let rows: String = keys::help().map(|(name, help)| format!("  {name:<10} {help}\n")).collect();
    format!("Keys in the window:\n{rows}")
}

impl From<Positions> for PositionChannels {
    fn from(positions: Positions) -> PositionChannels {
        match positions {
            Positions::Replace => PositionChannels::Replace,
            Positions::Add => PositionChannels::Add,
        }
    }
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::*;

    #[test]
    fn the_command_line_is_well_formed_and_its_help_names_every_key() {
        Arguments::command().debug_assert();
        let help = Arguments::command().render_long_help().to_string();
        for (name, text) in keys::help() {
            assert!(help.contains(name) && help.contains(text), "{text}");
        }
    }

    #[test]
    fn an_exercise_is_chosen_by_its_name_and_a_wrong_name_is_told_with_those_that_there_are() {
        let parse = |words: &[&str]| Arguments::try_parse_from(["cargo view"].iter().chain(words));
        let first = |words: &[&str]| parse(words).unwrap().sources(Path::new("")).unwrap().remove(0).path;
        assert_eq!(parse(&[]).unwrap().exercise, Package::Fk);
        assert_eq!(parse(&["--exercise", "keyframes", "--solution"]).unwrap().exercise, Package::Keyframes);
        assert!(first(&["--exercise", "interpolation"]).ends_with("dance.bvh"));
        assert!(first(&["--exercise", "keyframes"]).ends_with("running.bvh"));
        assert!(first(&["--exercise", "acclaim", "a.amc", "a.asf"]).ends_with("a.amc"));
        assert!(first(&["--exercise", "interpolation", "a.bvh"]).ends_with("a.bvh"));
        let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        let bones = parse(&["--exercise", "acclaim"]).unwrap().sources(&workspace).unwrap().remove(0);
        assert!(bones.path.ends_with("data/walk.amc") && bones.skeleton.unwrap().ends_with("data/walk.asf"));
        let error = parse(&["--exercise", "interpolate"]).unwrap_err().to_string();
        let names = Package::value_variants().iter().map(|package| package.name());
        for name in names.chain(["'interpolate'"]) {
            assert!(error.contains(name), "{error}");
        }
    }

    #[test]
    fn things_are_shown_and_hidden_by_name() {
        let settings = |words: &[&str]| {
            let words = ["cargo view"].iter().chain(words);
            Arguments::try_parse_from(words).unwrap().settings()
        };
        assert_eq!(settings(&[]), Settings::default());
        let changed = settings(&["--hide", "ghost,axes", "--show", "help", "--lines", "--scale", "2"]);
        let expected = Settings {
            ghost: false,
            axes: false,
            help: true,
            style: Style::Lines,
            text_scale: 2.0,
            ..Settings::default()
        };
        assert_eq!(changed, expected);
        assert!(Arguments::try_parse_from(["cargo view", "--scale", "9"]).is_err());
        assert!(Arguments::try_parse_from(["cargo view", "--png", "a.png", "--gif", "a.gif"]).is_err());
    }
}
