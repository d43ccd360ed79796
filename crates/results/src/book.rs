//! All records with their marks: the one thing that every output is written from.
//!
//! The records themselves are read again for every output, one at a time. What is kept of each is small.

use std::cell::RefCell;
use std::collections::{HashMap, HashSet};
use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom};
use std::mem;

use crate::inputs::{Override, What};
use crate::mark::{Flag, Mark, Standing};
use crate::text::{name_key, resembles};
use crate::{Error, Group, Lms, Options, Record, RunInfo, Student, Verdict};

/// The records of a run. They can be read more than once, always in the same order.
pub type Records<'a> = dyn Fn() -> io::Result<Box<dyn Iterator<Item = io::Result<Record>> + 'a>> + 'a;

pub(crate) struct Book<'a> {
    pub run: &'a RunInfo,
    /// The submissions in the records' order, then the students without one.
    pub entries: Vec<Entry>,
    pub groups: Vec<Group>,
    /// What is odd about the files that were handed in beside the submissions.
    pub oddities: Vec<String>,
    pub source: Source<'a>,
}

/// What is kept of a record.
#[derive(Clone, Debug)]
pub(crate) struct Entry {
    pub id: String,
    pub student: Student,
    pub lms: Lms,
    pub code: &'static str,
    pub mark: Mark,
    /// Whether there is no record: the student stands on the roster only.
    pub only_on_roster: bool,
}

pub(crate) enum Source<'a> {
    Records(&'a Records<'a>),
    /// Records as JSON, and where each of them begins and how long it is.
    Spool {
        file: RefCell<File>,
        places: Vec<(u64, usize)>,
    },
}

impl<'a> Book<'a> {
    /// Reads all records once.
    pub fn open(run: &'a RunInfo, records: &'a Records<'a>, options: &Options) -> Result<Book<'a>, Error> {
        let mut book = Book {
            run,
            entries: Vec::new(),
            groups: Vec::new(),
            oddities: Vec::new(),
            source: Source::Records(records),
        };
        let mut ids = HashSet::new();
        let mut on_roster = HashSet::new();
        let mut marker = Marker::new(run, options);
        for record in records().map_err(Error::Records)? {
            let mut record = record.map_err(Error::Records)?;
            check_id(&record.id)?;
            if !ids.insert(record.id.to_lowercase()) {
                let what = format!("two of them have the id `{}`, or it differs in case only", record.id);
                return Err(Error::BadRecords(what));
            }
            let mut flags = Vec::new();
            if let Some(roster) = &options.roster {
                match roster.find(&record.student) {
                    Some(index) => {
                        on_roster.insert(index);
                        let known = roster.students()[index].clone();
                        let name = mem::replace(&mut record.student, known).name;
                        if record.student.name.is_empty() {
                            record.student.name = name;
                        } else if !resembles(&name, &record.student.name) {
                            flags.push(Flag::NameDiffers { name });
                        }
                    }
                    None => flags.push(Flag::NotOnRoster),
                }
            }
            book.entries.push(marker.entry(&record, flags, false)?);
        }
        // A share of the submissions does not tell who handed in nothing.
        if let (Some(roster), None) = (&options.roster, run.shard) {
            let students = roster.students().iter().enumerate();
            for (_, student) in students.filter(|(index, _)| !on_roster.contains(index)) {
                let id = id_of_missing(student, &mut ids);
                book.entries.push(marker.entry(&missing(id, student.clone()), Vec::new(), true)?);
            }
        }
        book.oddities = marker.finish()?;
        decide_between_submissions(&mut book.entries, options)?;
        let known = |id: &String| ids.contains(&id.to_lowercase());
        for group in &options.groups {
            let ids: Vec<String> = group.ids.iter().filter(|id| known(id)).cloned().collect();
            if ids.len() > 1 {
                book.groups.push(Group { ids, ..group.clone() });
            }
        }
        Ok(book)
    }

    /// Visits every entry with its record.
    pub fn each<E: From<Error>>(
        &self,
        mut visit: impl FnMut(&Entry, &Record) -> Result<(), E>,
    ) -> Result<(), E> {
        match &self.source {
            Source::Records(records) => {
                let mut records = records().map_err(Error::Records)?;
                for entry in &self.entries {
                    let record = match records.next() {
                        _ if entry.only_on_roster => missing(entry.id.clone(), entry.student.clone()),
                        Some(record) => {
                            let record = record.map_err(Error::Records)?;
                            Record { student: entry.student.clone(), ..record }
                        }
                        None => return Err(changed().into()),
                    };
                    if record.id != entry.id {
                        return Err(changed().into());
                    }
                    visit(entry, &record)?;
                }
            }
            Source::Spool { file, places } => {
                let mut file = file.borrow_mut();
                for (entry, (start, length)) in self.entries.iter().zip(places) {
                    let mut bytes = vec![0; *length];
                    file.seek(SeekFrom::Start(*start)).map_err(Error::Records)?;
                    file.read_exact(&mut bytes).map_err(Error::Records)?;
                    let record = serde_json::from_slice(&bytes);
                    visit(entry, &record.map_err(|error| Error::Records(error.into()))?)?;
                }
            }
        }
        Ok(())
    }
}

fn changed() -> Error {
    Error::BadRecords("they changed while they were being read".to_owned())
}

impl Entry {
    /// What tells this student from all others: the number, or the learning platform's, or the name; else the submission.
    pub fn key(&self) -> String {
        match (&self.student.number, &self.lms) {
            (Some(number), _) => format!("number {}", number.trim()),
            (None, Lms::Canvas { user_id }) => format!("canvas {user_id}"),
            (None, Lms::Moodle { participant_id }) => format!("moodle {participant_id}"),
            (None, Lms::None) => match name_key(&self.student.name) {
                name if name.is_empty() => format!("id {}", self.id),
                name => format!("name {name}"),
            },
        }
    }
}

impl Entry {
    /// The name, or what else there is.
    pub fn shown_name(&self) -> String {
        let number = self.student.number.as_deref().unwrap_or_default();
        let known = [self.student.name.trim(), number, &self.id];
        known.into_iter().find(|text| !text.is_empty()).unwrap_or_default().to_owned()
    }
}

/// Gives marks, and keeps account of which lines of the late list and the overrides were used.
struct Marker<'a> {
    run: &'a RunInfo,
    options: &'a Options,
    overrides: HashMap<&'a str, Vec<&'a Override>>,
    used: HashSet<&'a str>,
}

impl<'a> Marker<'a> {
    fn new(run: &'a RunInfo, options: &'a Options) -> Marker<'a> {
        let mut overrides: HashMap<&str, Vec<&Override>> = HashMap::new();
        for decided in options.overrides.iter().flat_map(|overrides| &overrides.list) {
            overrides.entry(&decided.student).or_default().push(decided);
        }
        Marker { run, options, overrides, used: HashSet::new() }
    }

    fn entry(&mut self, record: &Record, mut flags: Vec<Flag>, only_on_roster: bool) -> Result<Entry, Error> {
        let mut overrides: Vec<&Override> = Vec::new();
        let number = record.student.number.as_deref().map(str::trim).filter(|number| *number != record.id);
        for name in [Some(record.id.as_str()), number].into_iter().flatten() {
            if let Some((name, found)) = self.overrides.get_key_value(name) {
                self.used.insert(name);
                overrides.extend(found);
            }
        }
        overrides.sort_by(|one, other| one.what.cmp(&other.what));
        let mut late = None;
        if let (Some(list), Some(number)) = (&self.options.late, &record.student.number)
            && let Some((number, days)) = list.days.get_key_value(number.trim())
        {
            self.used.insert(number);
            late = Some((list.policy, days.days));
        }
        if record.marked_late && late.is_none() {
            flags.push(Flag::LateButNotListed);
        }
        let mark = Mark::new(self.run, record, &overrides, late).map_err(|line| {
            let what = "this submission has no points that could be changed: override the part or the total";
            self.bad_override(line, what)
        })?;
        Ok(Entry {
            id: record.id.clone(),
            student: record.student.clone(),
            lms: record.lms.clone(),
            code: record.verdict.code(),
            mark: Mark { flags, ..mark },
            only_on_roster,
        })
    }

    fn bad_override(&self, line: u64, what: impl Into<String>) -> Error {
        let path = self.options.overrides.as_ref().map(|overrides| overrides.path.clone());
        Error::Input { path: path.unwrap_or_default(), line: Some(line), what: what.into() }
    }

    /// What nobody used. A share of the submissions does not know all students.
    fn finish(self) -> Result<Vec<String>, Error> {
        if self.run.shard.is_some() {
            return Ok(Vec::new());
        }
        let decided = self.options.overrides.iter().flat_map(|overrides| &overrides.list);
        if let Some(unused) = decided.into_iter().find(|decided| !self.used.contains(&*decided.student)) {
            let what = format!("`{}` is no student and no submission of this run", unused.student);
            return Err(self.bad_override(unused.line, what));
        }
        let mut lines: Vec<u64> = Vec::new();
        let late = self.options.late.iter().flat_map(|list| &list.days);
        lines.extend(late.filter(|(number, _)| !self.used.contains(&***number)).map(|(_, late)| late.line));
        lines.sort_unstable();
        let path = self.options.late.as_ref().map(|list| list.path.display().to_string()).unwrap_or_default();
        // Without the number: this is also told where students have no names.
        let odd = |line| format!("{path}, line {line}: this student is not in this run");
        Ok(lines.into_iter().map(odd).collect())
    }
}

/// One student, one mark: where submissions differ and nobody has decided, none counts.
fn decide_between_submissions(entries: &mut [Entry], options: &Options) -> Result<(), Error> {
    let mut by_student: HashMap<String, Vec<usize>> = HashMap::new();
    for (index, entry) in entries.iter().enumerate() {
        if !entry.only_on_roster {
            by_student.entry(entry.key()).or_default().push(index);
        }
    }
    let decided = options.overrides.iter().flat_map(|overrides| &overrides.list);
    let decided: Vec<&Override> = decided.filter(|decided| decided.what == What::Counts).collect();
    for all in by_student.into_values().filter(|all| all.len() > 1) {
        let is_chosen =
            |index: &usize| entries[*index].mark.changes.iter().any(|change| change.what == "counts");
        let chosen: Vec<usize> = all.iter().copied().filter(is_chosen).collect();
        if chosen.len() > 1 {
            let student = &entries[chosen[0]];
            let named = |decided: &&&Override| {
                decided.student == student.id || Some(&decided.student) == student.student.number.as_ref()
            };
            let line = decided.iter().find(named).map(|decided| decided.line);
            let path = options.overrides.as_ref().map(|overrides| overrides.path.clone()).unwrap_or_default();
            let what = "only one submission of a student can count: write its id, and only one".to_owned();
            return Err(Error::Input { path, line, what });
        }
        let points = entries[all[0]].mark.points;
        let agree = all.iter().all(|index| entries[*index].mark.points == points);
        let ids: Vec<String> = all.iter().map(|index| entries[*index].id.clone()).collect();
        for (place, index) in all.iter().enumerate() {
            let standing = match chosen.first() {
                Some(chosen) if chosen == index => Standing::Chosen,
                Some(_) => Standing::NotChosen,
                None if agree => Standing::Agree,
                None => Standing::Undecided,
            };
            let mark = &mut entries[*index].mark;
            mark.counts &= standing == Standing::Chosen || (standing == Standing::Agree && place == 0);
            let others = ids.iter().enumerate().filter(|(other, _)| *other != place);
            let ids = others.map(|(_, id)| id.clone()).collect();
            mark.flags.push(Flag::OtherSubmissions { ids, standing });
        }
    }
    Ok(())
}

fn missing(id: String, student: Student) -> Record {
    Record {
        id,
        student,
        lms: Lms::None,
        file: String::new(),
        sha256: None,
        marked_late: false,
        remarks: Vec::new(),
        sandbox: String::new(),
        verdict: Verdict::Missing,
    }
}

fn id_of_missing(student: &Student, ids: &mut HashSet<String>) -> String {
    let number = student.number.as_deref().unwrap_or_default();
    let safe: String = number.chars().filter(char::is_ascii_alphanumeric).take(40).collect();
    let mut id = if safe.is_empty() { "missing".to_owned() } else { format!("missing-{safe}") };
    let base = id.clone();
    let mut next = 2;
    while !ids.insert(id.to_lowercase()) {
        id = format!("{base}-{next}");
        next += 1;
    }
    id
}

fn check_id(id: &str) -> Result<(), Error> {
    let safe = |byte: u8| byte.is_ascii_alphanumeric() || b"-_.".contains(&byte);
    if id.is_empty() || id.len() > 150 || id.starts_with('.') || !id.bytes().all(safe) {
        return Err(Error::BadRecords(format!("`{id}` is no safe file name")));
    }
    Ok(())
}
