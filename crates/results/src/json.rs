//! `results.json`: the run, and every record with its mark, one in a line.

use std::io::{self, Write};

use serde::Serialize;

use crate::book::Book;
use crate::error::Filled;
use crate::{Mark, Record};

#[derive(Serialize)]
struct Line<'a> {
    #[serde(flatten)]
    record: &'a Record,
    mark: &'a Mark,
}

pub(crate) fn write(file: &mut dyn Write, book: &Book<'_>) -> Filled {
    write!(file, "{{\"run\":")?;
    to_writer(file, book.run)?;
    write!(file, ",\n\"similar\":")?;
    to_writer(file, &book.groups)?;
    write!(file, ",\n\"records\":[")?;
    let mut separator = "\n";
    book.each(|entry, record| -> Filled {
        write!(file, "{separator}")?;
        separator = ",\n";
        Ok(to_writer(file, &Line { record, mark: &entry.mark })?)
    })?;
    Ok(writeln!(file, "\n]}}")?)
}

fn to_writer(file: &mut dyn Write, value: &impl Serialize) -> io::Result<()> {
    serde_json::to_writer(file, value).map_err(io::Error::from)
}
