//! `cargo grade`: a folder of submissions in, marks and feedback out.

use std::collections::hash_map::RandomState;
use std::fs;
use std::hash::BuildHasher;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use clap::Args;
use results::Shard;
use submissions::{Batch, Entry, Loaded};

use crate::batch::{Jobs, is_harness_error};
use crate::exercise::{EXERCISES, Exercise};
use crate::finish::{self, OutputArgs};
use crate::journal::{self, Header, Journal};
use crate::limits::LimitArgs;
use crate::log::Log;
use crate::marker::{Marker, Protection};
use crate::progress::Progress;
use crate::{Ended, Error, digest, orphans, workspace};

/// Marks a folder of submissions, or a zip of it
#[derive(Args, Clone, Debug)]
pub struct GradeArgs {
    /// A folder with `300000001_TerryFox.zip` and the like, `.rs` files or folders; or a zip of it, as Canvas and
    /// Moodle export it
    pub submissions: PathBuf,
    /// The folder for marks and feedback
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// The exercise
    #[arg(long, default_value = "fk", value_parser = exercise)]
    pub exercise: &'static Exercise,
    /// The seed of the questions. Without it, a new secret one is drawn and written down
    #[arg(long)]
    pub seed: Option<u64>,
    /// How many submissions are marked at the same time [default: one for each processor]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub jobs: Option<u32>,
    /// Go on with a run that was stopped, or write its results again
    #[arg(long)]
    pub resume: bool,
    /// Mark only this submission, again if need be (its id in grades.csv); can be given several times
    #[arg(long, value_name = "ID")]
    pub only: Vec<String>,
    /// Mark share K of N, for several machines; `cargo harness merge` puts the shares together
    #[arg(long, value_name = "K/N", value_parser = shard)]
    pub shard: Option<Shard>,
    /// Mark without protection where this machine offers none. Only for files that you trust
    #[arg(long)]
    pub unsandboxed: bool,
    /// Also write every source into `sources/ID/`, for a tool that looks for copies, such as JPlag
    #[arg(long, conflicts_with = "anonymous")]
    pub sources: bool,
    /// What comes out
    #[command(flatten)]
    pub output: OutputArgs,
    /// What each submission may use
    #[command(flatten)]
    pub limits: LimitArgs,
}

pub(crate) fn exercise(name: &str) -> Result<&'static Exercise, String> {
    let names = || EXERCISES.iter().map(|exercise| exercise.name()).collect::<Vec<_>>().join(", ");
    Exercise::named(name).ok_or_else(|| format!("there is {}", names()))
}

fn shard(text: &str) -> Result<Shard, String> {
    let numbers = text.split_once('/').and_then(|(k, n)| Some((k.parse().ok()?, n.parse().ok()?)));
    match numbers {
        Some((k @ 1.., n)) if k <= n => Ok(Shard { index: k - 1, count: n }),
        _ => Err("write 1/4 for the first of four shares".to_owned()),
    }
}

/// Runs the command. `stop` is set when the user wants to stop.
///
/// # Errors
///
/// When something around the submissions fails. What is marked by then is kept.
pub fn run(arguments: &GradeArgs, stop: &Arc<AtomicBool>) -> Result<Ended, Error> {
    orphans::adopt();
    let batch = Batch::open(&arguments.submissions, &arguments.exercise.wanted())?;
    let out = &arguments.out;
    fs::create_dir_all(out).map_err(|error| Error::write(out, error))?;
    // Relative paths mean nothing in a sandbox.
    let out = &out.canonicalize().map_err(|error| Error::read(out, error))?;

    let earlier = if arguments.resume || !arguments.only.is_empty() && out.join(journal::FILE).exists() {
        Some(Journal::resume(out)?)
    } else if out.join(journal::FILE).exists() {
        return Err(Error::RunExists(out.clone()));
    } else {
        None
    };
    let seed = match (arguments.seed, &earlier) {
        (Some(seed), _) => seed,
        (None, Some(journal)) => journal.header().info.seed,
        (None, None) => RandomState::new().hash_one(0),
    };
    let scratch = Scratch::new(out)?;
    let protection = if arguments.unsandboxed { Protection::None } else { Protection::Strongest };
    eprintln!("Making ready: the libraries that submissions are compiled with.");
    let limits = arguments.limits.clone();
    let marker =
        Marker::new(&workspace::find()?, arguments.exercise, seed, limits, protection, scratch.path())?;
    let header = header(&marker, &batch, arguments.shard);
    let options = arguments.output.read(&header.info)?;
    let mine = select(&batch, arguments)?;
    let journal = match earlier {
        Some(journal) => unchanged(journal, &header, out)?,
        None => Journal::begin(out, header)?,
    };
    let log = Log::open(out)?;
    let todo = still_to_do(&batch, &journal, &mine, arguments)?;
    log.say(&format!("{} of {} submissions to mark, {}", todo.len(), mine.len(), marker.sandbox.layers()))?;
    let progress = Progress::new(mine.len(), mine.len() - todo.len());
    let marking = marker.marking();
    let jobs = Jobs {
        batch: &batch,
        marking: &marking,
        sandbox: &journal.header().info.sandbox,
        scratch: scratch.path().to_path_buf(),
        journal: &journal,
        log: &log,
        stop,
        progress: &|record| progress.done(record),
    };
    let finished = jobs.run(&todo, arguments.jobs.unwrap_or_else(processors))?;
    progress.end();
    journal.sync()?;
    if !finished {
        log.say("stopped")?;
        return Ok(Ended::Stopped { done: journal.ids().len(), of: mine.len() });
    }
    let ids = mine.iter().map(|entry| entry.id.clone()).collect();
    let summary = finish::write(out, &journal, &ids, marker.exercise, options)?;
    if arguments.sources {
        write_sources(&out.join("sources"), &batch, &mine, arguments.exercise)?;
    }
    log.say("results written")?;
    Ok(Ended::Done(summary))
}

fn write_sources(folder: &Path, batch: &Batch, entries: &[&Entry], exercise: &Exercise) -> Result<(), Error> {
    for entry in entries {
        if let Loaded::Source(source) = batch.load(entry) {
            let folder = folder.join(&entry.id);
            fs::create_dir_all(&folder).map_err(|error| Error::write(&folder, error))?;
            let path = folder.join(exercise.file());
            fs::write(&path, source.text).map_err(|error| Error::write(&path, error))?;
        }
    }
    Ok(())
}

fn processors() -> u32 {
    std::thread::available_parallelism().map_or(1, |count| u32::try_from(count.get()).unwrap_or(1))
}

fn header(marker: &Marker, batch: &Batch, shard: Option<Shard>) -> Header {
    let ids: Vec<&str> = batch.entries().iter().map(|entry| entry.id.as_str()).collect();
    Header { info: marker.info(shard), total: ids.len(), digest: digest::of(ids.join("\n").as_bytes()) }
}

/// A run goes on only under the conditions that it was begun with: otherwise its marks would not be comparable.
fn unchanged(journal: Journal, now: &Header, out: &Path) -> Result<Journal, Error> {
    let (then, info) = (&journal.header().info, &now.info);
    let differences = [
        (then.exercise != info.exercise || then.parts != info.parts, "exercise or other points"),
        (then.seed != info.seed, "seed"),
        (then.versions != info.versions, "version of fk-lab or of the compiler"),
        (then.limits != info.limits, "set of limits"),
        (then.sandbox != info.sandbox, "sandbox"),
        (then.shard != info.shard, "shard"),
    ];
    match differences.into_iter().find(|(differs, _)| *differs) {
        Some((_, what)) => Err(Error::Changed { folder: out.to_path_buf(), what }),
        None => Ok(journal),
    }
}

/// The submissions that this run is about.
fn select<'a>(batch: &'a Batch, arguments: &GradeArgs) -> Result<Vec<&'a Entry>, Error> {
    let entries = batch.entries();
    if let Some(unknown) = arguments.only.iter().find(|id| entries.iter().all(|entry| entry.id != **id)) {
        let path = arguments.submissions.display();
        return Err(Error::Usage(format!(
            "no submission in {path} has the id {unknown}: ids stand in the first column of grades.csv"
        )));
    }
    let share = |index: usize| match arguments.shard {
        Some(Shard { index: mine, count }) => index % count as usize == mine as usize,
        None => true,
    };
    Ok(entries.iter().enumerate().filter(|(index, _)| share(*index)).map(|(_, entry)| entry).collect())
}

/// What is not marked yet, was changed since, could not be marked, or is asked for by name.
fn still_to_do<'a>(
    batch: &Batch,
    journal: &Journal,
    mine: &[&'a Entry],
    arguments: &GradeArgs,
) -> Result<Vec<&'a Entry>, Error> {
    let mut todo = Vec::new();
    for entry in mine {
        let wanted = if arguments.only.is_empty() {
            match journal.get(&entry.id)? {
                None => true,
                Some(done) if is_harness_error(&done.record.verdict) => true,
                Some(done) => done.record.sha256 != sha256(&batch.load(entry)),
            }
        } else {
            arguments.only.contains(&entry.id)
        };
        if wanted {
            todo.push(*entry);
        }
    }
    Ok(todo)
}

fn sha256(loaded: &Loaded) -> Option<String> {
    match loaded {
        Loaded::Source(source) => Some(source.sha256.clone()),
        Loaded::Rejected(rejection) => rejection.sha256.clone(),
    }
}

/// A folder inside the output folder, gone with the run. What a killed run has left goes with the next.
pub struct Scratch(PathBuf);

impl Scratch {
    /// Makes it anew.
    ///
    /// # Errors
    ///
    /// When the folder cannot be written.
    pub fn new(out: &Path) -> Result<Scratch, Error> {
        let folder = out.join(".scratch");
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir(&folder).map_err(|error| Error::write(&folder, error))?;
        Ok(Scratch(folder))
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.0
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// Sets `stop` at the first Ctrl-C, and ends the program at the second.
///
/// # Errors
///
/// When the system does not let it.
pub fn stop_on_ctrl_c() -> Result<Arc<AtomicBool>, Error> {
    let stop = Arc::new(AtomicBool::new(false));
    let flag = Arc::clone(&stop);
    let handler = move || {
        if flag.swap(true, Ordering::SeqCst) {
            std::process::exit(130);
        }
        eprintln!("\nStopping after the submissions that are being marked. Ctrl-C again stops at once.");
    };
    ctrlc::set_handler(handler).map_err(|error| Error::Usage(error.to_string()))?;
    Ok(stop)
}
