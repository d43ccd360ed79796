//! Why a text cannot be read.

use std::fmt;
use std::io;
use std::path::PathBuf;

use skeleton::{Channel, MotionError, SkeletonError};

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

/// What is wrong: what was found and what was expected.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ErrorKind {
    /// The system could not read on.
    #[error("cannot be read: {0}")]
    Io(#[source] io::Error),
    /// There is no text at all.
    #[error("the file is empty; a BVH file begins with HIERARCHY")]
    Empty,
    /// Something else altogether.
    #[error("this is not a BVH file: it begins with `{found}`{guess}; a BVH file begins with HIERARCHY")]
    NotBvh {
        /// The first word.
        found: String,
        /// What it may be, as ` (…)`, or nothing.
        guess: &'static str,
    },
    /// Version control has left its marks.
    #[error("`{found}` marks a merge conflict that has not been resolved")]
    MergeConflict {
        /// The mark.
        found: String,
    },
    /// Another word was expected.
    #[error("found `{found}`, expected {expected}")]
    Unexpected {
        /// The word that is there.
        found: String,
        /// What could stand there.
        expected: &'static str,
    },
    /// The text ends too soon.
    #[error("the file ends here, expected {expected}")]
    Ended {
        /// What could stand there.
        expected: &'static str,
    },
    /// A joint has no name.
    #[error("a joint needs a name, on the same line as its {keyword}")]
    NoName {
        /// `ROOT` or `JOINT`.
        keyword: &'static str,
    },
    /// A name is longer than any name should be.
    #[error("this name is longer than {longest} bytes")]
    LongName {
        /// The longest that is read.
        longest: usize,
    },
    /// No channel is called like this.
    #[error("`{found}` is not a channel")]
    UnknownChannel {
        /// The word.
        found: String,
    },
    /// A joint lists one channel twice.
    #[error("{channel} is listed twice in the same joint")]
    RepeatedChannel {
        /// The channel.
        channel: Channel,
    },
    /// A joint lists more or fewer channels than it says.
    #[error("CHANNELS says {declared}, but {listed} are listed")]
    ChannelCount {
        /// The number behind `CHANNELS`.
        declared: u64,
        /// How many channels follow.
        listed: u64,
    },
    /// A joint is still open where none may be.
    #[error("a `}}` is missing: the joint `{joint}`, opened in line {line}, is not closed")]
    NotClosed {
        /// The innermost open joint's name.
        joint: String,
        /// Where it begins.
        line: u64,
    },
    /// There is one closing brace too many.
    #[error("this `}}` closes nothing: every joint has been closed before")]
    NothingToClose,
    /// A number does not look like one.
    #[error("`{found}` is not a number")]
    NotANumber {
        /// The word.
        found: String,
    },
    /// A number with a comma.
    #[error("`{found}` has a comma in it")]
    Comma {
        /// The word.
        found: String,
    },
    /// NaN, or infinity, or too large to be held.
    #[error("`{found}` is not a finite number")]
    NotFinite {
        /// The word.
        found: String,
    },
    /// Something is longer than any number.
    #[error("a number longer than {longest} characters, or no number")]
    LongNumber {
        /// The longest that is read.
        longest: usize,
    },
    /// The skeleton does not take a joint.
    #[error("{0}")]
    Skeleton(#[source] SkeletonError),
    /// The numbers do not make whole frames.
    #[error("{0}")]
    Motion(#[source] MotionError),
    /// The rows hold other numbers of values than there are channels.
    #[error("this line holds {width} numbers, but the skeleton has {channels} channels")]
    RowWidth {
        /// Numbers on the line.
        width: u64,
        /// Channels of all joints.
        channels: u64,
    },
    /// The text ends before all frames are there.
    #[error(
        "too few numbers: {frames} frames × {channels} channels need {}, found {found}. {}",
        u128::from(*frames) * u128::from(*channels),
        about_rows(*odd_line, *found, *channels)
    )]
    TooFewNumbers {
        /// Frames that the text declares.
        frames: u64,
        /// Channels of all joints.
        channels: u64,
        /// Numbers that are there.
        found: u64,
        /// The first line with another count of numbers than there are channels, and its count.
        odd_line: Option<(u64, u64)>,
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

    /// An error at a place of `source` that has been left behind. As [`Error::here`], if the system could not
    /// read on.
    pub(super) fn before(place: Place, source: &mut Source, kind: ErrorKind) -> Self {
        match source.take_failure() {
            Some(cause) => Error::here(source, ErrorKind::Io(cause)),
            None => Error { place, snippet: None, kind: Box::new(kind) },
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
            BadNumber::Comma => ErrorKind::Comma { found },
            BadNumber::NotFinite => ErrorKind::NotFinite { found },
            BadNumber::TooLong => ErrorKind::LongNumber { longest: LONGEST_WORD },
        };
        Error::here(source, kind)
    }
}

impl ErrorKind {
    fn help(&self) -> &'static str {
        match self {
            ErrorKind::Io(_) => "Check that the file is a file, and that you may read it.",
            ErrorKind::Empty | ErrorKind::NotBvh { .. } => "Check that this is the file you mean.",
            ErrorKind::MergeConflict { .. } => {
                "Keep one of the two versions, and delete the lines that begin with <<<<<<<, ======= and >>>>>>>."
            }
            ErrorKind::Unexpected { .. } => {
                "Look for a word that is missing, misspelt or too many, here or just above."
            }
            ErrorKind::Ended { .. } => "The file seems to be cut off: get it again from where it came from.",
            ErrorKind::NoName { .. } => "Write a name behind the word.",
            ErrorKind::LongName { .. } => "Shorten the name; or look for a line break that is missing.",
            ErrorKind::UnknownChannel { .. } => {
                "Write one of Xposition, Yposition, Zposition, Xrotation, Yrotation and Zrotation."
            }
            ErrorKind::RepeatedChannel { .. } => {
                "A joint can have each of the six channels once: correct the word."
            }
            ErrorKind::ChannelCount { .. } => "Make the number and the words behind it agree.",
            ErrorKind::NotClosed { .. } => "Every `{` needs its `}`: write it where the joint ends.",
            ErrorKind::NothingToClose => "Delete it, or look for a `{` that is missing above.",
            ErrorKind::NotANumber { .. } => "Write a number such as -12.5 or 1e-6.",
            ErrorKind::Comma { .. } => {
                "Write a point in numbers (1.5, not 1,5), and put blanks between numbers, not commas."
            }
            ErrorKind::NotFinite { .. } => {
                "Such a number has no place in a skeleton. Put the right number there."
            }
            ErrorKind::LongNumber { .. } => "Look for a blank that is missing.",
            ErrorKind::Skeleton(_) | ErrorKind::Motion(_) => "Look at the lines just above.",
            ErrorKind::RowWidth { .. } => {
                "Every frame has one number for each channel. Do the CHANNELS above belong to these frames?"
            }
            ErrorKind::TooFewNumbers { .. } => {
                "Correct the number behind `Frames:`, or get the file again if it is cut off."
            }
        }
    }
}

/// Whether `word` is one of the marks that version control leaves in a file.
pub(super) fn is_conflict_mark(word: &[u8]) -> bool {
    matches!(word.get(..7), Some(b"<<<<<<<" | b"=======" | b">>>>>>>" | b"|||||||"))
}

fn about_rows(odd_line: Option<(u64, u64)>, found: u64, channels: u64) -> String {
    match odd_line {
        Some((line, width)) => {
            format!("Line {line} is the first that holds {width} numbers instead of {channels}")
        }
        None if found == 0 => String::from("There are no frames at all"),
        None => format!("Every line holds {channels} numbers, as it should"),
    }
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
