//! The tables of learning platforms: their own export, with one column filled in and all else left as it is.

mod canvas;
mod matching;
mod moodle;

use std::io::Write;

use crate::error::{Error, Filled};
use crate::inputs::Table;

pub(crate) use canvas::canvas;
pub(crate) use moodle::moodle;

/// A platform's table with the points in it.
pub(crate) struct FilledIn {
    table: Table,
    /// What somebody should look at.
    pub notes: Vec<String>,
}

impl FilledIn {
    pub fn write(&self, file: &mut dyn Write) -> Filled {
        if self.table.marked {
            file.write_all("\u{feff}".as_bytes())?;
        }
        let end = if self.table.crlf { csv::Terminator::CRLF } else { csv::Terminator::Any(b'\n') };
        let mut table = csv::WriterBuilder::new()
            .delimiter(self.table.delimiter)
            .terminator(end)
            .flexible(true)
            .from_writer(file);
        for row in &self.table.rows {
            table.write_record(&row.cells).map_err(std::io::Error::from)?;
        }
        Ok(table.flush()?)
    }
}

/// The column that takes the points: the one that is asked for, or else the only one that `fits`.
fn target(
    table: &Table,
    asked: Option<&str>,
    option: &str,
    fits: impl Fn(&str) -> bool,
) -> Result<usize, Error> {
    let header = &table.rows[0].cells;
    let is_asked = |name: &str| match asked {
        // Canvas adds the assignment's number: `FK (4711)`.
        Some(asked) => {
            let rest = name.trim().strip_prefix(asked.trim());
            rest.is_some_and(|rest| rest.is_empty() || (rest.starts_with(" (") && rest.ends_with(')')))
        }
        None => fits(name),
    };
    let found: Vec<usize> = (0..header.len()).filter(|column| is_asked(&header[*column])).collect();
    match found.as_slice() {
        [column] => Ok(*column),
        _ => {
            let number = if found.is_empty() { "no" } else { "more than one" };
            let names: Vec<String> = header.iter().map(|name| format!("`{}`", name.trim())).collect();
            let what = match asked {
                Some(asked) => format!("has {number} column `{asked}`"),
                None => format!(
                    "has {number} column that is surely the one for the points; name it with {option}"
                ),
            };
            Err(table.error(1, format!("{what}. Its columns: {}", names.join(", "))))
        }
    }
}
