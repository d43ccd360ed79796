//! Files that are there whole or not at all.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::Path;

use tempfile::{Builder, NamedTempFile};

use crate::error::{Error, Filled};

/// How the names of files begin and end that are not yet whole.
pub const PART_PREFIX: &str = ".fk-lab-";
/// See [`PART_PREFIX`].
pub const PART_SUFFIX: &str = ".part";

/// Removes what a program that was killed has left in `folder`. Nobody else may be writing there.
///
/// # Errors
///
/// When the folder cannot be read, or a file not be removed.
pub fn remove_leftovers(folder: &Path) -> Result<(), Error> {
    for entry in fs::read_dir(folder).map_err(Error::write(folder))? {
        let path = entry.map_err(Error::write(folder))?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if name.starts_with(PART_PREFIX) && name.ends_with(PART_SUFFIX) {
            fs::remove_file(&path).map_err(Error::write(&path))?;
        }
    }
    Ok(())
}

/// Who may read a file.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Readers {
    /// Whoever the system lets by default.
    Usual,
    /// Only the owner, where the system knows owners.
    Owner,
}

/// Writes a file under another name in the same folder, then gives it its own. When anything fails, the file that was there
/// before stays.
pub(crate) fn write_whole(
    path: &Path,
    readers: Readers,
    fill: impl FnOnce(&mut dyn Write) -> Filled,
) -> Result<(), Error> {
    let folder = path.parent().unwrap_or(Path::new("."));
    let file = new_file(folder, readers).map_err(Error::write(path))?;
    let mut writer = BufWriter::with_capacity(1 << 16, file);
    fill(&mut writer).map_err(|trouble| trouble.at(path))?;
    let file = writer.into_inner().map_err(|trouble| Error::write(path)(trouble.into_error()))?;
    file.persist(path).map_err(|trouble| Error::write(path)(trouble.error))?;
    Ok(())
}

fn new_file(folder: &Path, readers: Readers) -> io::Result<NamedTempFile> {
    let mut builder = Builder::new();
    builder.prefix(PART_PREFIX).suffix(PART_SUFFIX);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // What others may not do is the business of the umask.
        let mode = if readers == Readers::Owner { 0o600 } else { 0o666 };
        builder.permissions(fs::Permissions::from_mode(mode));
    }
    #[cfg(not(unix))]
    let _ = readers;
    builder.tempfile_in(folder)
}

/// Makes a folder and those above it.
pub(crate) fn make_folder(path: &Path) -> Result<(), Error> {
    fs::create_dir_all(path).map_err(Error::write(path))
}

/// A file without a name that is gone when it is closed.
pub(crate) fn scratch(folder: &Path) -> Result<File, Error> {
    tempfile::tempfile_in(folder).map_err(Error::write(folder))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_full_disk_leaves_the_old_file_and_nothing_half_written() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("grades.csv");
        fs::write(&path, "old").unwrap();
        let trouble = write_whole(&path, Readers::Usual, |file| {
            file.write_all(&vec![b'x'; 1 << 20])?;
            Err(io::Error::from(io::ErrorKind::StorageFull).into())
        });
        let words = trouble.unwrap_err().to_string();
        assert!(words.contains("grades.csv") && words.contains("no storage space"), "{words}");
        assert_eq!(fs::read_to_string(&path).unwrap(), "old");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[test]
    #[cfg(unix)]
    fn a_key_is_for_its_owner_only() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().unwrap();
        let mode = |name: &str, readers| {
            let path = folder.path().join(name);
            write_whole(&path, readers, |file| Ok(file.write_all(b"x")?)).unwrap();
            fs::metadata(&path).unwrap().permissions().mode() & 0o777
        };
        assert_eq!(mode("key.csv", Readers::Owner), 0o600);
        let plain = folder.path().join("plain");
        fs::write(&plain, "x").unwrap();
        let usual = fs::metadata(&plain).unwrap().permissions().mode() & 0o777;
        assert_eq!(mode("grades.csv", Readers::Usual), usual);
    }
}
