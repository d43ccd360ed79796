//! An unprivileged user per slot.

use std::hash::{BuildHasher, RandomState};
use std::ops::Range;
use std::os::unix::fs::{MetadataExt, PermissionsExt, chown};
use std::path::{Path, PathBuf};
use std::{fs, io};

use crate::Confinement;

/// Numbers that no system gives to users, groups or containers (systemd's "Users, Groups, UIDs and GIDs").
const FREE: Range<u32> = 0x7000_0000..0x7ff0_0000;
/// Slots of one sandbox.
const SLOTS: u32 = 256;

/// Where tasks can only be counted together with all others of the same user: so many more than run already. More than
/// any honest program starts, fewer than any system has room for.
const HEADROOM: u64 = 4096;

pub fn is_root() -> bool {
    nix::unistd::geteuid().is_root()
}

/// The users of one sandbox. The kernel counts a user's tasks on the whole machine, containers included, and two
/// sandboxes must not count each other's: each picks its numbers at random.
pub struct Users {
    first: u32,
}

impl Users {
    pub fn pick() -> Users {
        let sandboxes = u64::from((FREE.end - FREE.start) / SLOTS);
        let number = RandomState::new().hash_one(0) % sandboxes;
        Users { first: FREE.start + u32::try_from(number).unwrap_or(0) * SLOTS }
    }

    /// The number of the user, and of its group.
    pub fn of_slot(&self, slot: u32) -> io::Result<u32> {
        if slot < SLOTS {
            return Ok(self.first + slot);
        }
        let text = format!("slot {slot}: there are {SLOTS}");
        Err(io::Error::new(io::ErrorKind::InvalidInput, text))
    }
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
/// count. The system's root is exempt from it.
pub fn task_limit() -> u64 {
    tasks().unwrap_or(0) + HEADROOM
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
