//! `grades.csv`: one row per submission, and per student without one.

use std::io::Write;

use crate::book::{Book, Entry};
use crate::error::Filled;
use crate::text::{cell, one_line};
use crate::{Flag, Record, Standing, Verdict};

/// The columns before those of the parts.
const FIRST: [&str; 9] =
    ["id", "number", "name", "status", "points", "of", "counts", "days late", "percent off"];
/// The columns after those of the parts.
const LAST: [&str; 5] = ["misconceptions", "changes", "flags", "reason", "file"];

pub(crate) fn write(file: &mut dyn Write, book: &Book<'_>) -> Filled {
    let mut table = csv::Writer::from_writer(file);
    let parts = || book.run.parts.iter();
    let header = FIRST.into_iter().chain(parts().map(|part| part.id.as_str())).chain(LAST);
    write_row(&mut table, header.map(str::to_owned))?;
    book.each(|entry, record| -> Filled {
        let mark = &entry.mark;
        let late = |show: fn(&crate::Late) -> String| mark.late.as_ref().map(show).unwrap_or_default();
        let points =
            |points: Option<crate::Points>| points.map(|points| points.to_string()).unwrap_or_default();
        let first = [
            entry.id.clone(),
            record.student.number.clone().unwrap_or_default(),
            record.student.name.clone(),
            entry.code.to_owned(),
            points(mark.points),
            book.run.points().to_string(),
            if mark.counts { "yes" } else { "no" }.to_owned(),
            late(|late| late.days.to_string()),
            late(|late| late.percent.to_string()),
        ];
        let last = [
            misconceptions(&record.verdict).join(" "),
            changes(entry),
            flags(entry).join("; "),
            reason(record),
            record.file.clone(),
        ];
        let parts = mark.parts.iter().map(|part| points(*part));
        write_row(&mut table, first.into_iter().chain(parts).chain(last))
    })?;
    table.flush()?;
    Ok(())
}

fn write_row(table: &mut csv::Writer<&mut dyn Write>, cells: impl Iterator<Item = String>) -> Filled {
    for text in cells {
        table.write_field(cell(&one_line(&text)).as_bytes()).map_err(io_error)?;
    }
    table.write_record(None::<&[u8]>).map_err(io_error)?;
    Ok(())
}

fn io_error(error: csv::Error) -> std::io::Error {
    error.into()
}

fn changes(entry: &Entry) -> String {
    let shown = entry.mark.changes.iter().map(|change| match change.to {
        Some(to) => format!("{} = {to}: {}", change.what, change.reason),
        None => format!("{}: {}", change.what, change.reason),
    });
    shown.collect::<Vec<_>>().join("; ")
}

/// The short names of the misconceptions, each once, in order.
pub(crate) fn misconceptions(verdict: &Verdict) -> Vec<&str> {
    let Verdict::Graded { parts, .. } = verdict else { return Vec::new() };
    let mut ids: Vec<&str> = Vec::new();
    for named in parts.iter().flat_map(|part| &part.named) {
        if !ids.contains(&named.id.as_str()) {
            ids.push(&named.id);
        }
    }
    ids
}

/// What somebody should look at, in words.
pub(crate) fn flags(entry: &Entry) -> Vec<String> {
    let words = |flag: &Flag| match flag {
        Flag::NotOnRoster => "not on the roster".to_owned(),
        Flag::NameDiffers { name } => format!("the submission bears the name {name}"),
        Flag::LateButNotListed => "marked late by the platform, but not in the list of days late".to_owned(),
        Flag::OtherSubmissions { ids, standing } => {
            let ids = ids.join(", ");
            match standing {
                Standing::Agree => format!("the same points as {ids} of the same student"),
                Standing::Undecided => format!("other points than {ids} of the same student: none counts"),
                Standing::Chosen => format!("counts instead of {ids}"),
                Standing::NotChosen => format!("does not count: one of {ids} does"),
            }
        }
    };
    entry.mark.flags.iter().map(words).collect()
}

/// Why the verdict is what it is, in one line.
pub(crate) fn reason(record: &Record) -> String {
    match &record.verdict {
        Verdict::Graded { parts, .. } => {
            let states = parts.iter().map(|part| format!("{} {}", part.id, part.state.name()));
            states.collect::<Vec<_>>().join(", ")
        }
        Verdict::DoesNotCompile { errors, left_out } => {
            let first = errors.first().map(|error| {
                let line = error.line.map(|line| format!("line {line}: ")).unwrap_or_default();
                format!("{line}{}", error.message)
            });
            let more = errors.len().saturating_sub(1) + left_out;
            let more = if more > 0 { format!(" (and {more} more)") } else { String::new() };
            format!("{}{more}", first.unwrap_or_else(|| "the compiler refused it".to_owned()))
        }
        Verdict::TooExpensiveToCompile { limit, .. } => format!("the compiler was stopped: {limit}"),
        Verdict::Rejected { code, why } => format!("{code}: {why}"),
        Verdict::Missing => "no submission".to_owned(),
        Verdict::HarnessError { what } => what.clone(),
    }
}
