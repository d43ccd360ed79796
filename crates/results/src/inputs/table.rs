//! Tables as spreadsheets save them.

use std::fs::{self, File};
use std::io::Read;
use std::path::{Path, PathBuf};

use crate::Error;

/// No roster and no gradebook is longer, in bytes.
const LONGEST: u64 = 64 << 20;

/// A table, cell by cell. The first row is often a header.
#[derive(Clone, Debug)]
pub(crate) struct Table {
    pub path: PathBuf,
    pub rows: Vec<Row>,
    /// What stands between two cells.
    pub delimiter: u8,
    /// Whether the file begins with a byte order mark.
    pub marked: bool,
    /// Whether its lines end in CR LF.
    pub crlf: bool,
}

#[derive(Clone, Debug)]
pub(crate) struct Row {
    /// Where the row begins, from 1.
    pub line: u64,
    pub cells: Vec<String>,
}

impl Table {
    /// Reads cells between commas, semicolons or tabs, whichever the first line has most of.
    pub fn read(path: &Path) -> Result<Table, Error> {
        let text = read_text(path)?;
        let (marked, text) = match text.strip_prefix('\u{feff}') {
            Some(rest) => (true, rest),
            None => (false, text.as_str()),
        };
        let first = text.lines().next().unwrap_or_default();
        let delimiter = delimiter_of(first);
        let crlf = text.split_inclusive('\n').next().is_some_and(|line| line.ends_with("\r\n"));
        let mut reader = csv::ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .delimiter(delimiter)
            .from_reader(text.as_bytes());
        let mut rows = Vec::new();
        let (mut line, mut counted) = (1, 0);
        for record in reader.records() {
            let record = record.map_err(|trouble| Error::input(path, None, trouble.to_string()))?;
            // The position may be that of blank lines before.
            let start = record.position().map_or(0, |position| position.byte() as usize);
            while let Some(byte) = text.as_bytes().get(counted) {
                if counted >= start && !matches!(byte, b'\r' | b'\n') {
                    break;
                }
                line += u64::from(*byte == b'\n');
                counted += 1;
            }
            rows.push(Row { line, cells: record.iter().map(str::to_owned).collect() });
        }
        if rows.is_empty() {
            return Err(Error::input(path, None, "the file is empty"));
        }
        Ok(Table { path: path.to_owned(), rows, delimiter, marked, crlf })
    }

    /// The columns with these names, and the rows below; without a header, the columns in the given order.
    ///
    /// A first row is a header when it has a cell that is one of the names.
    pub fn columns<const N: usize>(&self, names: [&[&str]; N]) -> ([Option<usize>; N], &[Row]) {
        let Some((first, rest)) = self.rows.split_first() else { return ([None; N], &[]) };
        let found = names.map(|names| {
            // The first name is the best one.
            names.iter().find_map(|name| first.cells.iter().position(|cell| squeezed(cell) == *name))
        });
        if found.iter().any(Option::is_some) {
            return (found, rest);
        }
        let mut next = 0;
        let in_order = names.map(|_| {
            next += 1;
            Some(next - 1)
        });
        (in_order, &self.rows)
    }

    pub fn error(&self, line: impl Into<Option<u64>>, what: impl Into<String>) -> Error {
        Error::input(&self.path, line, what)
    }
}

impl Row {
    /// The cell without blanks around it; empty where there is none.
    pub fn cell(&self, column: Option<usize>) -> &str {
        column.and_then(|column| self.cells.get(column)).map_or("", |cell| cell.trim())
    }

    pub fn is_blank(&self) -> bool {
        self.cells.iter().all(|cell| cell.trim().is_empty())
    }
}

fn read_text(path: &Path) -> Result<String, Error> {
    let unreadable = |trouble: std::io::Error| Error::input(path, None, format!("cannot be read: {trouble}"));
    let length = fs::metadata(path).map_err(unreadable)?.len();
    let too_long = || Error::input(path, None, format!("is longer than {} MiB", LONGEST >> 20));
    if length > LONGEST {
        return Err(too_long());
    }
    let mut bytes = Vec::new();
    File::open(path).map_err(unreadable)?.take(LONGEST + 1).read_to_end(&mut bytes).map_err(unreadable)?;
    if bytes.len() as u64 > LONGEST {
        return Err(too_long());
    }
    String::from_utf8(bytes).map_err(|trouble| {
        let good = &trouble.as_bytes()[..trouble.utf8_error().valid_up_to()];
        let line = good.iter().filter(|byte| **byte == b'\n').count() as u64 + 1;
        Error::input(path, line, "is not UTF-8; save the table again as `CSV UTF-8`")
    })
}

fn delimiter_of(line: &str) -> u8 {
    let mut best = (b',', 0);
    for delimiter in [b',', b';', b'\t'] {
        let mut quoted = false;
        let count = line.bytes().filter(|byte| {
            quoted ^= *byte == b'"';
            !quoted && *byte == delimiter
        });
        let count = count.count();
        if count > best.1 {
            best = (delimiter, count);
        }
    }
    best.0
}

/// A header's name without case, blanks and punctuation: `Student-ID:` is `studentid`.
pub(crate) fn squeezed(text: &str) -> String {
    text.chars().filter(|character| character.is_alphanumeric()).flat_map(char::to_lowercase).collect()
}
