//! Canvas: an exported gradebook. A header that Canvas does not know becomes a new assignment, so that nothing but the one column is
//! touched. Rows are matched by `ID`, then `SIS User ID`, then `SIS Login ID`, then the name, as Canvas itself does.

use super::matching::{Students, unique_names};
use super::{FilledIn, target};
use crate::book::Book;
use crate::inputs::Table;
use crate::text::{count, name_key};
use crate::{Error, Gradebook, Points};

const STUDENT: &[&str] = &["student"];
const ID: &[&str] = &["id"];
const SIS_USER: &[&str] = &["sisuserid"];
const SIS_LOGIN: &[&str] = &["sisloginid"];

pub(crate) fn canvas(book: &Book<'_>, gradebook: &Gradebook) -> Result<FilledIn, Error> {
    let mut table = Table::read(&gradebook.path)?;
    let ([student, id, sis_user, sis_login], rows) = table.columns([STUDENT, ID, SIS_USER, SIS_LOGIN]);
    if student.is_none() || id.is_none() || rows.len() == table.rows.len() {
        let what = "is no gradebook exported from Canvas: expected the columns Student, ID, SIS User ID, SIS Login ID and \
                    Section in the first line";
        return Err(table.error(1, what));
    }
    let title = book.run.title.to_lowercase();
    let is_ours = |name: &str| name.to_lowercase().contains(&title);
    let column = target(&table, gradebook.column.as_deref(), "--canvas-column", is_ours)?;

    let file = "canvas.csv";
    let mut notes = Vec::new();
    let mut students = Students::of(book);
    let names = unique_names(table.rows.iter().map(|row| row.cell(student)));
    let mut excused = 0;
    for row in table.rows.iter_mut().skip(1) {
        // The row with the points possible, whatever it is called in the platform's language, has no id.
        if row.cell(id).is_empty() {
            let of = Points::whole(book.run.points());
            if let Ok(possible) = row.cell(Some(column)).parse::<Points>()
                && possible != of
            {
                notes.push(format!("{file}: the assignment is worth {possible} there, and {of} here"));
            }
            continue;
        }
        let by_name = || {
            let name = row.cell(student);
            students.by_name(name).filter(|_| names.contains(&name_key(name)))
        };
        let found = students
            .by_platform_id(row.cell(id))
            .or_else(|| students.by_number(row.cell(sis_user)))
            .or_else(|| students.by_number(row.cell(sis_login)))
            .or_else(by_name);
        let Some(points) = found.and_then(|index| students.take(index)) else { continue };
        if row.cell(Some(column)).eq_ignore_ascii_case("EX") {
            excused += 1;
            continue;
        }
        if row.cells.len() <= column {
            row.cells.resize(column + 1, String::new());
        }
        row.cells[column] = points.to_string();
    }
    if excused > 0 {
        notes.push(format!(
            "{file}: {} excused (EX) and left so, although handed in",
            count(excused, "student")
        ));
    }
    if !students.is_empty() && !students.found_any() {
        return Err(table.error(None, "has a row for none of the students of this run"));
    }
    notes.extend(students.not_found(file));
    Ok(FilledIn { table, notes })
}
