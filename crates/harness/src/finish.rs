//! From the journal to every file that comes out.

use std::collections::BTreeSet;
use std::fmt::Write;
use std::io;
use std::path::{Path, PathBuf};

use clap::Args;
use results::{
    Gradebook, Group, LateList, LatePolicy, Options, Overrides, Percent, Record, Roster, RunInfo, Summary,
};
use submissions::similar::{self, Fingerprint, Likeness};

use crate::exercise::Exercise;
use crate::journal::{Done, Journal};
use crate::{Error, whole_file};

/// What comes out, and what is taken into account.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Results")]
pub struct OutputArgs {
    /// A table of all students (number, name): who handed in nothing gets a row, too
    #[arg(long, value_name = "CSV")]
    pub roster: Option<PathBuf>,
    /// A table of days late (number, days)
    #[arg(long, value_name = "CSV")]
    pub late: Option<PathBuf>,
    /// What each day late takes off, in percent
    #[arg(long, value_name = "PERCENT", default_value = "10")]
    pub late_percent: Percent,
    /// What lateness takes off at most, in percent
    #[arg(long, value_name = "PERCENT", default_value = "50")]
    pub late_cap: Percent,
    /// A table of corrections (student, check, points, reason), applied on top and shown as such
    #[arg(long, value_name = "CSV")]
    pub overrides: Option<PathBuf>,
    /// Write into the folder `anonymous`, with names and numbers replaced everywhere but in key.csv
    #[arg(long)]
    pub anonymous: bool,
    /// A gradebook exported from Canvas, to be filled in
    #[arg(long, value_name = "CSV")]
    pub canvas: Option<PathBuf>,
    /// The column of Canvas's gradebook, or its beginning, where it is not clear
    #[arg(long, value_name = "TITLE", requires = "canvas")]
    pub canvas_column: Option<String>,
    /// A grading worksheet or gradebook exported from Moodle, to be filled in
    #[arg(long, value_name = "CSV")]
    pub moodle: Option<PathBuf>,
    /// The column of Moodle's table, or its beginning, where it is not clear
    #[arg(long, value_name = "TITLE", requires = "moodle")]
    pub moodle_column: Option<String>,
}

impl OutputArgs {
    /// Reads the tables. This is done before anything is marked: a mistyped name should not cost an evening.
    ///
    /// # Errors
    ///
    /// When one of them cannot be read.
    pub fn read(&self, info: &RunInfo) -> Result<Options, Error> {
        let policy = LatePolicy { percent_per_day: self.late_percent, cap: self.late_cap };
        let gradebook = |path: &Option<PathBuf>, column: &Option<String>| {
            path.clone().map(|path| Gradebook { path, column: column.clone() })
        };
        Ok(Options {
            roster: self.roster.as_deref().map(Roster::read).transpose()?,
            late: self.late.as_deref().map(|path| LateList::read(path, policy)).transpose()?,
            overrides: self.overrides.as_deref().map(|path| Overrides::read(path, info)).transpose()?,
            groups: Vec::new(),
            anonymous: self.anonymous,
            canvas: gradebook(&self.canvas, &self.canvas_column),
            moodle: gradebook(&self.moodle, &self.moodle_column),
        })
    }
}

/// The folder for results without names.
const ANONYMOUS: &str = "anonymous";

/// Writes everything about the submissions `ids` into `out`. Without names it goes into a folder in there: beside it the
/// journal and the log name everybody.
///
/// # Errors
///
/// When a file cannot be written. What is marked is in the journal all the same.
pub fn write(
    out: &Path,
    journal: &Journal,
    ids: &BTreeSet<String>,
    exercise: &Exercise,
    options: Options,
) -> Result<Summary, Error> {
    results::remove_leftovers(out)?;
    let mut times = "id,compile_ms,run_ms\n".to_owned();
    let mut fingerprints: Vec<(String, Fingerprint)> = Vec::new();
    for done in journal.entries()? {
        let Done { record, fingerprint, compile_ms, run_ms, .. } = done?;
        if ids.contains(&record.id) {
            // Writing to a string does not fail.
            let _ = writeln!(times, "{},{compile_ms},{run_ms}", record.id);
            if let Some(fingerprint) = fingerprint {
                fingerprints.push((record.id, fingerprint));
            }
        }
    }
    whole_file::write(&out.join("times.csv"), times.as_bytes())?;
    let options = Options { groups: groups(&fingerprints, exercise), ..options };
    let records = || -> io::Result<Box<dyn Iterator<Item = io::Result<Record>>>> {
        let entries = journal.entries().map_err(io::Error::other)?;
        let records = entries.filter_map(|done| match done {
            Ok(done) => ids.contains(&done.record.id).then_some(Ok(done.record)),
            Err(error) => Some(Err(io::Error::other(error))),
        });
        Ok(Box::new(records))
    };
    let out = if options.anonymous { &out.join(ANONYMOUS) } else { out };
    Ok(results::write_all(out, &journal.header().info, &records, &options)?)
}

fn groups(fingerprints: &[(String, Fingerprint)], exercise: &Exercise) -> Vec<Group> {
    let template = similar::fingerprint(exercise.template);
    let named: Vec<(&str, &Fingerprint)> =
        fingerprints.iter().map(|(id, fingerprint)| (id.as_str(), fingerprint)).collect();
    let groups = similar::similar(&named, &template, similar::THRESHOLD);
    let kind = |likeness| match likeness {
        Likeness::SameText => "the same but for spaces",
        Likeness::SameButNames => "the same but for names and comments",
        Likeness::Partly => "passages that few others have",
    };
    let group = |group: similar::Group| Group {
        similarity: f64::from(group.percent) / 100.0,
        kind: kind(group.likeness).to_owned(),
        ids: group.ids,
    };
    groups.into_iter().map(group).collect()
}

/// What there is to know at the end of a run, for a terminal.
pub fn in_words(summary: &Summary, out: &Path) -> String {
    let Summary { submissions, with_points, missing, attention, .. } = summary;
    let mut text = format!("{submissions} submissions, {with_points} of them marked");
    if *missing > 0 {
        text += &format!("; {missing} students handed in nothing");
    }
    text += ".\n";
    for line in attention {
        text += &format!("Look at this: {line}\n");
    }
    let folder = summary.files.first().and_then(|file| file.parent()).unwrap_or(out);
    text + &format!("Everything is in {}: begin with report.html.\n", folder.display())
}
