//! Who is enrolled.

use std::collections::HashMap;
use std::path::Path;

use super::table::Table;
use crate::text::name_key;
use crate::{Error, Student};

/// The students who are enrolled, in the order of the file.
#[derive(Clone, Debug, Default)]
pub struct Roster {
    students: Vec<Student>,
    by_number: HashMap<String, usize>,
    /// Nothing where two students have the same name.
    by_name: HashMap<String, Option<usize>>,
}

const NUMBER: &[&str] = &[
    "studentnumber",
    "number",
    "studentid",
    "sisuserid",
    "idnumber",
    "matriculationnumber",
    "matrikelnummer",
    "matriculation",
    "nummer",
    "id",
];
const NAME: &[&str] = &["studentname", "fullname", "name", "student"];
const FIRST: &[&str] = &["firstname", "givenname", "forename", "vorname"];
const LAST: &[&str] = &["lastname", "surname", "familyname", "nachname"];

impl Roster {
    /// Reads a table with the columns `number` and `name`, or `first name` and `last name`. Further columns do not matter, and
    /// without a header the first two columns are number and name.
    ///
    /// # Errors
    ///
    /// When the file cannot be read, a student has neither number nor name, or a number stands there twice.
    pub fn read(path: &Path) -> Result<Roster, Error> {
        let table = Table::read(path)?;
        let ([number, name, first, last], rows) = table.columns([NUMBER, NAME, FIRST, LAST]);
        let with_header = rows.len() < table.rows.len();
        let (first, last) = if with_header { (first, last) } else { (None, None) };
        if with_header && (number.is_none() || (name.is_none() && last.is_none())) {
            let what =
                "the header needs a column `number` and a column `name` (or `first name` and `last name`)";
            return Err(table.error(1, what));
        }
        let mut roster = Roster::default();
        for row in rows.iter().filter(|row| !row.is_blank()) {
            let number = row.cell(number);
            if !with_header && !number.contains(|character: char| character.is_ascii_digit()) {
                let what = format!(
                    "`{number}` is no student number; the columns are number and name, and a header may say so"
                );
                return Err(table.error(row.line, what));
            }
            let name = match row.cell(name) {
                "" => format!("{} {}", row.cell(first), row.cell(last)).trim().to_owned(),
                name => name.to_owned(),
            };
            if number.is_empty() && name.is_empty() {
                return Err(table.error(row.line, "has neither a number nor a name"));
            }
            let number = Some(number.to_owned()).filter(|number| !number.is_empty());
            if roster.add(Student { number, name }).is_none() {
                return Err(table.error(row.line, "this number stands on the roster twice"));
            }
        }
        Ok(roster)
    }

    fn add(&mut self, student: Student) -> Option<()> {
        let index = self.students.len();
        if let Some(number) = &student.number
            && self.by_number.insert(number.clone(), index).is_some()
        {
            return None;
        }
        let key = name_key(&student.name);
        if !key.is_empty() {
            self.by_name.entry(key).and_modify(|found| *found = None).or_insert(Some(index));
        }
        self.students.push(student);
        Some(())
    }

    /// The students, in the order of the file.
    pub fn students(&self) -> &[Student] {
        &self.students
    }

    /// Where this student stands: found by the number, or, without one, by a name that only one student has.
    pub(crate) fn find(&self, student: &Student) -> Option<usize> {
        match &student.number {
            Some(number) => self.by_number.get(number.trim()).copied(),
            None => self.by_name.get(&name_key(&student.name)).copied().flatten(),
        }
    }
}
