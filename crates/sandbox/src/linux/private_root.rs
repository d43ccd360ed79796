//! A root of its own: the given files at their own names, and nothing else.

use std::fs::{self, File};
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::{env, ffi::CString, io};

use nix::mount::{MntFlags, MsFlags, mount, umount2};
use nix::unistd::pivot_root;

use crate::unix::Context;
use crate::unix::spec::Spec;

/// Where the new root is built: a folder that every system has, and in which nobody keeps files.
const PLACE: &str = "/proc";

/// Moves this process, which has a mount namespace of its own, into a root with nothing but the files of `spec`.
pub fn enter(spec: &Spec) -> Result<(), String> {
    let none: Option<&str> = None;
    // What is mounted here stays here.
    mount(none, "/", none, MsFlags::MS_REC | MsFlags::MS_PRIVATE, none).context("make mounts private")?;
    let size = Some("mode=755,size=1m");
    let flags = MsFlags::MS_NOSUID | MsFlags::MS_NODEV;
    mount(Some("tmpfs"), PLACE, Some("tmpfs"), flags, size).context("mount a new root")?;

    let mut read: Vec<&Path> = spec.read().collect();
    // Outer folders first. What lies inside another, or in the folder to write, is there with it.
    read.sort_unstable();
    let mut shown: Vec<&Path> = Vec::new();
    for path in read {
        let is_there = |outer: &&Path| path.starts_with(outer);
        if !shown.iter().any(is_there) && !spec.folder().iter().any(is_there) {
            show(path)?;
            shown.push(path);
        }
    }
    if let Some(folder) = spec.folder() {
        make_target(folder, true).context("make a new root")?;
    }
    name_program(spec.program()).context("make a new root")?;
    let read_only = libc::MOUNT_ATTR_RDONLY | libc::MOUNT_ATTR_NOSUID | libc::MOUNT_ATTR_NODEV;
    set_attributes(Path::new(PLACE), read_only).context("make the new root read-only")?;
    if let Some(folder) = spec.folder() {
        show(folder)?;
        let no_programs = libc::MOUNT_ATTR_NOEXEC | libc::MOUNT_ATTR_NOSUID | libc::MOUNT_ATTR_NODEV;
        set_attributes(&target(folder), no_programs).context("protect the folder")?;
    }

    env::set_current_dir(PLACE).context("enter the new root")?;
    // The old root ends up on top of the new one, from where it is taken off.
    pivot_root(".", ".").context("change the root")?;
    umount2(".", MntFlags::MNT_DETACH).context("leave the old root")?;
    env::set_current_dir("/").context("enter the new root")
}

/// Programs look here for their own name, and the system's loader for the libraries that lie beside them.
fn name_program(program: &Path) -> io::Result<()> {
    fs::create_dir_all(target(Path::new("/proc/self")))?;
    symlink(program, target(Path::new("/proc/self/exe")))
}

/// Mounts `path` at the same name below the new root.
fn show(path: &Path) -> Result<(), String> {
    let name = format!("show {}", path.display());
    make_target(path, path.is_dir()).context(&name)?;
    let none: Option<&str> = None;
    mount(Some(path), &target(path), none, MsFlags::MS_BIND | MsFlags::MS_REC, none).context(&name)
}

/// Makes something to mount `path` on. Inside of what is already mounted it is there.
fn make_target(path: &Path, is_folder: bool) -> io::Result<()> {
    let target = target(path);
    if target.exists() {
        return Ok(());
    }
    if is_folder {
        return fs::create_dir_all(target);
    }
    if let Some(parent) = target.parent() {
        fs::create_dir_all(parent)?;
    }
    File::create(target).map(drop)
}

fn target(path: &Path) -> PathBuf {
    Path::new(PLACE).join(path.strip_prefix("/").unwrap_or(path))
}

/// Adds `attributes` to the mount at `path` and to all below it. What they have already stays, as it must where they
/// come from a namespace with more rights.
#[allow(unsafe_code)]
fn set_attributes(path: &Path, attributes: u64) -> io::Result<()> {
    let path = CString::new(path.as_os_str().as_bytes())?;
    // `struct mount_attr`: what to set, what to clear, propagation, user namespace.
    let change: [u64; 4] = [attributes, 0, 0, 0];
    // SAFETY: the path ends with a zero and `change` is of the size that is given; both outlive the call.
    let result = unsafe {
        libc::syscall(
            libc::SYS_mount_setattr,
            libc::AT_FDCWD,
            path.as_ptr(),
            libc::AT_RECURSIVE,
            change.as_ptr(),
            size_of_val(&change),
        )
    };
    if result == 0 { Ok(()) } else { Err(io::Error::last_os_error()) }
}
