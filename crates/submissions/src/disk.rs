//! Files and folders of the system, of which nothing is known.

use std::ffi::OsString;
use std::fs::{self, File, FileType, OpenOptions};
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use crate::archive::Kind;
use crate::choose::{Candidate, Listing, is_litter};
use crate::{MAX_BATCH, MAX_FILES, Rejection, Wanted};

/// How deep folders of a submission may lie in each other.
const MAX_DEPTH: usize = 32;

/// One thing in a folder.
pub(crate) struct Found {
    pub(crate) name: OsString,
    pub(crate) kind: Kind,
}

/// Why a file was not opened.
#[derive(Debug)]
pub(crate) enum Refused {
    Link,
    Special,
    Io(io::Error),
}

/// What is in a folder, by name; at most `max` things.
///
/// # Errors
///
/// When the folder cannot be read, and with [`io::ErrorKind::FileTooLarge`] when it holds more.
pub(crate) fn list(folder: &Path, max: usize) -> io::Result<Vec<Found>> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder)? {
        if found.len() == max {
            return Err(io::ErrorKind::FileTooLarge.into());
        }
        let entry = entry?;
        found.push(Found { name: entry.file_name(), kind: kind(entry.file_type()?) });
    }
    found.sort_by(|a, b| a.name.cmp(&b.name));
    Ok(found)
}

/// The same, without what systems leave behind.
pub(crate) fn list_batch(folder: &Path) -> io::Result<Vec<Found>> {
    let mut found = list(folder, MAX_BATCH)?;
    found.retain(|one| !is_litter(&one.name.to_string_lossy()));
    Ok(found)
}

/// Opens a regular file, and nothing else: a link is not followed, and a pipe keeps nobody waiting.
pub(crate) fn open(path: &Path) -> Result<File, Refused> {
    let refuse = |kind| match kind {
        Kind::File => Ok(()),
        Kind::Link => Err(Refused::Link),
        Kind::Folder | Kind::Special => Err(Refused::Special),
    };
    refuse(kind(fs::symlink_metadata(path).map_err(Refused::Io)?.file_type()))?;
    let mut options = OpenOptions::new();
    options.read(true);
    #[cfg(unix)]
    {
        // Should the file have been exchanged since it was looked at.
        use std::os::unix::fs::OpenOptionsExt;
        options.custom_flags(libc::O_NOFOLLOW | libc::O_NONBLOCK | libc::O_NOCTTY);
    }
    let file = options.open(path).map_err(Refused::Io)?;
    refuse(kind(file.metadata().map_err(Refused::Io)?.file_type()))?;
    Ok(file)
}

/// The bytes of a file, or `None` if there are more than `max`.
pub(crate) fn read(file: &File, max: u64) -> io::Result<Option<Vec<u8>>> {
    let mut bytes = Vec::new();
    file.take(max + 1).read_to_end(&mut bytes)?;
    Ok(if bytes.len() as u64 > max { None } else { Some(bytes) })
}

/// The files in a folder and in the folders in it.
pub(crate) fn walk(folder: &Path, wanted: &Wanted) -> Result<Listing<PathBuf>, Rejection> {
    let too_large =
        |what: &str| Rejection::new("folder_too_large", format!("The folder holds {what}."), wanted);
    let mut listing = Listing::new();
    let mut left = MAX_FILES;
    let mut to_visit = vec![(PathBuf::new(), 0)];
    while let Some((inner, depth)) = to_visit.pop() {
        let found = match list(&folder.join(&inner), left) {
            Ok(found) => found,
            Err(error) if error.kind() == io::ErrorKind::FileTooLarge => {
                return Err(too_large(&format!("more than {MAX_FILES} files")));
            }
            Err(error) => {
                let found = format!("A folder in it cannot be read ({error}).");
                return Err(Rejection::new("unreadable", found, wanted));
            }
        };
        left -= found.len();
        for one in found {
            let path = inner.join(&one.name);
            if one.kind != Kind::Folder {
                let candidate = Candidate {
                    path: path.to_string_lossy().into_owned(),
                    kind: one.kind,
                    handle: folder.join(path),
                };
                listing.add(candidate, wanted);
            } else if depth == MAX_DEPTH {
                return Err(too_large(&format!("folders in each other deeper than {MAX_DEPTH}")));
            } else if !is_litter(&one.name.to_string_lossy()) {
                to_visit.push((path, depth + 1));
            }
        }
    }
    Ok(listing)
}

fn kind(file_type: FileType) -> Kind {
    if file_type.is_symlink() {
        Kind::Link
    } else if file_type.is_dir() {
        Kind::Folder
    } else if file_type.is_file() {
        Kind::File
    } else {
        Kind::Special
    }
}
