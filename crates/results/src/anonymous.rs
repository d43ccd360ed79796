//! Pseudonyms instead of everything that tells who somebody is.
//!
//! Numbers are given in the order of a hash, so that they say nothing of the alphabet or of student numbers; the same students and
//! the same seed give the same pseudonyms. What students and the compiler wrote is searched for names, numbers, file names and ids.

use std::cell::RefCell;
use std::collections::{BTreeMap, HashMap};
use std::io::{BufWriter, Seek, Write};
use std::path::Path;

use aho_corasick::{AhoCorasick, MatchKind};
use sha2::{Digest, Sha256};

use crate::book::{Book, Entry, Source};
use crate::error::Filled;
use crate::files::scratch;
use crate::text::{cell, one_line};
use crate::{Error, Flag, Group, Lms, Record, Student, Verdict};

/// One row of `key.csv`.
pub(crate) struct KeyRow {
    pseudonym: Pseudonym,
    id: String,
    student: Student,
    file: String,
}

#[derive(Clone, Debug)]
struct Pseudonym {
    /// `Student 017`
    name: String,
    /// `student-017`, and `student-017-2` for a second submission.
    id: String,
}

/// The same book without names, in the order of the pseudonyms, and the key to it.
pub(crate) fn mask<'a>(book: Book<'a>, folder: &Path) -> Result<(Book<'a>, Vec<KeyRow>), Error> {
    let pseudonyms = pseudonyms(&book);
    let mut files = Vec::new();
    book.each(|_, record| -> Result<(), Error> {
        files.push(record.file.clone());
        Ok(())
    })?;
    let masker = Masker::new(&book, &files, &pseudonyms)?;

    let mut spool = BufWriter::new(scratch(folder)?);
    let mut places = Vec::new();
    let (mut start, mut index) = (0, 0);
    book.each(|_, record| -> Result<(), Error> {
        let bytes = serde_json::to_vec(&masker.record(index, record));
        let bytes = bytes.map_err(|trouble| Error::write(folder)(trouble.into()))?;
        spool.write_all(&bytes).map_err(Error::write(folder))?;
        places.push((start, bytes.len()));
        start += bytes.len() as u64;
        index += 1;
        Ok(())
    })?;
    let mut spool = spool.into_inner().map_err(|trouble| Error::write(folder)(trouble.into_error()))?;
    spool.rewind().map_err(Error::write(folder))?;

    let mut order: Vec<usize> = (0..book.entries.len()).collect();
    order.sort_by(|one, other| pseudonyms[*one].id.cmp(&pseudonyms[*other].id));
    let key = order.iter().map(|index| KeyRow {
        pseudonym: pseudonyms[*index].clone(),
        id: book.entries[*index].id.clone(),
        student: book.entries[*index].student.clone(),
        file: files[*index].clone(),
    });
    let key = key.collect();
    let groups = book.groups.iter().map(|group| {
        let mut ids: Vec<String> = group.ids.iter().map(|id| masker.id(id)).collect();
        ids.sort_unstable();
        Group { ids, similarity: group.similarity, kind: masker.anybody(&group.kind) }
    });
    let mut groups: Vec<Group> = groups.collect();
    groups.sort_by(|one, other| one.ids.cmp(&other.ids));
    let masked = Book {
        run: book.run,
        entries: order.iter().map(|index| masker.entry(*index, &book.entries[*index])).collect(),
        groups,
        oddities: book.oddities.iter().map(|text| masker.anybody(text)).collect(),
        source: Source::Spool {
            file: RefCell::new(spool),
            places: order.iter().map(|index| places[*index]).collect(),
        },
    };
    Ok((masked, key))
}

/// Who is who.
pub(crate) fn write_key(file: &mut dyn Write, key: &[KeyRow]) -> Filled {
    let mut table = csv::Writer::from_writer(file);
    let io_error = std::io::Error::from;
    table.write_record(["pseudonym", "pseudonymous id", "id", "number", "name", "file"]).map_err(io_error)?;
    for row in key {
        let number = row.student.number.as_deref().unwrap_or_default();
        let cells = [&row.pseudonym.name, &row.pseudonym.id, &row.id, number, &row.student.name, &row.file];
        let cells = cells.map(|text| cell(&one_line(text)).into_owned());
        table.write_record(cells).map_err(io_error)?;
    }
    Ok(table.flush()?)
}

/// One per entry, in the entries' order; the submissions of one student share a name.
fn pseudonyms(book: &Book<'_>) -> Vec<Pseudonym> {
    let mut students: BTreeMap<[u8; 32], Vec<usize>> = BTreeMap::new();
    for (index, entry) in book.entries.iter().enumerate() {
        let hash =
            Sha256::new().chain_update(book.run.seed.to_le_bytes()).chain_update(entry.key()).finalize();
        students.entry(hash.into()).or_default().push(index);
    }
    let digits = students.len().to_string().len().max(3);
    let mut all = vec![Pseudonym { name: String::new(), id: String::new() }; book.entries.len()];
    for (number, submissions) in students.values().enumerate() {
        let number = number + 1;
        for (place, index) in submissions.iter().enumerate() {
            let suffix = if place == 0 { String::new() } else { format!("-{}", place + 1) };
            let name = format!("Student {number:0digits$}");
            all[*index] = Pseudonym { name, id: format!("student-{number:0digits$}{suffix}") };
        }
    }
    all
}

/// Finds what tells who somebody is, and puts the pseudonym there.
struct Masker<'a> {
    pseudonyms: &'a [Pseudonym],
    by_id: HashMap<&'a str, &'a Pseudonym>,
    finder: AhoCorasick,
    /// What is put in the place of each pattern.
    replacements: Vec<&'a str>,
    /// The words of each one's name.
    words: Vec<Vec<String>>,
}

/// Shorter than this, a name or a number must stand alone to be taken for one.
const TELLING: usize = 6;

impl<'a> Masker<'a> {
    fn new(book: &'a Book<'_>, files: &[String], pseudonyms: &'a [Pseudonym]) -> Result<Masker<'a>, Error> {
        let mut patterns: Vec<String> = Vec::new();
        let mut replacements = Vec::new();
        let mut words = Vec::new();
        for ((entry, file), pseudonym) in book.entries.iter().zip(files).zip(pseudonyms) {
            let mut add = |text: &str, replacement: &'a str| {
                if text.chars().count() > 2 {
                    patterns.push(text.to_owned());
                    replacements.push(replacement);
                }
            };
            let name = entry.student.name.trim();
            add(&entry.id, &pseudonym.id);
            add(file, &pseudonym.id);
            add(file.rsplit_once('.').map_or("", |(stem, _)| stem), &pseudonym.id);
            add(name, &pseudonym.name);
            add(&name.split_whitespace().collect::<String>(), &pseudonym.name);
            add(entry.student.number.as_deref().unwrap_or_default().trim(), &pseudonym.id);
            match &entry.lms {
                Lms::None => {}
                Lms::Canvas { user_id: id } | Lms::Moodle { participant_id: id } => add(id, &pseudonym.id),
            }
            for flag in &entry.mark.flags {
                if let Flag::NameDiffers { name } = flag {
                    add(name.trim(), &pseudonym.name);
                }
            }
            let long = |word: &&str| word.chars().count() > 2;
            words.push(
                name.split(|c: char| !c.is_alphanumeric()).filter(long).map(str::to_lowercase).collect(),
            );
        }
        let mut builder = AhoCorasick::builder();
        builder.ascii_case_insensitive(true).match_kind(MatchKind::LeftmostLongest);
        let finder = builder.build(&patterns).map_err(|trouble| Error::Options(trouble.to_string()))?;
        let ids = book.entries.iter().map(|entry| entry.id.as_str()).zip(pseudonyms);
        Ok(Masker { pseudonyms, by_id: ids.collect(), finder, replacements, words })
    }

    fn id(&self, id: &str) -> String {
        self.by_id.get(id).map_or_else(String::new, |pseudonym| pseudonym.id.clone())
    }

    /// Without what tells of anybody in this run.
    fn anybody(&self, text: &str) -> String {
        let mut out = String::with_capacity(text.len());
        let mut end = 0;
        for found in self.finder.find_iter(text) {
            let (before, after) = (&text[..found.start()], &text[found.end()..]);
            let inside = before.ends_with(char::is_alphanumeric) || after.starts_with(char::is_alphanumeric);
            out.push_str(&text[end..found.start()]);
            if inside && found.len() < TELLING {
                out.push_str(&text[found.range()]);
            } else {
                out.push_str(self.replacements[found.pattern()]);
            }
            end = found.end();
        }
        out.push_str(&text[end..]);
        out
    }

    /// What may hold words of the student's is also searched for each word of the name.
    fn own(&self, index: usize, text: &str) -> String {
        let text = self.anybody(text);
        let words = &self.words[index];
        let mut out = String::with_capacity(text.len());
        for piece in text.split_inclusive(|c: char| !c.is_alphanumeric()) {
            let word = piece.trim_end_matches(|c: char| !c.is_alphanumeric());
            if words.contains(&word.to_lowercase()) {
                out.push_str("[name]");
                out.push_str(&piece[word.len()..]);
            } else {
                out.push_str(piece);
            }
        }
        out
    }

    fn entry(&self, index: usize, entry: &Entry) -> Entry {
        let mut mark = entry.mark.clone();
        for change in &mut mark.changes {
            change.reason = self.own(index, &change.reason);
        }
        for flag in &mut mark.flags {
            match flag {
                Flag::OtherSubmissions { ids, .. } => {
                    ids.iter_mut().for_each(|id| *id = self.id(id));
                    ids.sort_unstable();
                }
                Flag::NameDiffers { name } => *name = "(see key.csv)".to_owned(),
                Flag::NotOnRoster | Flag::LateButNotListed => {}
            }
        }
        let Pseudonym { name, id } = self.pseudonyms[index].clone();
        Entry { id, student: Student { number: None, name }, lms: Lms::None, mark, ..entry.clone() }
    }

    fn record(&self, index: usize, record: &Record) -> Record {
        let Pseudonym { name, id } = self.pseudonyms[index].clone();
        let mut verdict = record.verdict.clone();
        let own = |text: &mut String| *text = self.own(index, text);
        match &mut verdict {
            Verdict::Graded { parts, whole, .. } => {
                for check in parts.iter_mut().flat_map(|part| &mut part.checks) {
                    own(&mut check.note);
                    own(&mut check.private_note);
                }
                if let Some(whole) = whole {
                    own(&mut whole.note);
                }
            }
            Verdict::DoesNotCompile { errors, .. } => {
                for error in errors {
                    own(&mut error.message);
                    own(&mut error.text);
                }
            }
            Verdict::TooExpensiveToCompile { limit, text } => {
                own(limit);
                own(text);
            }
            Verdict::Rejected { why, .. } => own(why),
            Verdict::HarnessError { what } => own(what),
            Verdict::Missing => {}
        }
        Record {
            id,
            student: Student { number: None, name },
            lms: Lms::None,
            // Whoever has the file could find its student by it.
            sha256: None,
            file: String::new(),
            marked_late: record.marked_late,
            remarks: record.remarks.iter().map(|remark| self.own(index, remark)).collect(),
            sandbox: self.anybody(&record.sandbox),
            verdict,
        }
    }
}
