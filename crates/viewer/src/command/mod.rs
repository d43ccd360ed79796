//! The command `cargo view`.

mod arguments;
mod bar;
mod convert;
mod edited;
mod files;
mod headless;
mod keyframes;
mod print;
mod targets;
mod values;
mod warp;

use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::error::ErrorKind;
use clap::{CommandFactory, Parser};

use crate::live::mover::Mover;
use crate::live::worker::Trouble;
use crate::motion::source::{self, Source};
use crate::output::beside;
use crate::view::app::App;
use crate::view::gallery::Gallery;
use crate::view::session::Session;
use crate::window;

pub use arguments::Arguments;
use arguments::Output;

/// Does what the command line asks for, and gives the exit code: 0 when it was done, 1 when not, 2 for a command
/// line that cannot be understood.
pub fn run() -> ExitCode {
    let arguments = Arguments::parse();
    if let Err(why) = convert::check(&arguments) {
        Arguments::command().error(ErrorKind::ArgumentConflict, why).exit();
    }
    match view(&arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

fn view(arguments: &Arguments) -> Result<(), String> {
    let sources = arguments.sources(&workspace())?;
    let pictures = arguments.output();
    for target in pictures.iter().map(Output::target).chain(arguments.new_files()) {
        targets::check(target, &sources)?;
    }
    if arguments.print {
        let mut before = None;
        for source in &sources {
            let loaded = source.read_behind(before.as_ref()).map_err(text)?;
            say(&print::report(source, &loaded))?;
            before = Some(loaded.stage);
        }
        return Ok(());
    }
    if arguments.exercise.mover().is_some_and(Mover::needs_bones) && arguments.new_files().is_empty() {
        files::check_bones(&sources)?;
    }
    if let Some(output) = pictures {
        leave_nothing_behind();
        return headless::write(arguments, &output, &sources);
    }
    if !arguments.new_files().is_empty() {
        leave_nothing_behind();
        return convert::write(arguments, &sources);
    }

    let mut apps = Vec::new();
    let mut reports = String::new();
    for source in &sources {
        apps.push(open(arguments, source, sources.len(), apps.last(), &mut reports)?);
    }
    let mut gallery = Gallery::new(apps);
    arguments.prepare(&mut gallery)?;
    say(&reports)?;
    let workspace = workspace();
    let followed = (!arguments.solution).then_some((arguments.exercise, workspace.as_path()));
    let session = || Session::open(gallery, sources, followed);
    window::open(session, arguments.size()).map_err(text)
}

/// A motion as the window shows it first, and what there is to report of it. One that cannot be read is told in the terminal and
/// in the window, where it appears as soon as it can be. `before` is the motion in front of it.
fn open(
    arguments: &Arguments,
    source: &Source,
    count: usize,
    before: Option<&App>,
    reports: &mut String,
) -> Result<App, String> {
    let app = |stage, warnings| App::new(stage, source.title(), warnings, arguments.tile(count));
    let unread = |why: &str| {
        let mut app = app(source::nothing(), Vec::new());
        app.cannot_read(why);
        app
    };
    // A warped motion is made of the one in front of it. What is wrong with the file was told there.
    let before = before.filter(|_| source.warp.is_some());
    if let Some(before) = before.filter(|before| !before.unreadable().is_empty()) {
        return Ok(unread(&before.unreadable().join("\n")));
    }
    match source.read_behind(before.map(App::stage)) {
        Ok(loaded) => {
            reports.push_str(&print::report(source, &loaded));
            Ok(app(loaded.stage, loaded.warnings))
        }
        // A name without a file is most likely a slip of the hand, and so are keyframes that are not there.
        Err(error) if before.is_some() || !source.path.is_file() => Err(error.to_string()),
        Err(error) => {
            eprintln!("{error}");
            Ok(unread(&error.to_string()))
        }
    }
}

/// Sees to it that Ctrl-C takes files that are not yet whole away.
fn leave_nothing_behind() {
    let end = || {
        let _unfinished = beside::abandon();
        std::process::exit(130);
    };
    // Where the system does not let it, Ctrl-C ends the program as it ends any other.
    let _ = ctrlc::set_handler(end);
}

/// Writes to the standard output. Whoever reads there may have gone, as `head` does; that is no reason to fail.
///
/// # Errors
///
/// When it cannot be written there, as to a file on a full disk.
fn say(text: &str) -> Result<(), String> {
    let mut out = io::stdout();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(format!("what there is to say cannot be written to the standard output: {error}"))
        }
        _ => Ok(()),
    }
}

/// Says in the terminal what is wrong with the student's functions, and what a picture shows for this reason.
fn tell(trouble: &Trouble, shown: &str) {
    eprintln!("{}: {shown}", trouble.headline);
    if !trouble.is_in_terminal() {
        trouble.details.iter().for_each(|line| eprintln!("  {line}"));
    }
}

/// The folder of the workspace: that of the package when cargo runs the viewer, or that in which it was compiled.
fn workspace() -> PathBuf {
    let package = std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_else(|| env!("CARGO_MANIFEST_DIR").into());
    let package = PathBuf::from(package);
    package.ancestors().nth(2).map_or(package.clone(), Path::to_path_buf)
}

fn text(error: impl ToString) -> String {
    error.to_string()
}
