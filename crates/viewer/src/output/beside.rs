//! Files that are there whole or not at all.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// The files that are not yet whole. Whoever holds them is the only one who makes, moves or removes such files.
static UNFINISHED: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

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
    let (mut part, mut writer) = Part::open(path)?;
    fill(&mut writer)?;
    close(writer)?;
    part.take_place_of(path, &mut unfinished())?;
    Ok(())
}

/// Lets `fill` write two files that belong together, beside the paths `first` and `second`. They take the places of whatever
/// is there once all of both has been written. When anything fails, what was there stays in both places.
///
/// # Errors
///
/// What `fill` gives, or why a file cannot be made, written or put in its place.
pub(crate) fn write_both<E: From<io::Error>>(
    [first, second]: [&Path; 2],
    fill: impl FnOnce(&mut dyn Write, &mut dyn Write) -> Result<(), E>,
) -> Result<(), E> {
    let (mut one, mut one_out) = Part::open(first)?;
    let (mut two, mut two_out) = Part::open(second)?;
    fill(&mut one_out, &mut two_out)?;
    close(one_out)?;
    close(two_out)?;
    let mut older = if first.exists() { Some(Part::copy_of(first)?) } else { None };
    // Held over both, so that the program does not end between them.
    let mut unfinished = unfinished();
    one.take_place_of(first, &mut unfinished)?;
    if let Err(error) = two.take_place_of(second, &mut unfinished) {
        // Something has gone wrong already, and that is worth telling.
        let _ = match &mut older {
            Some(older) => older.take_place_of(first, &mut unfinished),
            None => fs::remove_file(first),
        };
        return Err(error.into());
    }
    Ok(())
}

/// Removes all files that are not yet whole, for a program that is about to end. As long as the answer is held, there
/// will be no others, and none takes a place.
pub(crate) fn abandon() -> MutexGuard<'static, Vec<PathBuf>> {
    let mut unfinished = unfinished();
    for path in unfinished.drain(..) {
        // Nobody is left to be told.
        let _ = fs::remove_file(path);
    }
    unfinished
}

fn unfinished() -> MutexGuard<'static, Vec<PathBuf>> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Writes what is still to be written, and closes the file before it is moved: Windows does not move open files.
fn close(writer: BufWriter<File>) -> io::Result<()> {
    writer.into_inner().map(drop).map_err(io::IntoInnerError::into_error)
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
        let mut unfinished = unfinished();
        let file = File::create(&path)?;
        unfinished.push(path.clone());
        Ok((Part { path: Some(path) }, file))
    }

    fn open(path: &Path) -> io::Result<(Part, BufWriter<File>)> {
        let (part, file) = Part::create(path)?;
        Ok((part, BufWriter::with_capacity(1 << 16, file)))
    }

    /// A copy of the file at `path`.
    fn copy_of(path: &Path) -> io::Result<Part> {
        let (part, mut file) = Part::create(path)?;
        io::copy(&mut File::open(path)?, &mut file)?;
        Ok(part)
    }

    fn take_place_of(&mut self, target: &Path, unfinished: &mut Vec<PathBuf>) -> io::Result<()> {
        if let Some(path) = &self.path {
            fs::rename(path, target)?;
            unfinished.retain(|other| other != path);
        }
        self.path = None;
        Ok(())
    }
}

impl Drop for Part {
    fn drop(&mut self) {
        if let Some(path) = &self.path {
            let mut unfinished = unfinished();
            // Something has gone wrong already, and that is worth telling.
            let _ = fs::remove_file(path);
            unfinished.retain(|other| other != path);
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
    fn of_two_files_that_belong_together_neither_is_there_without_the_other() {
        let folder = tempfile::tempdir().unwrap();
        let paths = ["a skeleton.asf", "a motion.amc"].map(|name| folder.path().join(name));
        let write = |text: &str, fails: bool| {
            write_both([&paths[0], &paths[1]], |one, two| {
                one.write_all(text.as_bytes())?;
                two.write_all(text.as_bytes())?;
                if fails { Err(io::Error::from(io::ErrorKind::StorageFull)) } else { Ok(()) }
            })
        };
        let names = || fs::read_dir(folder.path()).unwrap().count();
        assert_eq!(write("lost", true).unwrap_err().kind(), io::ErrorKind::StorageFull);
        assert_eq!(names(), 0);
        // A folder in the place of the second: the first must not stay alone, nor take the place of an older one.
        fs::create_dir(&paths[1]).unwrap();
        write("lost", false).unwrap_err();
        assert_eq!(names(), 1);
        fs::write(&paths[0], "older").unwrap();
        write("lost", false).unwrap_err();
        assert_eq!((fs::read(&paths[0]).unwrap(), names()), (b"older".to_vec(), 2));
        fs::remove_dir(&paths[1]).unwrap();
        write("newer", false).unwrap();
        assert!(paths.iter().all(|path| fs::read(path).unwrap() == b"newer") && names() == 2);
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
