//! `report.html`: everything about a run, in one page that needs no network.
//!
//! The details of a student stand in the page as text, and become elements when somebody opens them: with ten thousand students the
//! page stays usable.

mod charts;
mod details;
mod figure;
mod overview;
mod rows;
mod statistics;

use std::io::Write;

use crate::book::Book;
use crate::error::Filled;
use crate::page::{self, Page};
use crate::write::Attention;
use figure::View;
use statistics::Statistics;

const STYLE: &str = include_str!("report/report.css");
const SCRIPT: &str = include_str!("report/report.js");

pub(crate) fn write(file: &mut dyn Write, book: &Book<'_>, attention: &[Attention]) -> Filled {
    let statistics = Statistics::of(book)?;
    let view = View::of(book.run.reference_picture.as_ref());
    let title = format!("{}: results", book.run.title);
    let page = Page { title: &title, style: &[page::STYLE, STYLE], script: Some(SCRIPT) };
    write!(file, "{}", page.start())?;
    write!(file, "{}", overview::top(book, &statistics, attention, &view).0)?;
    write!(file, "{}", rows::START)?;
    write!(file, "{}", rows::head(book, &statistics).0)?;
    book.each(|entry, record| -> Filled {
        Ok(writeln!(file, "{}", rows::row(book, &statistics, entry, record, &view).0)?)
    })?;
    write!(file, "{}", rows::END)?;
    write!(file, "{}", overview::bottom(book).0)?;
    write!(file, "{}", Page::END)?;
    Ok(())
}
