//! What can go wrong around the submissions. What goes wrong in one of them is a verdict, not an error.

use std::io;
use std::path::{Path, PathBuf};

/// Why a command cannot do what it should.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The workspace is not where it was built.
    #[error("the folder of fk-lab is not there any more: run this command in it, by cargo")]
    NoWorkspace,
    /// There is no compiler.
    #[error(
        "`{program}` cannot be run, and submissions are compiled with it: {why}\nInstall Rust from https://rustup.rs."
    )]
    Toolchain {
        /// The program.
        program: String,
        /// The system's words.
        why: String,
    },
    /// The libraries cannot be built.
    #[error("the libraries that submissions are compiled with cannot be built: {0}")]
    Kit(String),
    /// A motion of the project's own cannot be read.
    #[error("the project's own motion {0} cannot be read: put data/ back as it was")]
    Motion(String),
    /// There are no submissions.
    #[error(transparent)]
    Submissions(#[from] submissions::Error),
    /// A submission cannot be packed.
    #[error(transparent)]
    Pack(#[from] submissions::PackError),
    /// The results cannot be written.
    #[error(transparent)]
    Results(#[from] results::Error),
    /// No sandbox.
    #[error(
        "{0}\nRun `cargo doctor` to see what this machine offers. `--unsandboxed` marks without protection: only do so with files that you trust."
    )]
    Sandbox(#[from] sandbox::Unavailable),
    /// A file cannot be written.
    #[error("{} cannot be written: {source}{}", path.display(), advice(source))]
    Write {
        /// The file.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// A file cannot be read.
    #[error("{} cannot be read: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// A run without `--resume`, where there is one.
    #[error("{} holds a run already: go on with it by `--resume`, or name another folder", .0.display())]
    RunExists(PathBuf),
    /// `--resume` without a run.
    #[error("{} holds no run that could go on: leave `--resume` away to begin one", .0.display())]
    NoRun(PathBuf),
    /// The journal's first line is none.
    #[error("{} is not the journal of a run", .0.display())]
    NotAJournal(PathBuf),
    /// Another program marks here.
    #[error("another command is at work in {}: wait until it has ended", .0.display())]
    Busy(PathBuf),
    /// `--resume` with other conditions.
    #[error("the run in {} was begun with another {what}: it can only go on as it began. Begin a new one in another folder, or give the same.", folder.display())]
    Changed {
        /// The run's folder.
        folder: PathBuf,
        /// What differs.
        what: &'static str,
    },
    /// What the command line asks for makes no sense.
    #[error("{0}")]
    Usage(String),
}

impl Error {
    pub(crate) fn write(path: &Path, source: io::Error) -> Error {
        Error::Write { path: path.to_path_buf(), source }
    }

    pub(crate) fn read(path: &Path, source: io::Error) -> Error {
        Error::Read { path: path.to_path_buf(), source }
    }
}

fn advice(error: &io::Error) -> &'static str {
    match error.kind() {
        io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded => {
            "\nMake room and run the same command with `--resume`: what is marked is kept."
        }
        _ => "",
    }
}
