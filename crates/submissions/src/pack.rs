//! Makes the archive that a student hands in.

use std::io::{self, Write};

use flate2::Compression;
use flate2::write::DeflateEncoder;
use rawzip::time::UtcDateTime;
use rawzip::{CompressionMethod, ZipArchiveWriter};

use crate::printable::{is_invisible, printable};
use crate::source::normalise;
use crate::{MAX_SOURCE, Rejection, Wanted};

/// An archive to hand in.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Packed {
    /// What to call it, such as `300000001_TerryFox.zip`.
    pub file_name: String,
    /// Its bytes.
    pub bytes: Vec<u8>,
    /// What the student should know of the source file, in plain sentences.
    pub remarks: Vec<String>,
}

/// Why no archive was made. The messages are for students.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum PackError {
    /// The student number is not one.
    #[error(
        "{found:?} cannot be a student number: it should have 5 to 12 digits and nothing else, like 300000001."
    )]
    Number {
        /// What was given, fit to be shown.
        found: String,
    },
    /// There is no letter in the name.
    #[error("Please give your name as well, like \"Terry Fox\".")]
    NoName,
    /// The name is too long for a file name.
    #[error(
        "The name has {letters} letters, which is too long for a file name. Please give a shorter form, at most {MAX_NAME}."
    )]
    LongName {
        /// How many letters and digits it has.
        letters: usize,
    },
    /// The source file would be rejected.
    #[error("{}", .0.why)]
    Source(Rejection),
    /// The archive could not be made.
    #[error("The zip file could not be made: {0}.")]
    Zip(String),
}

/// The longest name, in letters. In the longest letters it still fits into the file names of all systems.
const MAX_NAME: usize = 50;

/// The archive `NUMBER_Name.zip` with one file in it, whose bytes are those of `source`. The same input gives the same bytes.
///
/// In the file name, words begin with a capital letter and are joined, and what a file name should not hold is dropped: `Terry
/// Fox` becomes `TerryFox`, `Zoë O'Neil-King` becomes `ZoëONeil-King`. Letters of all scripts are kept.
///
/// # Errors
///
/// When the number or the name is not usable, or the source would be rejected.
pub fn write_zip(number: &str, name: &str, source: &[u8], wanted: &Wanted) -> Result<Packed, PackError> {
    let number = number.trim();
    if !(5..=12).contains(&number.len()) || !number.bytes().all(|byte| byte.is_ascii_digit()) {
        return Err(PackError::Number { found: printable(number) });
    }
    let name = joined(name);
    let letters = name.chars().count();
    if !name.chars().any(char::is_alphabetic) {
        return Err(PackError::NoName);
    }
    if letters > MAX_NAME {
        return Err(PackError::LongName { letters });
    }
    if source.len() as u64 > MAX_SOURCE {
        let found = format!("The file is larger than {} KiB, which no solution is.", MAX_SOURCE / 1024);
        return Err(PackError::Source(Rejection::new("too_large", found, wanted)));
    }
    let checked = normalise(source, Vec::new(), wanted).map_err(PackError::Source)?;
    let bytes = zip(&wanted.file_name, source).map_err(|error| PackError::Zip(error.to_string()))?;
    Ok(Packed { file_name: format!("{number}_{name}.zip"), bytes, remarks: checked.remarks })
}

/// The words of a name, each with a capital letter in front, without what a file name should not hold.
fn joined(name: &str) -> String {
    let mut joined = String::new();
    for word in name.split(|c: char| c.is_whitespace() || c == '_') {
        let mut letters = word.chars().filter(|c| is_fit(*c));
        if let Some(first) = letters.next() {
            joined.extend(first.to_uppercase());
            joined.extend(letters);
        }
    }
    joined.trim_matches('-').to_owned()
}

fn is_fit(c: char) -> bool {
    if c.is_ascii() { c.is_ascii_alphanumeric() || c == '-' } else { !is_invisible(c) && !c.is_whitespace() }
}

fn zip(file_name: &str, source: &[u8]) -> io::Result<Vec<u8>> {
    // The earliest that a zip file can say: what is in the file is not when it was packed.
    let time = UtcDateTime::from_components(1980, 1, 1, 0, 0, 0, 0);
    let mut archive = ZipArchiveWriter::new(Vec::new());
    let file = archive
        .new_file(file_name)
        .compression_method(CompressionMethod::DEFLATE)
        .unix_permissions(0o100_644);
    let file = match time {
        Some(time) => file.last_modified(time),
        None => file,
    };
    let (mut entry, config) = file.start().map_err(io::Error::other)?;
    let mut writer = config.wrap(DeflateEncoder::new(&mut entry, Compression::best()));
    writer.write_all(source)?;
    let (encoder, descriptor) = writer.finish().map_err(io::Error::other)?;
    encoder.finish()?;
    entry.finish(descriptor).map_err(io::Error::other)?;
    archive.finish().map_err(io::Error::other)
}
