//! Files that are there whole or not at all.

use std::fs::File;
use std::io::{self, Write};
use std::path::Path;

use crate::Error;

/// Writes under another name first.
///
/// # Errors
///
/// When the file cannot be written. What was there before stays.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), Error> {
    let trouble = |error: io::Error| Error::write(path, error);
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut builder = tempfile::Builder::new();
    let mut file = builder
        .prefix(results::PART_PREFIX)
        .suffix(results::PART_SUFFIX)
        .tempfile_in(folder)
        .map_err(trouble)?;
    file.write_all(bytes).and_then(|()| file.as_file().sync_all()).map_err(trouble)?;
    make_readable(file.as_file()).map_err(trouble)?;
    file.persist(path).map_err(|error| trouble(error.error))?;
    Ok(())
}

/// Temporary files are their owner's alone; a result is for others too.
#[cfg(unix)]
fn make_readable(file: &File) -> io::Result<()> {
    use std::os::unix::fs::PermissionsExt;
    file.set_permissions(std::fs::Permissions::from_mode(0o644))
}

#[cfg(not(unix))]
fn make_readable(_: &File) -> io::Result<()> {
    Ok(())
}
