//! The launcher's way from a fresh process to the confined program.

use std::convert::Infallible;
use std::ffi::OsStr;
use std::io;
use std::os::fd::OwnedFd;
use std::os::unix::process::{CommandExt, ExitStatusExt};
use std::process::{Command, ExitStatus, exit};
use std::{env, fs};

use caps::CapSet;
use landlock::RulesetCreated;
use nix::errno::Errno;
use nix::fcntl::OFlag;
use nix::sys::prctl::{set_no_new_privs, set_pdeathsig};
use nix::sys::signal::{SigHandler, Signal, raise, signal};
use nix::unistd::{Gid, Uid, getppid, pipe2, read, setgroups, setresgid, setresuid, setsid};

use crate::unix::spec::Spec;
use crate::unix::{Context, fail, limits, replace};

use super::{landlock_rules, namespaces, private_root, system_calls, user};

/// Sets up every layer of `spec` and becomes `program`, or waits for it and then ends as it did. Returns only if a
/// layer cannot be set up; what cannot be returned is said after `token`.
pub fn confine(token: &OsStr, spec: &Spec, mut program: Command) -> Result<Infallible, String> {
    setsid().context("start a session")?;
    let parent = Parent::Number(spec.parent);
    end_with(&parent)?;
    close_on_exec().context("close inherited files")?;
    limits::no_core_dump().context("refuse core dumps")?;
    for file in spec.cgroups() {
        fs::write(file, "0").context(&format!("join {}", file.display()))?;
    }
    if spec.layers.namespaces {
        namespaces::enter(spec.parent, &spec.namespaces)?;
        private_root::enter(spec)?;
    }
    env::set_current_dir(spec.folder().unwrap_or("/".as_ref())).context("enter the folder")?;
    let rules = spec.layers.landlock.then(|| landlock_rules::rules(spec)).transpose()?;
    if spec.layers.namespaces {
        // Only children are in the process namespace.
        return wait_for_child(token, spec, rules, program);
    }
    last_steps(spec, rules, &parent)?;
    Err(replace(spec, &mut program))
}

/// What binds only the program, not a launcher that waits for it. The order matters: each step takes away what those
/// before it needed.
fn last_steps(spec: &Spec, rules: Option<RulesetCreated>, parent: &Parent) -> Result<(), String> {
    let filter = || system_calls::filter(std::process::id(), spec.folder().is_some());
    let filter = spec.layers.seccomp.then(filter).transpose()?;
    if let Some(user) = spec.user {
        become_user(user).context("change the user")?;
    } else if spec.layers.namespaces && !user::is_root() {
        namespaces::leave_rights()?;
    }
    // Once more: changing the user undoes it.
    end_with(parent)?;
    if spec.layers.is_sandboxed() {
        give_up_rights()?;
    }
    if let Some(rules) = rules {
        landlock_rules::obey(rules)?;
    }
    if spec.layers.limits {
        limits::apply(spec).context("set limits")?;
    }
    if let Some(filter) = filter {
        system_calls::obey(&filter)?;
    }
    Ok(())
}

#[allow(unsafe_code)]
fn wait_for_child(
    token: &OsStr,
    spec: &Spec,
    rules: Option<RulesetCreated>,
    mut program: Command,
) -> Result<Infallible, String> {
    let (alive, end) = pipe2(OFlag::O_NONBLOCK | OFlag::O_CLOEXEC).context("make a pipe")?;
    let parent = Parent::Pipe(alive);
    let (mut end, mut rules) = (Some(end), Some(rules));
    let (token, spec) = (token.to_owned(), spec.clone());
    let name = format!("start {}", spec.program().display());
    let steps = move || {
        // The child's copy; that of this process stays open for as long as it waits.
        drop(end.take());
        let result = last_steps(&spec, rules.take().flatten(), &parent);
        // The standard library would pass on a number only.
        result.map_err(|failure| fail(&token, &failure))
    };
    // SAFETY: this process has never had a second thread, so that its child may do whatever it could do itself.
    unsafe { program.pre_exec(steps) };
    let status = program.status().context(&name)?;
    end_like(status)
}

/// How this process tells that its parent is still there.
enum Parent {
    /// By its number.
    Number(u32),
    /// By a pipe that it holds open: from inside a process namespace it has no number.
    Pipe(OwnedFd),
}

/// Arranges for this process to end with its parent, which may have ended already.
fn end_with(parent: &Parent) -> Result<(), String> {
    set_pdeathsig(Signal::SIGKILL).context("end with the parent")?;
    let is_there = match parent {
        Parent::Number(number) => getppid().as_raw().cast_unsigned() == *number,
        Parent::Pipe(alive) => read(alive, &mut [0]) == Err(Errno::EAGAIN),
    };
    if is_there { Ok(()) } else { Err("the process that started this one is gone".to_owned()) }
}

/// Ends this process as its child ended. It has kept standard output open until now: who sees it closed can rely on it
/// that the status is known.
fn end_like(status: ExitStatus) -> ! {
    if let Some(number) = status.signal() {
        die_of(number);
    }
    exit(status.code().unwrap_or(1))
}

#[allow(unsafe_code)]
fn die_of(number: i32) {
    let Ok(number) = Signal::try_from(number) else { return };
    // SAFETY: the default disposition runs no code of ours.
    let _ = unsafe { signal(number, SigHandler::SigDfl) };
    let _ = raise(number);
}

fn give_up_rights() -> Result<(), String> {
    set_no_new_privs().context("refuse new rights")?;
    for set in [CapSet::Ambient, CapSet::Inheritable, CapSet::Effective, CapSet::Permitted] {
        caps::clear(None, set).context("drop capabilities")?;
    }
    Ok(())
}

fn become_user(number: u32) -> nix::Result<()> {
    let (user, group) = (Uid::from_raw(number), Gid::from_raw(number));
    setgroups(&[])?;
    setresgid(group, group, group)?;
    setresuid(user, user, user)
}

/// Nothing that this process has inherited but standard input, output and error reaches the program.
#[allow(unsafe_code)]
fn close_on_exec() -> io::Result<()> {
    // SAFETY: this closes nothing yet, and after `exec` nobody is left who could use a closed descriptor.
    let result =
        unsafe { libc::syscall(libc::SYS_close_range, 3, libc::c_uint::MAX, libc::CLOSE_RANGE_CLOEXEC) };
    if result == 0 { Ok(()) } else { Err(io::Error::last_os_error()) }
}
