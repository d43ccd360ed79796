//! From bytes to a text, whatever its encoding, and what holds for texts of all formats.

use std::fs::File;
use std::io::{Chain, Read};
use std::path::{Path, PathBuf};

use crate::encoding::{self, Encoding, FromUtf16};
use crate::error::{Error, FileError, Kind, Problem};
use crate::source::{Source, Syntax};
use crate::warning::Warning;

/// Reads a text by `read`, which is given the first warnings: one of kind `utf16` if the text is UTF-16.
pub(crate) fn read<T, K: Kind, W>(
    input: impl Read,
    syntax: Syntax,
    utf16: W,
    read: impl FnOnce(&mut Source, Vec<Warning<W>>) -> Result<T, Error<K>>,
) -> Result<T, Error<K>> {
    let mut input = input;
    let mut first = Vec::with_capacity(4);
    input.by_ref().take(4).read_to_end(&mut first).map_err(Error::unread)?;
    let (encoding, mark) = encoding::detect(&first);
    let mut text: Chain<&[u8], _> = first[mark..].chain(input);
    match encoding {
        Encoding::Utf8 => read(&mut Source::new(&mut text, syntax), Vec::new()),
        Encoding::Utf16 { little_endian } => {
            let warning = Warning { line: 1, column: 1, kind: utf16 };
            let mut text = FromUtf16::new(text, little_endian);
            read(&mut Source::new(&mut text, syntax), vec![warning])
        }
    }
}

/// Opens a file and reads it by `read`.
pub(crate) fn read_file<T, K>(
    path: &Path,
    read: impl FnOnce(File) -> Result<T, Error<K>>,
) -> Result<T, FileError<K>> {
    let file = File::open(path).map_err(|cause| FileError::Open { path: PathBuf::from(path), cause })?;
    read(file).map_err(|cause| FileError::Read { path: PathBuf::from(path), cause })
}

/// To be called when all has been read: adds a warning if a line ended with a carriage return alone, and sorts the
/// warnings by place. Fails if the text only seemed to end because the system could not read on.
pub(crate) fn finish<K: Kind, W>(
    source: &mut Source,
    mut warnings: Vec<Warning<W>>,
    lone_return: W,
) -> Result<Vec<Warning<W>>, Error<K>> {
    if let Some(line) = source.lone_return() {
        warnings.push(Warning { line, column: 1, kind: lone_return });
    }
    if let Some(cause) = source.take_failure() {
        return Err(Error::here(source, Problem::Io(cause).into()));
    }
    warnings.sort_by_key(|warning| (warning.line, warning.column));
    Ok(warnings)
}
