//! An unprivileged user per slot.

use std::os::unix::fs::{MetadataExt, PermissionsExt, chown};
use std::path::{Path, PathBuf};
use std::{fs, io};

use crate::Confinement;

/// The first slot's user and group. No distribution gives out 61000 to 61183 (systemd's table of user numbers).
const FIRST: u32 = 61_000;
const COUNT: u32 = 184;

/// Where tasks can only be counted together with all others of the same user: so many more than run already. More than
/// any honest program starts, fewer than any system has room for.
const HEADROOM: u64 = 4096;

pub fn is_root() -> bool {
    nix::unistd::geteuid().is_root()
}

pub fn of_slot(slot: u32) -> io::Result<u32> {
    if slot < COUNT {
        return Ok(FIRST + slot);
    }
    let text = format!("slot {slot}: there are users for {COUNT} slots");
    Err(io::Error::new(io::ErrorKind::InvalidInput, text))
}

/// Gives `confinement`'s folder, but not what is in it, to `user`, and shuts it to all others.
pub fn give_folder(confinement: &Confinement, user: u32, has_private_root: bool) -> io::Result<()> {
    let Some(folder) = &confinement.folder else { return Ok(()) };
    chown(folder, Some(user), Some(user))?;
    fs::set_permissions(folder, fs::Permissions::from_mode(0o700))?;
    if !has_private_root && let Some(barrier) = barrier(folder) {
        let text = format!(
            "user {user} cannot reach {}: {} is shut to others than its owner",
            folder.display(),
            barrier.display()
        );
        return Err(io::Error::new(io::ErrorKind::PermissionDenied, text));
    }
    Ok(())
}

/// The outermost folder on the way to `path` that a stranger may not enter.
pub fn barrier(path: &Path) -> Option<PathBuf> {
    // Following links may lead elsewhere.
    let real = path.canonicalize().ok()?;
    let mut way: Vec<&Path> = real.ancestors().skip(1).collect();
    way.reverse();
    way.into_iter().find(|folder| !lets_in(folder)).map(Path::to_path_buf)
}

fn lets_in(folder: &Path) -> bool {
    fs::metadata(folder).is_ok_and(|metadata| metadata.mode() & 0o001 != 0)
}

/// How many tasks this user may have so that a program cannot start tasks without end, although all of the user's tasks
/// count. `None` for root, to whom the limit does not apply.
pub fn task_limit() -> Option<u64> {
    if is_root() { None } else { Some(tasks().unwrap_or(0) + HEADROOM) }
}

fn tasks() -> io::Result<u64> {
    let own = nix::unistd::getuid().as_raw();
    let mut count = 0;
    for process in fs::read_dir("/proc")? {
        let process = process?;
        // Processes come and go meanwhile.
        if process.metadata().is_ok_and(|metadata| metadata.uid() == own && metadata.is_dir())
            && let Ok(tasks) = fs::read_dir(process.path().join("task"))
        {
            count += tasks.count() as u64;
        }
    }
    Ok(count)
}
