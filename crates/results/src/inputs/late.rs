//! Who was late, and by how much.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use super::table::Table;
use crate::{Error, LatePolicy};

/// Days late by student number.
#[derive(Clone, Debug)]
pub struct LateList {
    pub(crate) path: PathBuf,
    pub(crate) policy: LatePolicy,
    pub(crate) days: HashMap<String, Days>,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Days {
    pub days: u32,
    pub line: u64,
}

const NUMBER: &[&str] = &["number", "student", "studentnumber", "studentid", "matrikelnummer", "id"];
const DAYS: &[&str] = &["days", "dayslate", "late"];

impl LateList {
    /// Reads a table with the columns `number` and `days`, or, without a header, these two.
    ///
    /// # Errors
    ///
    /// When the file cannot be read, days are no whole number, or a student stands there twice.
    pub fn read(path: &Path, policy: LatePolicy) -> Result<LateList, Error> {
        let table = Table::read(path)?;
        let ([number, days_column], rows) = table.columns([NUMBER, DAYS]);
        if number.is_none() || days_column.is_none() {
            return Err(table.error(1, "the header needs a column `number` and a column `days`"));
        }
        let mut days = HashMap::new();
        for row in rows.iter().filter(|row| !row.is_blank()) {
            let (number, cell) = (row.cell(number), row.cell(days_column));
            let Ok(count) = cell.parse() else {
                let what = format!("expected a whole number of days, found `{cell}`");
                return Err(table.error(row.line, what));
            };
            let late = Days { days: count, line: row.line };
            if number.is_empty() || days.insert(number.to_owned(), late).is_some() {
                return Err(table.error(row.line, "expected a student number that stands here only once"));
            }
        }
        Ok(LateList { path: path.to_owned(), policy, days })
    }
}
