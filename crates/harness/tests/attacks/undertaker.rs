//! The parent of a run: it gets everything that the run leaves behind, and tells.
//!
//! As the first process of a system does, it buries the dead at once: namespaces and control groups wait for that.

use std::fs;
use std::process::{Command, exit};
use std::time::{Duration, Instant};

use nix::sys::prctl::set_child_subreaper;
use nix::sys::signal::{Signal, kill};
use nix::sys::wait::{WaitPidFlag, WaitStatus, waitpid};
use nix::unistd::Pid;

/// Makes this program the undertaker of what its arguments name.
pub const WANTED: &str = "FK_LAB_TEST_UNDERTAKER";

/// Stands before each process that was left.
pub const LEFT: &str = "LEFT BEHIND: ";

/// Runs what the arguments name, when the environment asks for it. What still runs after it is told on standard error.
pub fn work_if_asked() {
    if std::env::var_os(WANTED).is_none() {
        return;
    }
    set_child_subreaper(true).unwrap();
    let mut words = std::env::args_os().skip(1);
    let run = Command::new(words.next().unwrap()).args(words).env_remove(WANTED).spawn().unwrap();
    let run = Pid::from_raw(run.id().cast_signed());
    let code = loop {
        match waitpid(None, None) {
            Ok(WaitStatus::Exited(process, code)) if process == run => break code,
            Ok(WaitStatus::Signaled(process, ..)) if process == run => break 128,
            _ => {}
        }
    };
    // What was killed takes a moment to go.
    let start = Instant::now();
    while let Ok(found) = waitpid(None, Some(WaitPidFlag::WNOHANG)) {
        if found == WaitStatus::StillAlive && start.elapsed() > Duration::from_secs(20) {
            for (process, name) in children() {
                eprintln!("{LEFT}{process} {name}");
                let _ = kill(Pid::from_raw(process), Signal::SIGKILL);
            }
            break;
        }
        std::thread::yield_now();
    }
    exit(code)
}

fn children() -> Vec<(i32, String)> {
    let own = std::process::id().to_string();
    let processes = fs::read_dir("/proc").unwrap().filter_map(|process| {
        let status = fs::read_to_string(process.ok()?.path().join("status")).ok()?;
        let field = |name: &str| {
            status
                .lines()
                .find_map(|line| Some(line.strip_prefix(name)?.strip_prefix(':')?.trim().to_owned()))
        };
        (field("PPid")? == own).then(|| Some((field("Pid")?.parse().ok()?, field("Name")?)))?
    });
    processes.collect()
}
