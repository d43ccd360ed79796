//! What a student reads: every point explained, in plain words.
//!
//! A [`letter`] says what is to be said; it is then written as Markdown, as a page, and for Gradescope.

mod gradescope;
mod html;
mod letter;
mod markdown;

use std::path::Path;

use crate::Verdict;
use crate::book::Book;
use crate::error::{Error, Filled};
use crate::files::{Readers, make_folder, remove_leftovers, write_whole};

pub use gradescope::gradescope;

/// Writes `ID.md` and `ID.html` for every submission. Who handed in nothing gets none.
pub(crate) fn write_folder(folder: &Path, book: &Book<'_>) -> Result<(), Error> {
    make_folder(folder)?;
    remove_leftovers(folder)?;
    book.each(|entry, record| -> Result<(), Error> {
        if matches!(record.verdict, Verdict::Missing) && entry.mark.points.is_none() {
            return Ok(());
        }
        let letter = letter::letter(book.run, record, &entry.mark);
        let write = |extension, text: String| {
            let path = folder.join(format!("{}.{extension}", entry.id));
            write_whole(&path, Readers::Usual, |file| -> Filled { Ok(file.write_all(text.as_bytes())?) })
        };
        write("md", markdown::page(&letter))?;
        write("html", html::page(&letter))
    })
}
