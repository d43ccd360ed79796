//! What was done when: lines that are only ever added.

use std::fs::{File, OpenOptions};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use crate::Error;

/// The log's name in the folder of a run.
pub const FILE: &str = "log.txt";

/// The log of one run.
#[derive(Debug)]
pub struct Log {
    path: PathBuf,
    file: File,
}

impl Log {
    /// Opens the log in `folder`, or begins it.
    ///
    /// # Errors
    ///
    /// When it cannot be written.
    pub fn open(folder: &Path) -> Result<Log, Error> {
        let path = folder.join(FILE);
        let file = OpenOptions::new().create(true).append(true).open(&path);
        Ok(Log { file: file.map_err(|error| Error::write(&path, error))?, path })
    }

    /// Adds a line, behind the time in UTC.
    ///
    /// # Errors
    ///
    /// When it cannot be written.
    pub fn say(&self, line: &str) -> Result<(), Error> {
        let line = format!("{} {line}\n", humantime::format_rfc3339_seconds(SystemTime::now()));
        (&self.file).write_all(line.as_bytes()).map_err(|error| Error::write(&self.path, error))
    }
}
