//! Moodle: an offline grading worksheet, or an exported gradebook.
//!
//! Its headers are in the platform's language, so that columns are known by what is in them: `Participant 123` in any language, student
//! numbers, names. One unknown user makes Moodle refuse the whole file, so that no row is ever added.

use super::matching::{Students, unique_names};
use super::{FilledIn, target};
use crate::book::Book;
use crate::inputs::Table;
use crate::text::name_key;
use crate::{Error, Gradebook};

/// What the worksheet's column for the points is called: English, German, French, Spanish, Italian, Dutch, Portuguese,
/// Swedish, Danish and Norwegian, Polish, Czech.
const GRADE: [&str; 13] = [
    "grade",
    "bewertung",
    "note",
    "calificación",
    "valutazione",
    "voto",
    "cijfer",
    "nota",
    "betyg",
    "karakter",
    "ocena",
    "známka",
    "hodnocení",
];

pub(crate) fn moodle(book: &Book<'_>, gradebook: &Gradebook) -> Result<FilledIn, Error> {
    let mut table = Table::read(&gradebook.path)?;
    let title = book.run.title.to_lowercase();
    let fits = |name: &str| {
        let name = name.trim().to_lowercase();
        GRADE.contains(&name.as_str()) || name.contains(&title)
    };
    let column = target(&table, gradebook.column.as_deref(), "--moodle-column", fits)?;

    let file = "moodle.csv";
    let mut students = Students::of(book);
    let columns = Columns::of(&table, &students);
    let full_names: Vec<String> = table.rows.iter().map(|row| columns.name(&row.cells)).collect();
    let unique = unique_names(full_names.iter().map(String::as_str));
    for (row, name) in table.rows.iter_mut().zip(&full_names).skip(1) {
        let by_participant = columns.participant.and_then(|at| participant(row.cells.get(at)?));
        let found = by_participant
            .and_then(|id| students.by_platform_id(id))
            .or_else(|| students.by_number(row.cell(columns.number)).filter(|_| columns.number.is_some()))
            .or_else(|| students.by_name(name).filter(|_| unique.contains(&name_key(name))));
        let Some(points) = found.and_then(|index| students.take(index)) else { continue };
        if row.cells.len() <= column {
            row.cells.resize(column + 1, String::new());
        }
        row.cells[column] = points.to_string();
    }
    if !students.is_empty() && !students.found_any() {
        return Err(table.error(None, "has a row for none of the students of this run"));
    }
    let notes = students.not_found(file).into_iter().collect();
    Ok(FilledIn { table, notes })
}

/// Where rows tell whose they are.
struct Columns {
    participant: Option<usize>,
    number: Option<usize>,
    /// One column with the whole name, or the first of two.
    name: Option<(usize, usize)>,
}

impl Columns {
    /// The columns in which the most cells are known.
    fn of(table: &Table, students: &Students<'_>) -> Columns {
        let width = table.rows.iter().map(|row| row.cells.len()).max().unwrap_or(0);
        let best = |known: &dyn Fn(&[String], usize) -> bool| {
            let hits = |at: usize| table.rows.iter().skip(1).filter(|row| known(&row.cells, at)).count();
            let all = (0..width).map(|at| (hits(at), at)).filter(|(hits, _)| *hits > 0);
            // The first of the best.
            all.max_by_key(|(hits, at)| (*hits, width - at)).map(|(hits, at)| (at, hits))
        };
        let cell = |cells: &[String], at: usize| cells.get(at).cloned().unwrap_or_default();
        let participant = best(&|cells, at| {
            let cell = cell(cells, at);
            participant(&cell).is_some_and(|id| students.by_platform_id(id).is_some())
        });
        let number = best(&|cells, at| students.by_number(&cell(cells, at)).is_some());
        let whole = best(&|cells, at| students.by_name(&cell(cells, at)).is_some());
        let two = best(&|cells, at| {
            let both = format!("{} {}", cell(cells, at), cell(cells, at + 1));
            !cell(cells, at + 1).is_empty() && students.by_name(&both).is_some()
        });
        let hits = |found: &Option<(usize, usize)>| found.map_or(0, |(_, hits)| hits);
        let name = match hits(&two) > hits(&whole) {
            true => two.map(|(at, _)| (at, at + 1)),
            false => whole.map(|(at, _)| (at, at)),
        };
        Columns { participant: participant.map(|(at, _)| at), number: number.map(|(at, _)| at), name }
    }

    fn name(&self, cells: &[String]) -> String {
        let Some((first, last)) = self.name else { return String::new() };
        cells.get(first..=last).map(|cells| cells.join(" ")).unwrap_or_default()
    }
}

/// The number in `Participant 123`: digits at the end, behind a word.
fn participant(cell: &str) -> Option<&str> {
    let cell = cell.trim();
    let word = cell.trim_end_matches(|character: char| character.is_ascii_digit());
    let id = &cell[word.len()..];
    (!id.is_empty() && word.chars().any(char::is_alphabetic)).then_some(id)
}
