//! The one entry: everything that is written.

use std::path::{Path, PathBuf};

use crate::book::Book;
use crate::files::{Readers, make_folder, remove_leftovers, write_whole};
use crate::text::count;
use crate::{
    Error, Flag, Group, LateList, Overrides, Records, Roster, RunInfo, Standing, anonymous, feedback,
    gradebook, grades, json, junit, report,
};

/// What is joined with the records, and what is written.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Who is enrolled.
    pub roster: Option<Roster>,
    /// Who was late.
    pub late: Option<LateList>,
    /// What is decided otherwise than the checks.
    pub overrides: Option<Overrides>,
    /// Submissions that are alike. Ids that no record has are passed over.
    pub groups: Vec<Group>,
    /// Whether names, numbers, file names and ids are replaced by pseudonyms everywhere but in `key.csv`.
    pub anonymous: bool,
    /// A gradebook exported from Canvas.
    pub canvas: Option<Gradebook>,
    /// An offline grading worksheet or a gradebook exported from Moodle.
    pub moodle: Option<Gradebook>,
}

/// A learning platform's own table, to be filled in.
#[derive(Clone, Debug)]
pub struct Gradebook {
    /// The exported file. It is only read.
    pub path: PathBuf,
    /// The header of the column that takes the points, or its beginning; without one, it is looked for.
    pub column: Option<String>,
}

/// What was written.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Summary {
    /// How many submissions there are.
    pub submissions: usize,
    /// How many of them have points.
    pub with_points: usize,
    /// How many students on the roster handed in nothing.
    pub missing: usize,
    /// What somebody should look at, each in one line.
    pub attention: Vec<String>,
    /// The files, in the order in which they were written; the feedback as its folder.
    pub files: Vec<PathBuf>,
}

/// Writes all files into the folder `out`, which is made when it is not there.
///
/// Each file is written under another name and then gets its own, so that none is ever half written. The same input gives the same
/// bytes. Of each record only a small row stays in memory.
///
/// # Errors
///
/// When a file cannot be written, a gradebook or an override does not fit the run, or the records cannot be read. Files that were
/// finished before that stay.
pub fn write_all<'a>(
    out: &Path,
    run: &'a RunInfo,
    records: &'a Records<'a>,
    options: &Options,
) -> Result<Summary, Error> {
    let gradebooks = options.canvas.is_some() || options.moodle.is_some();
    if options.anonymous && gradebooks {
        let what =
            "a gradebook needs names, so that it cannot be filled in anonymously; leave one of the two away";
        return Err(Error::Options(what.to_owned()));
    }
    let mut book = Book::open(run, records, options)?;
    make_folder(out)?;
    remove_leftovers(out)?;
    refuse_the_other_kind(out, options.anonymous)?;
    let mut summary = Summary::default();
    let mut written = |name: &str| {
        let path = out.join(name);
        summary.files.push(path.clone());
        path
    };
    if options.anonymous {
        let (masked, key) = anonymous::mask(book, out)?;
        book = masked;
        write_whole(&written("key.csv"), Readers::Owner, |file| anonymous::write_key(file, &key))?;
    }
    write_whole(&written("grades.csv"), Readers::Usual, |file| grades::write(file, &book))?;
    // The gradebooks come before the report, which says whom they have no row for.
    let mut notes = Vec::new();
    if let Some(canvas) = &options.canvas {
        let filled = gradebook::canvas(&book, canvas)?;
        write_whole(&written("canvas.csv"), Readers::Usual, |file| filled.write(file))?;
        notes.extend(filled.notes);
    }
    if let Some(moodle) = &options.moodle {
        let filled = gradebook::moodle(&book, moodle)?;
        write_whole(&written("moodle.csv"), Readers::Usual, |file| filled.write(file))?;
        notes.extend(filled.notes);
    }
    let attention = attention(&book, notes);
    write_whole(&written("results.json"), Readers::Usual, |file| json::write(file, &book))?;
    write_whole(&written("junit.xml"), Readers::Usual, |file| junit::write(file, &book))?;
    let folder = written("feedback");
    feedback::write_folder(&folder, &book)?;
    write_whole(&written("report.html"), Readers::Usual, |file| report::write(file, &book, &attention))?;

    let submissions = book.entries.iter().filter(|entry| !entry.only_on_roster);
    summary.submissions = submissions.clone().count();
    summary.with_points = submissions.filter(|entry| entry.mark.points.is_some()).count();
    summary.missing = book.entries.len() - summary.submissions;
    summary.attention = attention.into_iter().map(|item| item.in_words()).collect();
    Ok(summary)
}

/// Something to look at: which submissions, and why.
pub(crate) struct Attention {
    /// Why, in a sentence without names.
    pub why: String,
    /// The ids, each with whose it is.
    pub who: Vec<(String, String)>,
}

impl Attention {
    fn in_words(&self) -> String {
        if self.who.is_empty() {
            return self.why.clone();
        }
        let shown = 5;
        let mut who: Vec<&str> = self.who.iter().take(shown).map(|(id, _)| id.as_str()).collect();
        let more = format!("and {} more", self.who.len().saturating_sub(shown));
        if self.who.len() > shown {
            who.push(&more);
        }
        format!("{}: {}", self.why, who.join(", "))
    }
}

fn attention(book: &Book<'_>, notes: Vec<String>) -> Vec<Attention> {
    let mut all = Vec::new();
    let mut collect = |wanted: &dyn Fn(&crate::book::Entry) -> bool, why: &dyn Fn(usize) -> String| {
        let found = book.entries.iter().filter(|entry| wanted(entry));
        let who: Vec<_> = found.map(|entry| (entry.id.clone(), entry.shown_name())).collect();
        if !who.is_empty() {
            all.push(Attention { why: why(who.len()), who });
        }
    };
    let has = |flag: fn(&Flag) -> bool| move |entry: &crate::book::Entry| entry.mark.flags.iter().any(flag);
    let undecided =
        |flag: &Flag| matches!(flag, Flag::OtherSubmissions { standing: Standing::Undecided, .. });
    let several = |flag: &Flag| matches!(flag, Flag::OtherSubmissions { standing, .. } if *standing != Standing::Undecided);
    collect(&|entry| entry.code == "harness-error" && entry.mark.points.is_none(), &|n| {
        format!(
            "{} could not be marked, for a reason that is not the student's; no points",
            count(n, "submission")
        )
    });
    collect(&has(undecided), &|n| {
        format!(
            "{} of students with several that differ in points: none counts until you decide",
            count(n, "submission")
        )
    });
    collect(&|entry| entry.code == "rejected", &|n| {
        format!("{} could not be taken as such, and has 0 points", count(n, "file"))
    });
    collect(&|entry| entry.code == "too-expensive-to-compile", &|n| {
        format!("{} stopped the compiler at a limit, and has 0 points", count(n, "submission"))
    });
    collect(&has(|flag| matches!(flag, Flag::NotOnRoster)), &|n| {
        format!("{} of somebody who is not on the roster", count(n, "submission"))
    });
    collect(&has(|flag| matches!(flag, Flag::NameDiffers { .. })), &|n| {
        format!("{} with another name than the roster has for the number", count(n, "submission"))
    });
    collect(&has(several), &|n| {
        format!("{} of students with several, where it is clear which one counts", count(n, "submission"))
    });
    collect(&has(|flag| matches!(flag, Flag::LateButNotListed)), &|n| {
        format!("{} marked late by the platform, but not in the list of days late", count(n, "submission"))
    });
    for why in book.oddities.iter().cloned().chain(notes) {
        all.push(Attention { why, who: Vec::new() });
    }
    all
}

/// Real names beside pseudonyms would undo them: a folder holds the one or the other.
fn refuse_the_other_kind(out: &Path, anonymous: bool) -> Result<(), Error> {
    let key = out.join("key.csv").exists();
    let results = ["grades.csv", "results.json", "report.html", "feedback"];
    let (other, what) = match anonymous {
        true => (!key && results.iter().any(|name| out.join(name).exists()), "results with names"),
        false => (key, "anonymous results"),
    };
    if other {
        let what = format!("{} holds {what}; write these into another folder", out.display());
        return Err(Error::Options(what));
    }
    Ok(())
}
