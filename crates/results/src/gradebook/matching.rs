//! Which row of a platform's table is whose.

use std::collections::{HashMap, HashSet};

use crate::book::{Book, Entry};
use crate::text::{count, name_key};
use crate::{Lms, Points};

/// Who can be found by what. Only marks that count are in it.
pub(super) struct Students<'a> {
    entries: Vec<&'a Entry>,
    by_platform_id: HashMap<&'a str, usize>,
    by_number: HashMap<&'a str, usize>,
    /// Nothing where two students have the same name.
    by_name: HashMap<String, Option<usize>>,
    found: HashSet<usize>,
}

impl<'a> Students<'a> {
    pub fn of(book: &'a Book<'_>) -> Students<'a> {
        let mut students = Students {
            entries: book.entries.iter().filter(|entry| entry.mark.counts).collect(),
            by_platform_id: HashMap::new(),
            by_number: HashMap::new(),
            by_name: HashMap::new(),
            found: HashSet::new(),
        };
        // Somebody without a mark that counts can have the name too.
        let mut keys: HashMap<String, HashSet<String>> = HashMap::new();
        for entry in &book.entries {
            keys.entry(name_key(&entry.student.name)).or_default().insert(entry.key());
        }
        for (index, entry) in students.entries.iter().enumerate() {
            match &entry.lms {
                Lms::None => {}
                Lms::Canvas { user_id: id } | Lms::Moodle { participant_id: id } => {
                    students.by_platform_id.insert(id, index);
                }
            }
            if let Some(number) = &entry.student.number {
                students.by_number.insert(number.trim(), index);
            }
            let name = name_key(&entry.student.name);
            if !name.is_empty() {
                let unique = keys.get(&name).is_some_and(|keys| keys.len() == 1);
                students.by_name.insert(name, Some(index).filter(|_| unique));
            }
        }
        students
    }

    pub fn by_platform_id(&self, id: &str) -> Option<usize> {
        self.by_platform_id.get(id.trim()).copied()
    }

    pub fn by_number(&self, number: &str) -> Option<usize> {
        self.by_number.get(number.trim()).copied()
    }

    pub fn by_name(&self, name: &str) -> Option<usize> {
        self.by_name.get(&name_key(name)).copied().flatten()
    }

    /// The points of a student who is found for the first time.
    pub fn take(&mut self, index: usize) -> Option<Points> {
        self.found.insert(index).then(|| self.entries[index].mark.points).flatten()
    }

    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    pub fn found_any(&self) -> bool {
        !self.found.is_empty()
    }

    /// Whom the table has no row for.
    pub fn not_found(&self, file: &str) -> Option<String> {
        let left = (0..self.entries.len()).filter(|index| !self.found.contains(index));
        let ids: Vec<&str> = left.map(|index| self.entries[index].id.as_str()).collect();
        let number = count(ids.len(), "mark");
        (!ids.is_empty()).then(|| format!("{number} without a row in {file}: {}", ids.join(", ")))
    }
}

/// The rows whose name stands there once.
pub(super) fn unique_names<'a>(names: impl Iterator<Item = &'a str>) -> HashSet<String> {
    let mut seen: HashMap<String, usize> = HashMap::new();
    for name in names {
        *seen.entry(name_key(name)).or_default() += 1;
    }
    seen.into_iter().filter(|(_, times)| *times == 1).map(|(name, _)| name).collect()
}
