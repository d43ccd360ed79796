//! `cargo harness merge`: the shares of several machines, put together.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;
use results::RunInfo;

use crate::finish::{self, OutputArgs};
use crate::journal::{Header, Journal};
use crate::log::Log;
use crate::{Error, digest};

/// Puts the shares of `--shard` together
#[derive(Args, Clone, Debug)]
pub struct MergeArgs {
    /// The output folders of all shares
    #[arg(required = true, value_name = "DIR")]
    pub shares: Vec<PathBuf>,
    /// The folder for marks and feedback
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// What comes out
    #[command(flatten)]
    pub output: OutputArgs,
}

/// Runs the command.
///
/// # Errors
///
/// When a share or a submission is missing, is there twice, or was marked under other conditions.
pub fn run(arguments: &MergeArgs) -> Result<ExitCode, Error> {
    let journals: Vec<Journal> =
        arguments.shares.iter().map(|folder| Journal::resume(folder)).collect::<Result<_, _>>()?;
    let header = common_header(&arguments.shares, &journals)?;
    let exercise = crate::grade::exercise(&header.info.exercise).map_err(Error::Usage)?;
    let options = arguments.output.read(&header.info)?;
    let ids = all_there(&arguments.shares, &journals, &header)?;

    let out = &arguments.out;
    fs::create_dir_all(out).map_err(|error| Error::write(out, error))?;
    let merged = Journal::begin(out, header)?;
    for journal in &journals {
        for done in journal.entries()? {
            merged.append(&done?)?;
        }
    }
    merged.sync()?;
    Log::open(out)?.say(&format!("merged from {} shares", journals.len()))?;
    let summary = finish::write(out, &merged, &ids, exercise, options)?;
    print!("{}", finish::in_words(&summary, out));
    Ok(ExitCode::SUCCESS)
}

/// The conditions that all shares were marked under.
fn common_header(folders: &[PathBuf], journals: &[Journal]) -> Result<Header, Error> {
    let whole = |journal: &Journal| {
        let header = journal.header();
        Header { info: RunInfo { shard: None, ..header.info.clone() }, ..header.clone() }
    };
    let headers: Vec<Header> = journals.iter().map(whole).collect();
    let [first, rest @ ..] = &headers[..] else {
        return Err(Error::Usage("name the output folders of the shares".to_owned()));
    };
    for (other, folder) in rest.iter().zip(&folders[1..]) {
        if other != first {
            return Err(Error::Usage(format!(
                "{} was not marked like {}: submissions, exercise, seed, versions, limits and sandbox must be the same for all shares",
                folder.display(),
                folders[0].display()
            )));
        }
    }
    Ok(first.clone())
}

/// Every share is there once, and every submission too. Gives their ids.
fn all_there(folders: &[PathBuf], journals: &[Journal], header: &Header) -> Result<BTreeSet<String>, Error> {
    let mut shares: BTreeMap<u32, &PathBuf> = BTreeMap::new();
    let mut count = 0;
    for (folder, journal) in folders.iter().zip(journals) {
        let Some(shard) = journal.header().info.shard else {
            return Err(Error::Usage(format!("{} is no share: it was marked as a whole", folder.display())));
        };
        if let Some(other) = shares.insert(shard.index, folder) {
            let (one, two, number) = (other.display(), folder.display(), shard.index + 1);
            return Err(Error::Usage(format!("{one} and {two} are both share {number}")));
        }
        if count != 0 && count != shard.count {
            return Err(Error::Usage(format!(
                "{} is one of {} shares, the others are of {count}",
                folder.display(),
                shard.count
            )));
        }
        count = shard.count;
    }
    let missing: Vec<String> =
        (0..count).filter(|index| !shares.contains_key(index)).map(|index| (index + 1).to_string()).collect();
    if !missing.is_empty() {
        return Err(Error::Usage(format!("of {count} shares these are missing: {}", missing.join(", "))));
    }
    let mut ids: BTreeMap<String, &PathBuf> = BTreeMap::new();
    for (folder, journal) in folders.iter().zip(journals) {
        for id in journal.ids() {
            if let Some(other) = ids.insert(id.clone(), folder) {
                let (one, two) = (other.display(), folder.display());
                return Err(Error::Usage(format!("{id} is in {one} and in {two}")));
            }
        }
    }
    let all: Vec<&str> = ids.keys().map(String::as_str).collect();
    if all.len() != header.total || digest::of(all.join("\n").as_bytes()) != header.digest {
        return Err(Error::Usage(format!(
            "{} of {} submissions are marked: run the shares to their ends with `--resume`",
            all.len(),
            header.total
        )));
    }
    Ok(ids.into_keys().collect())
}
