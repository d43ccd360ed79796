//! What can go wrong with inputs and outputs.

use std::io;
use std::path::{Path, PathBuf};

/// Why the results could not be written. What had been written before is whole.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// A file that the teaching assistant gave cannot be used.
    #[error("{}{}: {what}", path.display(), line.map(|line| format!(", line {line}")).unwrap_or_default())]
    Input {
        /// The file.
        path: PathBuf,
        /// The line, from 1, when the trouble is in one.
        line: Option<u64>,
        /// What is wrong, and what was expected.
        what: String,
    },
    /// A file could not be written. Nothing half written is left in its place.
    #[error("cannot write {}: {source}", path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// The records could not be read.
    #[error("cannot read the results of the submissions: {0}")]
    Records(io::Error),
    /// The records cannot all be told apart, or are not the same when they are read again.
    #[error("the results of the submissions are not usable: {0}")]
    BadRecords(String),
    /// What was asked for does not go together.
    #[error("{0}")]
    Options(String),
}

impl Error {
    pub(crate) fn input(path: &Path, line: impl Into<Option<u64>>, what: impl Into<String>) -> Error {
        Error::Input { path: path.to_owned(), line: line.into(), what: what.into() }
    }

    pub(crate) fn write(path: &Path) -> impl FnOnce(io::Error) -> Error {
        let path = path.to_owned();
        move |source| Error::Write { path, source }
    }
}

/// What can go wrong while a file is being filled.
#[derive(Debug)]
pub(crate) enum Trouble {
    /// The file itself.
    Write(io::Error),
    /// Something else.
    Other(Error),
}

/// How filling a file ends.
pub(crate) type Filled = Result<(), Trouble>;

impl From<io::Error> for Trouble {
    fn from(source: io::Error) -> Trouble {
        Trouble::Write(source)
    }
}

impl From<Error> for Trouble {
    fn from(other: Error) -> Trouble {
        Trouble::Other(other)
    }
}

impl Trouble {
    pub(crate) fn at(self, path: &Path) -> Error {
        match self {
            Trouble::Write(source) => Error::Write { path: path.to_owned(), source },
            Trouble::Other(error) => error,
        }
    }
}
