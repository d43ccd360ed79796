//! The command `cargo view`.

use std::fmt::Display;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Arc;

use clap::{Parser, ValueEnum};
use exam::fk::PosedFrame;
use parser::bvh;
use skeleton::PositionChannels;

use crate::app::{App, Shown};
use crate::canvas::{Canvas, MAX_SIDE};
use crate::draw::Painter;
use crate::live::Live;
use crate::stage::Stage;
use crate::student::{self, Status, Version};
use crate::worker::Trouble;
use crate::{keys, picture, print, window, worker};

/// Shows a motion moved by YOUR functions in exercises/fk/src/fk.rs, with the right answer beside it as a ghost.
#[derive(Debug, Parser)]
#[command(name = "cargo view", bin_name = "cargo view", after_help = keys_for_terminal())]
pub struct Arguments {
    /// The motion, a .bvh file [default: data/running.bvh]
    file: Option<PathBuf>,

    /// Shows the reference solution's figure instead of yours
    #[arg(long)]
    solution: bool,

    /// Prints the skeleton and what is in the file, and opens no window
    #[arg(long, conflicts_with = "png")]
    print: bool,

    /// Writes a picture of one frame, and opens no window: works without a display
    #[arg(long, value_name = "PICTURE")]
    png: Option<PathBuf>,

    /// The frame to begin with, or for the picture: counted from 0
    #[arg(long, value_name = "N", default_value_t = 0)]
    frame: usize,

    /// Width and height of the window or the picture, in pixels
    #[arg(long, value_name = "WxH", default_value = "1280x720", value_parser = parse_size)]
    size: (usize, usize),

    /// What a position channel does to the joint's OFFSET
    #[arg(long, value_enum, default_value_t = Positions::Replace)]
    positions: Positions,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Positions {
    /// It takes its place: what most files mean
    Replace,
    /// It is added to it: what a few programs do
    Add,
}

/// Does what the command line asks for, and gives the exit code: 0 when it was done, 1 when not, 2 for a command
/// line that cannot be understood.
pub fn run() -> ExitCode {
    let arguments = Arguments::parse();
    match view(&arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

fn view(arguments: &Arguments) -> Result<(), String> {
    let path = arguments.file.clone().unwrap_or_else(|| workspace().join("data").join("running.bvh"));
    if let Some(picture) = &arguments.png {
        check_target(picture, &path)?;
    }
    let bvh::Reading { motion, warnings } = bvh::read_file(&path).map_err(text)?;
    let title = parser::printable(&path.file_name().unwrap_or(path.as_os_str()).to_string_lossy());
    let warnings: Vec<String> = warnings.iter().map(text).collect();

    if !arguments.print {
        check_frame(arguments.frame, &title, motion.frame_count())?;
    }
    if let Some(picture) = &arguments.png {
        let stage = Arc::new(Stage::new(motion, arguments.positions.into()));
        return write_picture(arguments, stage, title, warnings, picture);
    }
    say(&report(&title, &motion, &warnings));
    if arguments.print {
        return Ok(());
    }
    let stage = Arc::new(Stage::new(motion, arguments.positions.into()));
    let mut app = App::new(stage.clone(), title, warnings, arguments.size);
    app.go_to(arguments.frame);
    let live = || Live::open(&workspace(), vec![stage], vec![path]);
    window::open(app, arguments.size, (!arguments.solution).then_some(live)).map_err(text)
}

/// What is printed of a motion: its name, its skeleton, a summary, and what is odd about the file.
fn report(title: &str, motion: &skeleton::Motion, warnings: &[String]) -> String {
    let warnings = match warnings {
        [] => "warnings         none\n".to_owned(),
        some => some.iter().map(|warning| format!("warning          {warning}\n")).collect(),
    };
    format!("{title}\n\n{}\n{}{warnings}", print::tree(motion.skeleton()), print::summary(motion))
}

/// Sees to it that no motion is lost because its name stands where the picture's belongs.
fn check_target(picture: &Path, motion: &Path) -> Result<(), String> {
    let ends_in = |ending: &str| picture.extension().is_some_and(|own| own.eq_ignore_ascii_case(ending));
    if ends_in("bvh") {
        let name = picture.file_name().unwrap_or_default().display();
        let path = picture.display().to_string();
        let quote = if path.contains(' ') { "\"" } else { "" };
        return Err(format!(
            "--png names the picture to write; to show {name}: cargo view {quote}{path}{quote} --png picture.png"
        ));
    }
    if !ends_in("png") {
        return Err(format!(
            "--png names the picture to write, and that name ends in .png: {} does not",
            picture.display()
        ));
    }
    // Neither can be found when it does not exist; then there is nothing to lose.
    if let (Ok(target), Ok(motion)) = (picture.canonicalize(), motion.canonicalize())
        && target == motion
    {
        return Err(format!("{} is the motion: the picture needs a name of its own", picture.display()));
    }
    Ok(())
}

fn check_frame(frame: usize, title: &str, count: usize) -> Result<(), String> {
    let why = match count {
        _ if frame < count.max(1) => return Ok(()),
        0 => "it has no frames; its rest pose is frame 0".to_owned(),
        1 => "it has one frame, frame 0".to_owned(),
        _ => format!("its frames are counted from 0 to {}", count - 1),
    };
    Err(format!("{title} has no frame {frame}: {why}"))
}

fn write_picture(
    arguments: &Arguments,
    stage: Arc<Stage>,
    title: String,
    warnings: Vec<String>,
    path: &Path,
) -> Result<(), String> {
    let frame = arguments.frame;
    let mut app = App::new(stage.clone(), title, warnings, arguments.size);
    app.go_to(frame);

    let answer = match arguments.solution {
        true => None,
        false => Some(ask_student(&stage, frame)),
    };
    let status = match &answer {
        Some(Err(trouble)) => Status::Failed(trouble.clone().into()),
        _ => Status::Answered,
    };
    let shown = match &answer {
        None => Shown::Reference,
        Some(answer) => Shown::Student { posed: answer.as_ref().ok(), status: &status },
    };
    let mut canvas = Canvas::new(arguments.size.0, arguments.size.1);
    Painter::new().draw(&app.scene(shown, canvas.size()), &mut canvas);
    if let Status::Failed(trouble) = &status {
        eprintln!("{}: the picture shows only the goal", trouble.headline);
    }
    picture::save(&canvas, path)
        .map_err(|error| format!("the picture cannot be written to {}: {error}", path.display()))?;
    say(&format!("{}: frame {frame}, {} x {} pixels\n", path.display(), canvas.size().0, canvas.size().1));
    Ok(())
}

/// What the student's functions make of one frame. Waits for it.
fn ask_student(stage: &Stage, frame: usize) -> Result<PosedFrame, Trouble> {
    let mut worker = worker::compile(&workspace(), &Version::default())?;
    let mut answer = student::ask(&mut worker, stage, frame..frame + 1)?;
    // One frame was asked for, and one came: `ask` sees to that.
    Ok(answer.swap_remove(0))
}

/// Writes to the standard output. Whoever reads there may have gone, as `head` does; that is no reason to fail.
fn say(text: &str) {
    let _ = io::stdout().write_all(text.as_bytes());
}

/// The folder of the workspace: that of the package when cargo runs the viewer, or that in which it was compiled.
fn workspace() -> PathBuf {
    let package = std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_else(|| env!("CARGO_MANIFEST_DIR").into());
    let package = PathBuf::from(package);
    package.ancestors().nth(2).map_or(package.clone(), Path::to_path_buf)
}

fn parse_size(text: &str) -> Result<(usize, usize), String> {
    let side = |side: &str| side.parse::<usize>().ok().filter(|side| (16..=MAX_SIDE).contains(side));
    let (width, height) = text.split_once(['x', 'X']).unwrap_or((text, ""));
    side(width).zip(side(height)).ok_or_else(|| {
        format!("write two numbers from 16 to {MAX_SIDE} with an x between them, for example 1280x720")
    })
}

fn keys_for_terminal() -> String {
    let rows: String = keys::help().map(|(name, help)| format!("  {name:<8} {help}\n")).collect();
    format!("Keys in the window:\n{rows}")
}

fn text(error: impl Display) -> String {
    error.to_string()
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
        for binding in keys::BINDINGS {
            assert!(help.contains(binding.help), "{}", binding.help);
        }
    }

    #[test]
    fn a_frame_that_does_not_exist_is_told_with_those_that_do() {
        assert_eq!(check_frame(1376, "a", 1377), Ok(()));
        assert_eq!(check_frame(0, "a", 0), Ok(()));
        for (count, why) in [
            (0, "it has no frames; its rest pose is frame 0"),
            (1, "it has one frame, frame 0"),
            (7, "its frames are counted from 0 to 6"),
        ] {
            assert_eq!(check_frame(7, "a", count), Err(format!("a has no frame 7: {why}")));
        }
    }

    #[test]
    fn a_size_is_two_numbers_with_an_x() {
        assert_eq!(parse_size("640x480"), Ok((640, 480)));
        for wrong in ["640", "640x", "x480", "15x400", "640x99999999999999999999", "-640x480", "640×480", ""]
        {
            assert!(parse_size(wrong).is_err(), "{wrong}");
        }
    }
}
