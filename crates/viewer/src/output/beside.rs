//! Files that are there whole or not at all.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

/// Lets `fill` write a file beside `path`, which takes the place of whatever is there once all of it has been written.
/// When anything fails, what was there stays, and the other file is removed.
///
/// # Errors
///
/// What `fill` gives, or why the file cannot be made, written or put in its place.
pub(crate) fn write_whole<E: From<io::Error>>(
    path: &Path,
    fill: impl FnOnce(&mut dyn Write) -> Result<(), E>,
) -> Result<(), E> {
    let (part, file) = Part::create(path)?;
    let mut writer = BufWriter::with_capacity(1 << 16, file);
    fill(&mut writer)?;
    // Closed before it is moved: Windows does not move open files.
    drop(writer.into_inner().map_err(io::IntoInnerError::into_error)?);
    part.take_place_of(path)?;
    Ok(())
}

/// A file that is not yet whole; removed when it is dropped.
struct Part {
    path: Option<PathBuf>,
}

impl Part {
    /// A new file in the folder of `path`, under a name that nobody else in this program uses.
    fn create(path: &Path) -> io::Result<(Part, File)> {
        static NUMBER: AtomicU64 = AtomicU64::new(0);
        let mut name = OsString::from(".");
        name.push(path.file_name().unwrap_or_default());
        name.push(format!(".{}-{}.tmp", std::process::id(), NUMBER.fetch_add(1, Ordering::Relaxed)));
        let path = path.with_file_name(name);
        let file = File::create(&path)?;
        Ok((Part { path: Some(path) }, file))
    }

    fn take_place_of(mut self, target: &Path) -> io::Result<()> {
        if let Some(path) = &self.path {
            fs::rename(path, target)?;
        }
        self.path = None;
        Ok(())
    }
}

impl Drop for Part {
    fn drop(&mut self) {
        if let Some(path) = &self.path {
            // Something has gone wrong already, and that is worth telling.
            let _ = fs::remove_file(path);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whatever_fails_what_was_there_stays_and_nothing_else() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a film.gif");
        let write = |fill: fn(&mut dyn Write) -> io::Result<()>| write_whole(&path, fill);
        write(|file| file.write_all(b"older")).unwrap();
        let full = write(|file| {
            file.write_all(&[0; 1 << 18])?;
            Err(io::ErrorKind::StorageFull.into())
        });
        assert_eq!(full.unwrap_err().kind(), io::ErrorKind::StorageFull);
        assert!(std::panic::catch_unwind(|| write(|_| panic!("on purpose"))).is_err());
        assert_eq!(fs::read(&path).unwrap(), b"older");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1, "nothing is left lying about");
    }

    #[test]
    fn two_may_write_the_same_file_at_once() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("twice");
        write_whole(&path, |outer| -> io::Result<()> {
            write_whole(&path, |inner| inner.write_all(b"inner"))?;
            outer.write_all(b"outer")
        })
        .unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"outer");
    }
}
