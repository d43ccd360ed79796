//! What a confined program may use.

use std::ffi::OsString;
use std::io;
use std::path::{Component, Path, PathBuf};
use std::time::Duration;

/// How much a confined program may use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Processor time of all threads together. The system counts whole seconds: it is rounded up.
    pub cpu: Duration,
    /// Time by the clock. Only [`Sandbox::run`](crate::Sandbox::run) watches it.
    pub wall: Duration,
    /// Bytes of address space.
    pub memory: u64,
    /// Threads, the first one included.
    pub threads: u32,
    /// Bytes of standard output and standard error together that are read before the program is ended. Only
    /// [`Sandbox::run`](crate::Sandbox::run) watches it.
    pub output: usize,
    /// Bytes of the largest file that it may write.
    pub file_size: u64,
}

/// All that a confined program gets to see, and how much it may use.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Confinement {
    /// Files and folders, with all that is in them, that it may read and execute. They must exist.
    pub read: Vec<PathBuf>,
    /// The one folder that it may write, and its current directory. What is in it cannot be executed, unless it is also
    /// in [`read`](Confinement::read) of a confinement without a folder. With a user of its own, the folder is given
    /// to that user.
    pub folder: Option<PathBuf>,
    /// Its whole environment.
    pub environment: Vec<(OsString, OsString)>,
    /// How much it may use.
    pub limits: Limits,
}

impl Confinement {
    pub(crate) fn check(&self, program: &Path) -> io::Result<()> {
        let paths = self.read.iter().map(PathBuf::as_path).chain(self.folder.as_deref()).chain([program]);
        for path in paths {
            // A private root is built of these names as they stand.
            let is_plain =
                path.components().all(|part| !matches!(part, Component::ParentDir | Component::CurDir));
            if !path.is_absolute() || !is_plain || path.parent().is_none() {
                let text = format!("not an absolute path below the root: {}", path.display());
                return Err(io::Error::new(io::ErrorKind::InvalidInput, text));
            }
        }
        Ok(())
    }
}

/// The folders of this system that hold the shared libraries of ordinary programs. A program that is linked
/// dynamically needs them in [`Confinement::read`].
pub fn system_libraries() -> Vec<PathBuf> {
    let usual = ["/lib", "/lib64", "/usr/lib", "/usr/lib64", "/nix/store", "/gnu/store"];
    usual.into_iter().map(PathBuf::from).filter(|path| cfg!(unix) && path.is_dir()).collect()
}
