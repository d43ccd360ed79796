//! `cargo submit`: the student's end.

use std::fs;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;
use grading::PUBLIC_SEED;
use grading::scoreboard::Scoreboard;
use results::Verdict;
use submissions::Loaded;

use crate::compile::Compiled;
use crate::exercise::Exercise;
use crate::grade::{Scratch, exercise};
use crate::limits::LimitArgs;
use crate::marker::{Marker, Protection};
use crate::{Error, whole_file, workspace};

/// Packs your file for handing in, and checks it as it will be marked
#[derive(Args, Clone, Debug)]
pub struct SubmitArgs {
    /// Your student number
    pub number: String,
    /// Your name, in one or more words
    #[arg(required = true)]
    pub name: Vec<String>,
    /// The exercise
    #[arg(long, default_value = "fk", value_parser = exercise)]
    pub exercise: &'static Exercise,
    /// The folder that the archive is written to
    #[arg(long, value_name = "DIR", default_value = ".")]
    pub out: PathBuf,
    /// What the check may use
    #[command(flatten)]
    pub limits: LimitArgs,
}

/// Runs the command. The archive is written even when the file does not compile: a deadline may be near.
///
/// # Errors
///
/// When the archive cannot be made, or the check cannot be run.
pub fn run(arguments: &SubmitArgs) -> Result<ExitCode, Error> {
    let workspace = workspace::find()?;
    let path = workspace.join(arguments.exercise.path());
    let bytes = fs::read(&path).map_err(|error| Error::read(&path, error))?;
    let name = arguments.name.join(" ");
    let wanted = arguments.exercise.wanted();
    let packed = submissions::write_zip(&arguments.number, &name, &bytes, &wanted)?;
    let archive = arguments.out.join(&packed.file_name);
    // All exercises have archives of the same name.
    if fs::read(&archive).is_ok_and(|bytes| !names(&bytes, &wanted.file_name)) {
        return Err(Error::Usage(format!(
            "{} is there already and holds no {}: move it away, or choose another folder with --out DIR.",
            archive.display(),
            arguments.exercise.file()
        )));
    }
    whole_file::write(&archive, &packed.bytes)?;
    println!("Written: {}", archive.display());

    // What is checked is what was written, as the harness will read it.
    let (_, loaded) = submissions::read_one(&archive, &wanted);
    let source = match loaded {
        Loaded::Source(source) => source,
        Loaded::Rejected(rejection) => {
            println!("It would not be accepted: {}", rejection.why);
            return Ok(ExitCode::FAILURE);
        }
    };
    for remark in &source.remarks {
        println!("{remark}");
    }
    println!("Checking it as it will be marked. The first time, this takes a while.");
    check(arguments, &source.text)
}

/// Whether a zip archive has a file of this name: names are not compressed in it.
fn names(archive: &[u8], file_name: &str) -> bool {
    archive.windows(file_name.len()).any(|bytes| bytes == file_name.as_bytes())
}

fn check(arguments: &SubmitArgs, source: &str) -> Result<ExitCode, Error> {
    let workspace = workspace::find()?;
    let target = workspace::target(&workspace).join("submit");
    fs::create_dir_all(&target).map_err(|error| Error::write(&target, error))?;
    let target = target.canonicalize().map_err(|error| Error::read(&target, error))?;
    let scratch = Scratch::new(&target)?;
    let marker = |protection| {
        let limits = arguments.limits.clone();
        Marker::new(&workspace, arguments.exercise, PUBLIC_SEED, limits, protection, scratch.path())
    };
    // It is the student's own file on the student's own machine: protection is welcome, but not needed.
    let marker = match marker(Protection::Strongest) {
        Err(Error::Sandbox(_)) => marker(Protection::None)?,
        other => other?,
    };
    let marking = marker.marking();
    let folder = scratch.path().join("0");
    let (compiled, _) = marking.compiler.compile(0, &folder, source).map_err(|e| Error::write(&folder, e))?;
    match compiled {
        Compiled::Worker(worker) => {
            let marked = marking.examiner.mark(0, &worker, std::io::stdout());
            let marked = marked.map_err(|trouble| Error::Usage(trouble.to_string()))?;
            let board = Scoreboard {
                rubric: arguments.exercise.rubric(),
                parts: &marked.parts,
                whole: Some(&marked.whole),
            };
            anstream::print!("{board}");
            println!(
                "These are the questions that you know. Your marks are made with others of the same kind."
            );
            Ok(ExitCode::SUCCESS)
        }
        Compiled::Not(verdict) => {
            explain(&verdict);
            Ok(ExitCode::FAILURE)
        }
    }
}

fn explain(verdict: &Verdict) {
    match verdict {
        Verdict::DoesNotCompile { errors, .. } => {
            for error in errors {
                println!("\n{}", error.text);
            }
            println!("It does not compile, so it would get no points. Mend it and submit again.");
        }
        Verdict::TooExpensiveToCompile { text, .. } => println!("It would get no points: {text}"),
        _ => {}
    }
}
