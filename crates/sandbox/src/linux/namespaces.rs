//! Namespaces that all programs of a sandbox enter: own processes, network without any device, IPC and names.
//!
//! Making a network namespace takes longer than all other layers together, entering one takes microseconds. So they are
//! made once. What the programs that share them could do to one another the other layers refuse: signals, sockets and
//! shared memory. The mount namespace is each program's own.

use std::ffi::OsStr;
use std::fs::{self, File};
use std::io::{self, BufRead, BufReader, Read};
use std::os::fd::AsRawFd;
use std::path::Path;
use std::process::{Child, ChildStdin, Command, Stdio, exit};

use nix::sched::{CloneFlags, setns, unshare};
use nix::unistd::{getegid, geteuid};

use crate::unix::Context;

use super::user::is_root;

/// The launcher's argument when it is to make the namespaces.
const MAKE: &str = "--make-namespaces";
/// Its argument when it is to be the first process in them.
const HOLD: &str = "--hold-namespaces";

/// Holds the namespaces. When it is dropped, or this process ends in whatever way, all processes in them end.
pub struct Namespaces {
    /// In the order in which they are to be entered.
    files: Vec<File>,
    /// The first process ends when this is closed.
    stdin: Option<ChildStdin>,
    maker: Child,
}

impl Namespaces {
    pub fn open(launcher: &Path) -> Result<Namespaces, String> {
        let mut maker = Command::new(launcher)
            .arg(MAKE)
            .env_clear()
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .context("start the launcher")?;
        let (stdin, stdout) = (maker.stdin.take(), maker.stdout.take());
        let mut namespaces = Namespaces { files: Vec::new(), stdin, maker };
        let mut answer = String::new();
        if let Some(stdout) = stdout {
            BufReader::new(stdout).read_line(&mut answer).context("hear from the launcher")?;
        }
        let Ok(first) = answer.trim().parse::<u32>() else {
            let mut why = String::new();
            if let Some(mut stderr) = namespaces.maker.stderr.take() {
                stderr.read_to_string(&mut why).context("hear from the launcher")?;
            }
            return Err(if why.is_empty() {
                "the launcher made no namespaces".into()
            } else {
                why.trim().into()
            });
        };
        // The user namespace gives the right to enter the others.
        let user = if is_root() { &[][..] } else { &["user"] };
        for name in user.iter().chain(&["ipc", "net", "uts", "pid"]) {
            let file = File::open(format!("/proc/{first}/ns/{name}")).context("open a namespace")?;
            namespaces.files.push(file);
        }
        Ok(namespaces)
    }

    /// The numbers of the descriptors, in the order in which the namespaces are to be entered.
    pub fn descriptors(&self) -> Vec<i32> {
        self.files.iter().map(AsRawFd::as_raw_fd).collect()
    }
}

impl Drop for Namespaces {
    fn drop(&mut self) {
        drop(self.stdin.take());
        let _ = self.maker.wait();
    }
}

/// Enters the namespaces that the process `parent` holds open. Children of this process will be in the process
/// namespace; it is not itself.
pub fn enter(parent: u32, descriptors: &[i32]) -> Result<(), String> {
    let open = |descriptor| File::open(format!("/proc/{parent}/fd/{descriptor}"));
    // All before the first is entered: from in there the parent is out of reach.
    let files: Vec<File> =
        descriptors.iter().map(open).collect::<Result<_, _>>().context("open a namespace")?;
    for file in files {
        setns(file, CloneFlags::empty()).context("enter a namespace")?;
    }
    unshare(CloneFlags::CLONE_NEWNS).context("make a mount namespace")
}

/// Gives this process a user namespace of its own, in which its tasks are counted alone and it has no rights over the
/// namespaces that it is in.
pub fn leave_rights() -> Result<(), String> {
    unshare(CloneFlags::CLONE_NEWUSER).context("make a user namespace")
}

/// The roles of the launcher that make and hold namespaces.
pub fn hold_if_asked(first: &OsStr) {
    if first == MAKE {
        match make() {
            Ok(first) => println!("{first}"),
            Err(error) => eprintln!("{error}"),
        }
        exit(0);
    }
    if first == HOLD {
        // Nothing is ever sent.
        let _ = io::stdin().read(&mut [0]);
        exit(0);
    }
}

/// Makes the namespaces and starts their first process, which waits for the end of standard input. Its number is the
/// answer.
fn make() -> Result<u32, String> {
    let (user, group) = (geteuid(), getegid());
    let kinds = CloneFlags::CLONE_NEWIPC
        | CloneFlags::CLONE_NEWNET
        | CloneFlags::CLONE_NEWUTS
        | CloneFlags::CLONE_NEWPID;
    if !user.is_root() {
        unshare(CloneFlags::CLONE_NEWUSER).context("make a user namespace")?;
        // Itself, and nobody else.
        fs::write("/proc/self/setgroups", "deny").context("give up groups")?;
        fs::write("/proc/self/uid_map", format!("{user} {user} 1")).context("map the user")?;
        fs::write("/proc/self/gid_map", format!("{group} {group} 1")).context("map the group")?;
    }
    unshare(kinds).context("make namespaces")?;
    let launcher = std::env::current_exe().context("find the launcher")?;
    let first = Command::new(launcher)
        .arg(HOLD)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .context("start the first process")?;
    Ok(first.id())
}
