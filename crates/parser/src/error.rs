//! Why a text cannot be read.

use std::fmt;
use std::io;
use std::path::PathBuf;

use crate::Snippet;
use crate::number::BadNumber;
use crate::snippet::{printable, printable_start};
use crate::source::{LONGEST_WORD, Place, Source};

/// What can be wrong with a text of one format: the `ErrorKind` of that format.
pub trait Kind: std::error::Error + From<Problem> {
    /// What the format is called.
    const FORMAT: &'static str;

    /// What to do, in one or two sentences.
    fn help(&self) -> &'static str;
}

/// What can be wrong with a text of any format.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Problem {
    /// The system could not read on.
    #[error("cannot be read: {0}")]
    Io(#[source] io::Error),
    /// The text ends too soon.
    #[error("the file ends here, expected {expected}")]
    Ended {
        /// What could stand there.
        expected: &'static str,
    },
    /// Another word was expected.
    #[error("found `{found}`, expected {expected}")]
    Unexpected {
        /// The word that is there.
        found: String,
        /// What could stand there.
        expected: &'static str,
    },
    /// Version control has left its marks.
    #[error("found `{found}`, expected {format}: this marks a merge conflict that has not been resolved")]
    MergeConflict {
        /// The mark.
        found: String,
        /// What the format is called.
        format: &'static str,
    },
    /// A count is larger than any that can be held.
    #[error("found `{found}`, which is too large, expected {expected}")]
    LargeCount {
        /// The word.
        found: String,
        /// What is counted.
        expected: &'static str,
    },
    /// A number is none that can be used.
    #[error(transparent)]
    Number(NumberError),
}

impl Problem {
    /// What to do, in one or two sentences.
    pub fn help(&self) -> &'static str {
        match self {
            Problem::Io(_) => "Check that the file is a file, and that you may read it.",
            Problem::Ended { .. } => "The file seems to be cut off: get it again from where it came from.",
            Problem::Unexpected { .. } => {
                "Look for a word that is missing, misspelt or too many, here or just above."
            }
            Problem::MergeConflict { .. } => {
                "Keep one of the two versions, and delete the lines that begin with <<<<<<<, ======= and >>>>>>>."
            }
            Problem::LargeCount { .. } => "No file can hold so many: write how many there are.",
            Problem::Number(problem) => problem.help(),
        }
    }
}

/// Why a number cannot be used.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum NumberError {
    /// A number does not look like one.
    #[error("found `{found}`, expected a number")]
    NotANumber {
        /// The word.
        found: String,
    },
    /// A number with a comma or a semicolon.
    #[error("found `{found}`, expected a number without a comma or a semicolon")]
    Separator {
        /// The word.
        found: String,
    },
    /// NaN, or infinity, or too large to be held.
    #[error("found `{found}`, expected a finite number")]
    NotFinite {
        /// The word.
        found: String,
    },
    /// Something is longer than any number.
    #[error("found more than {longest} characters without a blank, expected a number")]
    LongNumber {
        /// The longest that is read.
        longest: usize,
    },
}

impl NumberError {
    /// What to do, in one or two sentences.
    pub fn help(&self) -> &'static str {
        match self {
            NumberError::NotANumber { .. } => "Write a number such as -12.5 or 1e-6.",
            NumberError::Separator { .. } => {
                "Write a point in numbers (1.5, not 1,5), and put blanks between numbers, not commas or semicolons."
            }
            NumberError::NotFinite { .. } => {
                "Such a number has no place in a skeleton. Put the right number there."
            }
            NumberError::LongNumber { .. } => "Look for a blank that is missing.",
        }
    }

    fn new(found: String, problem: BadNumber) -> NumberError {
        match problem {
            BadNumber::NotANumber => NumberError::NotANumber { found },
            BadNumber::Separator => NumberError::Separator { found },
            BadNumber::NotFinite => NumberError::NotFinite { found },
            BadNumber::TooLong => NumberError::LongNumber { longest: LONGEST_WORD },
        }
    }
}

/// Why a text cannot be read, and where.
///
/// Shown as one line that says where and what, the source line with a mark below the place (where there is one to
/// show), and a line that says what to do.
#[derive(Debug)]
pub struct Error<K> {
    place: Place,
    snippet: Option<Snippet>,
    kind: Box<K>,
}

/// Why a file cannot be read.
#[derive(Debug)]
pub enum FileError<K> {
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
        cause: Error<K>,
    },
}

impl<K: Kind> Error<K> {
    /// Where: the line, from 1.
    pub fn line(&self) -> u64 {
        self.place.line
    }

    /// Where in the line: the character, from 1.
    pub fn column(&self) -> u64 {
        self.place.column
    }

    /// What is wrong.
    pub fn kind(&self) -> &K {
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
    pub(crate) fn here(source: &mut Source, kind: K) -> Self {
        let kind = source.take_failure().map_or(kind, |cause| Problem::Io(cause).into());
        let place = source.place();
        let snippet = Some(source.snippet()).filter(|snippet| !snippet.is_empty());
        Error { place, snippet, kind: Box::new(kind) }
    }

    /// An error at a place of `source` that has been left behind, and what is to be shown of its line. As
    /// [`Error::here`], if the system could not read on.
    pub(crate) fn before(place: Place, snippet: Option<Snippet>, source: &mut Source, kind: K) -> Self {
        match source.take_failure() {
            Some(cause) => Error::here(source, Problem::Io(cause).into()),
            None => Error { place, snippet, kind: Box::new(kind) },
        }
    }

    /// The system could not read anything.
    pub(crate) fn unread(cause: io::Error) -> Self {
        Error {
            place: Place { line: 1, column: 1 },
            snippet: None,
            kind: Box::new(Problem::Io(cause).into()),
        }
    }

    /// The next word of `source` is not what was `expected`.
    pub(crate) fn unexpected(source: &mut Source, expected: &'static str) -> Self {
        let problem = match source.peek() {
            [] => Problem::Ended { expected },
            word if is_conflict_mark(word) => {
                Problem::MergeConflict { found: printable_start(word), format: K::FORMAT }
            }
            word => Problem::Unexpected { found: printable_start(word), expected },
        };
        Error::here(source, problem.into())
    }

    /// `word`, the next of `source`, is not a usable number.
    pub(crate) fn bad_number(source: &mut Source, word: &[u8], problem: BadNumber) -> Self {
        let found = printable_start(word);
        let problem = match problem {
            _ if word.is_empty() => Problem::Ended { expected: "a number" },
            _ if is_conflict_mark(word) => Problem::MergeConflict { found, format: K::FORMAT },
            problem => Problem::Number(NumberError::new(found, problem)),
        };
        Error::here(source, problem.into())
    }
}

/// Whether `word` is one of the marks that version control leaves in a file.
pub(crate) fn is_conflict_mark(word: &[u8]) -> bool {
    matches!(word.get(..7), Some(b"<<<<<<<" | b"=======" | b">>>>>>>" | b"|||||||"))
}

impl<K: Kind> fmt::Display for Error<K> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}, column {}: {}", self.line(), self.column(), Details(self))
    }
}

impl<K: Kind> fmt::Display for FileError<K> {
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
struct Details<'a, K>(&'a Error<K>);

impl<K: Kind> fmt::Display for Details<'_, K> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Details(error) = self;
        write!(f, "{}", error.kind)?;
        if let Some(snippet) = error.snippet() {
            write!(f, "\n{snippet}")?;
        }
        write!(f, "\n{}", error.help())
    }
}

impl<K: Kind> std::error::Error for Error<K> {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        std::error::Error::source(&*self.kind)
    }
}

impl<K: Kind> std::error::Error for FileError<K> {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            FileError::Open { cause, .. } => Some(cause),
            FileError::Read { cause, .. } => std::error::Error::source(cause),
        }
    }
}
