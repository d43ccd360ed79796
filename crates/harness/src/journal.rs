//! What is done so far, on disk: one line of JSON per submission, appended as soon as it is marked.
//!
//! Whatever ends a run, what stands here is done. A line that broke off is cut away when the journal is opened again.

use std::collections::BTreeMap;
use std::fs::{File, OpenOptions, TryLockError};
use std::io::{self, BufRead, BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use results::{Record, RunInfo};
use serde::{Deserialize, Serialize};
use submissions::similar::Fingerprint;

use crate::Error;

/// The journal's name in the folder of a run.
pub const FILE: &str = "journal.jsonl";

/// The first line: what run this is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Header {
    /// Everything that marks depend on.
    pub info: RunInfo,
    /// How many submissions there are, in all shares together.
    pub total: usize,
    /// The SHA-256 of their ids.
    pub digest: String,
}

/// Every other line: a submission that is done.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Done {
    /// What became of it.
    pub record: Record,
    /// The SHA-256 of the text that was compiled. What has the same is compiled once.
    pub source: Option<String>,
    /// What similar files have in common.
    pub fingerprint: Option<Fingerprint>,
    /// The compiler's and the linker's time on the processor, in milliseconds.
    pub compile_ms: u64,
    /// How long it was asked, in milliseconds.
    pub run_ms: u64,
}

/// The journal of one run.
#[derive(Debug)]
pub struct Journal {
    path: PathBuf,
    header: Header,
    state: Mutex<State>,
}

#[derive(Debug)]
struct State {
    file: File,
    end: u64,
    synced: Instant,
    /// Where the last line about each submission begins.
    places: BTreeMap<String, u64>,
}

impl Journal {
    /// Begins a journal in `folder`.
    ///
    /// # Errors
    ///
    /// When there is one already, or the folder cannot be written.
    pub fn begin(folder: &Path, header: Header) -> Result<Journal, Error> {
        let path = folder.join(FILE);
        let trouble = |error: io::Error| Error::write(&path, error);
        let file = OpenOptions::new().read(true).append(true).create_new(true).open(&path);
        let file = file.map_err(|error| match error.kind() {
            io::ErrorKind::AlreadyExists => Error::RunExists(folder.to_path_buf()),
            _ => trouble(error),
        })?;
        lock(&file, folder)?;
        let mut state = State { file, end: 0, synced: Instant::now(), places: BTreeMap::new() };
        state.append(&header).map_err(trouble)?;
        state.file.sync_all().map_err(trouble)?;
        Ok(Journal { state: Mutex::new(state), header, path })
    }

    /// Opens the journal in `folder` again.
    ///
    /// # Errors
    ///
    /// When there is none, when it cannot be read, or when another program is at work on it.
    pub fn resume(folder: &Path) -> Result<Journal, Error> {
        let path = folder.join(FILE);
        let trouble = |error: io::Error| Error::read(&path, error);
        let file = OpenOptions::new().read(true).append(true).open(&path);
        let file = file.map_err(|error| match error.kind() {
            io::ErrorKind::NotFound => Error::NoRun(folder.to_path_buf()),
            _ => trouble(error),
        })?;
        lock(&file, folder)?;
        let Contents { header, places, end } = Contents::read(&path)?;
        file.set_len(end).map_err(trouble)?;
        let state = State { file, end, synced: Instant::now(), places };
        Ok(Journal { state: Mutex::new(state), header, path })
    }

    /// What run this is.
    pub fn header(&self) -> &Header {
        &self.header
    }

    /// Writes down that a submission is done. At most a second of work is lost when the power fails.
    ///
    /// # Errors
    ///
    /// When it cannot be written.
    pub fn append(&self, done: &Done) -> Result<(), Error> {
        let mut state = self.state();
        let place = state.end;
        let result = state.append(done).and_then(|()| {
            if state.synced.elapsed() >= Duration::from_secs(1) {
                state.file.sync_data()?;
                state.synced = Instant::now();
            }
            Ok(())
        });
        result.map_err(|error| Error::write(&self.path, error))?;
        state.places.insert(done.record.id.clone(), place);
        Ok(())
    }

    /// Makes sure that all of it is on the disk.
    ///
    /// # Errors
    ///
    /// When it cannot be written.
    pub fn sync(&self) -> Result<(), Error> {
        self.state().file.sync_all().map_err(|error| Error::write(&self.path, error))
    }

    /// What is written about this submission, if it is done.
    ///
    /// # Errors
    ///
    /// When it cannot be read.
    pub fn get(&self, id: &str) -> Result<Option<Done>, Error> {
        let Some(place) = self.state().places.get(id).copied() else { return Ok(None) };
        self.entries_at(vec![place])?.next().transpose()
    }

    /// All that is done, in the order of the ids. One at a time is held in memory.
    ///
    /// # Errors
    ///
    /// When it cannot be read.
    pub fn entries(&self) -> Result<impl Iterator<Item = Result<Done, Error>> + use<>, Error> {
        let places = self.state().places.values().copied().collect();
        self.entries_at(places)
    }

    /// The ids of what is done, in order.
    pub fn ids(&self) -> Vec<String> {
        self.state().places.keys().cloned().collect()
    }

    fn entries_at(
        &self,
        places: Vec<u64>,
    ) -> Result<impl Iterator<Item = Result<Done, Error>> + use<>, Error> {
        let path = self.path.clone();
        let mut reader = BufReader::new(File::open(&path).map_err(|error| Error::read(&path, error))?);
        Ok(places.into_iter().map(move |place| {
            let mut line = String::new();
            let read = reader.seek(SeekFrom::Start(place)).and_then(|_| reader.read_line(&mut line));
            read.and_then(|_| Ok(serde_json::from_str(&line)?)).map_err(|error| Error::read(&path, error))
        }))
    }

    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl State {
    fn append(&mut self, line: &impl Serialize) -> io::Result<()> {
        let mut bytes = serde_json::to_vec(line)?;
        bytes.push(b'\n');
        self.file.write_all(&bytes)?;
        self.end += bytes.len() as u64;
        Ok(())
    }
}

/// Two programs at work on one journal would mark everything twice.
fn lock(file: &File, folder: &Path) -> Result<(), Error> {
    match file.try_lock() {
        Err(TryLockError::WouldBlock) => Err(Error::Busy(folder.to_path_buf())),
        // Some network file systems know no locks.
        Ok(()) | Err(TryLockError::Error(_)) => Ok(()),
    }
}

/// A journal as it is read.
struct Contents {
    header: Header,
    places: BTreeMap<String, u64>,
    /// Where the last whole line ends.
    end: u64,
}

impl Contents {
    fn read(path: &Path) -> Result<Contents, Error> {
        let trouble = |error: io::Error| Error::read(path, error);
        let mut reader = BufReader::new(File::open(path).map_err(trouble)?);
        let first = whole_line(&mut reader).map_err(trouble)?.unwrap_or_default();
        let header = serde_json::from_slice(&first).map_err(|_| Error::NotAJournal(path.to_path_buf()))?;
        let mut contents = Contents { header, places: BTreeMap::new(), end: first.len() as u64 };
        while let Some(line) = whole_line(&mut reader).map_err(trouble)? {
            let Ok(done) = serde_json::from_slice::<Done>(&line) else { break };
            contents.places.insert(done.record.id, contents.end);
            contents.end += line.len() as u64;
        }
        Ok(contents)
    }
}

/// The next line with its end; nothing at the end of the file and for a line that broke off.
fn whole_line(reader: &mut impl BufRead) -> io::Result<Option<Vec<u8>>> {
    /// Far more than any line of ours.
    const LONGEST: u64 = 64 << 20;
    let mut line = Vec::new();
    reader.by_ref().take(LONGEST).read_until(b'\n', &mut line)?;
    Ok((line.last() == Some(&b'\n')).then_some(line))
}
