//! Why a text cannot be read.

use std::fmt;
use std::io;
use std::path::PathBuf;

use super::ErrorKind;
use crate::Snippet;
use crate::number::BadNumber;
use crate::snippet::{printable, printable_start};
use crate::source::{LONGEST_WORD, Place, Source};

/// Why a text cannot be read, and where.
///
/// Shown as one line that says where and what, the source line with a mark below the place (where there is one to
/// show), and a line that says what to do.
#[derive(Debug)]
pub struct Error {
    place: Place,
    snippet: Option<Snippet>,
    kind: Box<ErrorKind>,
}

/// Why a file cannot be read.
#[derive(Debug)]
pub enum FileError {
    /// It cannot be opened.
    Open {
        /// The file.
        path: PathBuf,
        /// What the system says.
        cause: io::Error,
    },
    /// It has been opened, but cannot be read.
    Read {
        /// The file.
        path: PathBuf,
        /// What is wrong in it, and where.
        cause: Error,
    },
}

impl Error {
    /// Where: the line, from 1.
    pub fn line(&self) -> u64 {
        self.place.line
    }

    /// Where in the line: the character, from 1.
    pub fn column(&self) -> u64 {
        self.place.column
    }

    /// What is wrong.
    pub fn kind(&self) -> &ErrorKind {
        &self.kind
    }

    /// The source line, or the part of it around the place; `None` when it is empty or has been left behind.
    pub fn snippet(&self) -> Option<&Snippet> {
        self.snippet.as_ref()
    }

    /// What to do, in one or two sentences.
    pub fn help(&self) -> &'static str {
        self.kind.help()
    }

    /// An error at the next word of `source`. If the text only seems to be at fault because the system could not
    /// read on, the error says that.
    pub(super) fn here(source: &mut Source, kind: ErrorKind) -> Self {
        let kind = source.take_failure().map_or(kind, ErrorKind::Io);
        let place = source.place();
        let snippet = Some(source.snippet()).filter(|snippet| !snippet.is_empty());
        Error { place, snippet, kind: Box::new(kind) }
    }

    /// An error at a place of `source` that has been left behind, and what is to be shown of its line. As
    /// [`Error::here`], if the system could not read on.
    pub(super) fn before(
        place: Place,
        snippet: Option<Snippet>,
        source: &mut Source,
        kind: ErrorKind,
    ) -> Self {
        match source.take_failure() {
            Some(cause) => Error::here(source, ErrorKind::Io(cause)),
            None => Error { place, snippet, kind: Box::new(kind) },
        }
    }

    /// The system could not read anything.
    pub(super) fn unread(cause: io::Error) -> Self {
        Error { place: Place { line: 1, column: 1 }, snippet: None, kind: Box::new(ErrorKind::Io(cause)) }
    }

    /// The next word of `source` is not what was `expected`.
    pub(super) fn unexpected(source: &mut Source, expected: &'static str) -> Self {
        let kind = match source.peek() {
            [] => ErrorKind::Ended { expected },
            word if is_conflict_mark(word) => ErrorKind::MergeConflict { found: printable_start(word) },
            word => ErrorKind::Unexpected { found: printable_start(word), expected },
        };
        Error::here(source, kind)
    }

    /// `word`, the next of `source`, is not a usable number.
    pub(super) fn bad_number(source: &mut Source, word: &[u8], problem: BadNumber) -> Self {
        let found = printable_start(word);
        let kind = match problem {
            _ if word.is_empty() => ErrorKind::Ended { expected: "a number" },
            _ if is_conflict_mark(word) => ErrorKind::MergeConflict { found },
            BadNumber::NotANumber => ErrorKind::NotANumber { found },
            BadNumber::Separator => ErrorKind::Separator { found },
            BadNumber::NotFinite => ErrorKind::NotFinite { found },
            BadNumber::TooLong => ErrorKind::LongNumber { longest: LONGEST_WORD },
        };
        Error::here(source, kind)
    }
}

/// Whether `word` is one of the marks that version control leaves in a file.
pub(super) fn is_conflict_mark(word: &[u8]) -> bool {
    matches!(word.get(..7), Some(b"<<<<<<<" | b"=======" | b">>>>>>>" | b"|||||||"))
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}, column {}: {}", self.line(), self.column(), Details(self))
    }
}

impl fmt::Display for FileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (FileError::Open { path, .. } | FileError::Read { path, .. }) = self;
        write!(f, "{}:", printable(&path.to_string_lossy()))?;
        match self {
            FileError::Open { cause, .. } => write!(f, " cannot be opened: {cause}"),
            FileError::Read { cause, .. } => {
                write!(f, "{}:{}: {}", cause.line(), cause.column(), Details(cause))
            }
        }
    }
}

/// All of an error but the place.
struct Details<'a>(&'a Error);

impl fmt::Display for Details<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Details(error) = self;
        write!(f, "{}", error.kind)?;
        if let Some(snippet) = error.snippet() {
            write!(f, "\n{snippet}")?;
        }
        write!(f, "\n{}", error.help())
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        std::error::Error::source(&*self.kind)
    }
}

impl std::error::Error for FileError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            FileError::Open { cause, .. } => Some(cause),
            FileError::Read { cause, .. } => std::error::Error::source(cause),
        }
    }
}
