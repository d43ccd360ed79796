//! What the teaching assistant decides otherwise than the checks.

use std::path::{Path, PathBuf};

use super::table::{Table, squeezed};
use crate::{Error, Points, RunInfo};

/// Points that count instead of those of the checks, each with a reason.
#[derive(Clone, Debug, Default)]
pub struct Overrides {
    pub(crate) path: PathBuf,
    pub(crate) list: Vec<Override>,
}

#[derive(Clone, Debug)]
pub(crate) struct Override {
    /// A student number, or the id of a submission.
    pub student: String,
    pub what: What,
    pub reason: String,
    pub line: u64,
}

/// What is decided. The variants are in the order in which they are carried out.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum What {
    /// The points of a check: the part's index, the check's index.
    Check(usize, usize, Points),
    /// The points of a part, whatever its checks say.
    Part(usize, Points),
    /// The points of the whole, whatever anything else says; days late take nothing from them.
    Total(Points),
    /// That of a student's submissions this one counts.
    Counts,
}

const STUDENT: &[&str] = &["student", "studentnumber", "number", "studentid", "id", "submission"];
const WHAT: &[&str] = &["what", "item", "check", "part"];
const POINTS: &[&str] = &["points", "score", "mark"];
const REASON: &[&str] = &["reason", "why", "comment", "note"];

impl Overrides {
    /// Reads a table with the columns `student`, `what`, `points` and `reason`, or, without a header, these four.
    ///
    /// The student is a number or the id of a submission. What is changed is a check (`part1/rotation_orders`, or its name alone
    /// where only one part has such a check), a part (`part1`), or `total`. `counts`, without points, says which of a student's
    /// submissions counts.
    ///
    /// # Errors
    ///
    /// When the file cannot be read, something is changed that the exercise does not have, to more points than it is worth, twice,
    /// or without a reason. A student whom nobody knows is found out when the results are written.
    pub fn read(path: &Path, run: &RunInfo) -> Result<Overrides, Error> {
        let table = Table::read(path)?;
        let ([student, what, points, reason], rows) = table.columns([STUDENT, WHAT, POINTS, REASON]);
        if [student, what, points, reason].contains(&None) {
            return Err(
                table.error(1, "the header needs the columns `student`, `what`, `points` and `reason`")
            );
        }
        let mut list: Vec<Override> = Vec::new();
        for row in rows.iter().filter(|row| !row.is_blank()) {
            let error = |what: String| table.error(row.line, what);
            let what = parse_what(run, row.cell(what), row.cell(points)).map_err(error)?;
            let (student, reason) = (row.cell(student), row.cell(reason));
            if student.is_empty() {
                return Err(error("expected a student number or the id of a submission".to_owned()));
            }
            if reason.is_empty() {
                return Err(error("expected a reason: the student reads it".to_owned()));
            }
            let (student, reason) = (student.to_owned(), reason.to_owned());
            if let Some(before) = list.iter().find(|other| other.student == student && other.what.same(&what))
            {
                return Err(error(format!("this is decided in line {} already", before.line)));
            }
            list.push(Override { student, what, reason, line: row.line });
        }
        Ok(Overrides { path: path.to_owned(), list })
    }
}

impl What {
    /// Whether both change the same thing.
    fn same(&self, other: &What) -> bool {
        match (self, other) {
            (What::Check(part, check, _), What::Check(other_part, other_check, _)) => {
                (part, check) == (other_part, other_check)
            }
            (What::Part(part, _), What::Part(other, _)) => part == other,
            (What::Total(_), What::Total(_)) | (What::Counts, What::Counts) => true,
            _ => false,
        }
    }
}

fn parse_what(run: &RunInfo, what: &str, points: &str) -> Result<What, String> {
    let worth = |of: u32| -> Result<Points, String> {
        let points: Points = points.parse().map_err(|trouble| format!("{trouble}, found `{points}`"))?;
        if points > Points::whole(of) {
            return Err(format!("{points} points are more than the {of} that `{what}` is worth"));
        }
        Ok(points)
    };
    match squeezed(what).as_str() {
        "total" => return Ok(What::Total(worth(run.points())?)),
        "counts" if points.is_empty() => return Ok(What::Counts),
        "counts" => return Err("`counts` takes no points".to_owned()),
        _ => {}
    }
    if let Some(part) = run.parts.iter().position(|part| part.id == what) {
        return Ok(What::Part(part, worth(run.parts[part].points)?));
    }
    let mut found = Vec::new();
    for (part, info) in run.parts.iter().enumerate() {
        for (check, of) in info.checks.iter().enumerate() {
            if what == of.id || what.split_once('/') == Some((&info.id, &of.id)) {
                found.push((part, check, of.points));
            }
        }
    }
    match found.as_slice() {
        [(part, check, of)] => Ok(What::Check(*part, *check, worth(*of)?)),
        [] => Err(format!("there is no `{what}`; expected {}", choices(run))),
        _ => Err(format!(
            "several parts have a check `{what}`; write the part before it, as in `part1/{what}`"
        )),
    }
}

fn choices(run: &RunInfo) -> String {
    let mut all = vec!["`total`".to_owned(), "`counts`".to_owned()];
    for part in &run.parts {
        all.push(format!("`{}`", part.id));
        all.extend(part.checks.iter().map(|check| format!("`{}/{}`", part.id, check.id)));
    }
    all.join(", ")
}
