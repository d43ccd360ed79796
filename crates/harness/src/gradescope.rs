//! `cargo harness gradescope`: the autograder for Gradescope, and what runs inside it.

use std::collections::hash_map::RandomState;
use std::fs;
use std::hash::BuildHasher;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;
use flate2::Compression;
use flate2::write::DeflateEncoder;
use rawzip::{CompressionMethod, ZipArchiveWriter};
use results::Record;
use submissions::Loaded;

use crate::batch::{self, Marking};
use crate::exercise::Exercise;
use crate::grade::{Scratch, exercise};
use crate::limits::LimitArgs;
use crate::marker::{Marker, Protection};
use crate::{Error, whole_file, workspace};

/// Builds the autograder archive for Gradescope; inside it, marks one submission
#[derive(Args, Clone, Debug)]
pub struct GradescopeArgs {
    /// The archive that is written
    #[arg(long, value_name = "FILE", default_value = "autograder.zip")]
    pub out: PathBuf,
    /// The exercise
    #[arg(long, default_value = "fk", value_parser = exercise)]
    pub exercise: &'static Exercise,
    /// The seed of the questions. Without it, a new secret one is drawn and put into the archive
    #[arg(long)]
    pub seed: Option<u64>,
    /// Mark without protection where Gradescope's machine offers none
    #[arg(long)]
    pub unsandboxed: bool,
    /// Mark what lies in this folder, as the archive does on Gradescope's machine
    #[arg(long, value_name = "DIR", requires = "results")]
    pub submission: Option<PathBuf>,
    /// Write the result to this file
    #[arg(long, value_name = "FILE", requires = "submission")]
    pub results: Option<PathBuf>,
    /// What the submission may use
    #[command(flatten)]
    pub limits: LimitArgs,
}

/// Runs the command.
///
/// # Errors
///
/// When a file cannot be written, or the submission cannot be marked for a reason that is not its own.
pub fn run(arguments: &GradescopeArgs) -> Result<ExitCode, Error> {
    match (&arguments.submission, &arguments.results) {
        (Some(submission), Some(results)) => {
            // Without a result, Gradescope tells the instructor that the autograder failed, and gives no points.
            let result = mark(arguments, submission)?;
            let text = serde_json::to_vec_pretty(&result).map_err(|e| Error::write(results, e.into()))?;
            whole_file::write(results, &text)?;
        }
        _ => {
            bundle(arguments)?;
            println!(
                "Written: {}. It holds the solutions and the seed: keep it to yourself.",
                arguments.out.display()
            );
            println!("Upload it to Gradescope: Configure Autograder, Select Autograder (.zip).");
        }
    }
    Ok(ExitCode::SUCCESS)
}

fn mark(arguments: &GradescopeArgs, submission: &Path) -> Result<serde_json::Value, Error> {
    let workspace = workspace::find()?;
    let target = workspace::target(&workspace);
    fs::create_dir_all(&target).map_err(|error| Error::write(&target, error))?;
    let scratch = Scratch::new(&target.canonicalize().map_err(|error| Error::read(&target, error))?)?;
    let protection = if arguments.unsandboxed { Protection::None } else { Protection::Strongest };
    let seed = arguments.seed.ok_or_else(|| Error::Usage("give the seed by --seed".to_owned()))?;
    let limits = arguments.limits.clone();
    let marker = Marker::new(&workspace, arguments.exercise, seed, limits, protection, scratch.path())?;

    let info = marker.info(None);
    let (entry, loaded) = submissions::read_one(submission, &arguments.exercise.wanted());
    let record: Record = match loaded {
        Loaded::Source(source) => {
            let outcome = marker.marking().mark(0, &scratch.path().join("0"), &source.text);
            batch::record(&entry, Some(source.sha256), source.remarks, &info.sandbox, outcome.verdict)
        }
        Loaded::Rejected(rejection) => batch::rejected(&entry, rejection, &info.sandbox),
    };
    Ok(results::gradescope(&info, &record))
}

/// What the harness is built from.
const SOURCES: [&str; 7] = ["Cargo.toml", "Cargo.lock", ".cargo", "crates", "exercises", "solutions", "data"];

const SETUP: &str = "#!/usr/bin/env bash
# Runs once, when Gradescope builds the autograder's image.
set -euo pipefail
apt-get update
apt-get install -y --no-install-recommends build-essential ca-certificates curl
curl -sSf https://sh.rustup.rs | sh -s -- -y --profile minimal
. \"$HOME/.cargo/env\"
cd /autograder/source
chmod 700 .
cargo build --release --locked --package harness
# Builds the libraries that submissions are compiled with, and shows what protects the results.
cargo run --release --locked --package harness -- doctor || true
";

fn run_autograder(arguments: &GradescopeArgs) -> String {
    let seed = arguments.seed.unwrap_or_else(|| RandomState::new().hash_one(0));
    let unsandboxed = if arguments.unsandboxed { " --unsandboxed" } else { "" };
    let exercise = arguments.exercise.name();
    format!(
        "#!/usr/bin/env bash
# Runs for every submission.
. \"$HOME/.cargo/env\"
cd /autograder/source
exec cargo run --release --locked --offline --quiet --package harness -- gradescope \\
  --exercise {exercise} --seed {seed}{unsandboxed} \\
  --submission /autograder/submission --results /autograder/results/results.json
"
    )
}

fn bundle(arguments: &GradescopeArgs) -> Result<(), Error> {
    let workspace = workspace::find()?;
    let mut files = Vec::new();
    for source in SOURCES {
        collect(&workspace, Path::new(source), &mut files)?;
    }
    files.sort();
    let mut archive = ZipArchiveWriter::new(Vec::new());
    let trouble = |error: io::Error| Error::write(&arguments.out, error);
    add(&mut archive, "setup.sh", SETUP.as_bytes(), 0o100_755).map_err(trouble)?;
    add(&mut archive, "run_autograder", run_autograder(arguments).as_bytes(), 0o100_755).map_err(trouble)?;
    for file in files {
        let path = workspace.join(&file);
        let bytes = fs::read(&path).map_err(|error| Error::read(&path, error))?;
        let name = file.to_string_lossy().replace('\\', "/");
        add(&mut archive, &name, &bytes, 0o100_644).map_err(trouble)?;
    }
    let bytes = archive.finish().map_err(|error| trouble(io::Error::other(error)))?;
    whole_file::write(&arguments.out, &bytes)
}

fn add(archive: &mut ZipArchiveWriter<Vec<u8>>, name: &str, bytes: &[u8], mode: u32) -> io::Result<()> {
    let file = archive.new_file(name).compression_method(CompressionMethod::DEFLATE).unix_permissions(mode);
    let (mut entry, config) = file.start().map_err(io::Error::other)?;
    let mut writer = config.wrap(DeflateEncoder::new(&mut entry, Compression::default()));
    writer.write_all(bytes)?;
    let (encoder, descriptor) = writer.finish().map_err(io::Error::other)?;
    encoder.finish()?;
    entry.finish(descriptor).map_err(io::Error::other)?;
    Ok(())
}

/// The files below `name`, but for what was built.
fn collect(root: &Path, name: &Path, files: &mut Vec<PathBuf>) -> Result<(), Error> {
    let path = root.join(name);
    let skip = ["target"];
    if path.is_dir() {
        if name.file_name().is_some_and(|last| skip.iter().any(|skip| last == *skip)) {
            return Ok(());
        }
        for entry in fs::read_dir(&path).map_err(|error| Error::read(&path, error))? {
            let entry = entry.map_err(|error| Error::read(&path, error))?;
            collect(root, &name.join(entry.file_name()), files)?;
        }
    } else if path.exists() {
        files.push(name.to_path_buf());
    }
    Ok(())
}
