//! Running the harness as a teaching assistant does.
#![allow(dead_code)] // Each test uses a part of it.

pub mod submissions;

use std::fs;
use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};

/// The harness's program.
pub struct Harness;

impl Harness {
    /// `harness grade GIVEN --out OUT` with a fixed seed and two jobs.
    pub fn grade(given: &Path, out: &Path) -> Command {
        let mut command = Harness::command();
        command.arg("grade").arg(given).arg("--out").arg(out).args(["--seed", "7", "--jobs", "2"]);
        command
    }

    /// The program without arguments.
    pub fn command() -> Command {
        Command::new(env!("CARGO_BIN_EXE_harness"))
    }
}

/// Waits until no process has its program or its folder in `out`: what is killed takes a moment to go. Only known where
/// there is `/proc`.
pub fn nothing_runs_in(out: &Path) {
    if !Path::new("/proc/self/exe").exists() {
        eprintln!("NOT CHECKED: without /proc it is not known what runs in {}", out.display());
        return;
    }
    let out = out.canonicalize().unwrap_or_else(|_| out.to_path_buf());
    let start = Instant::now();
    while let Some(process) = process_in(&out) {
        assert!(start.elapsed() < Duration::from_secs(20), "process {process} runs on in {}", out.display());
        std::thread::yield_now();
    }
}

fn process_in(folder: &Path) -> Option<String> {
    fs::read_dir("/proc").ok()?.filter_map(Result::ok).find_map(|process| {
        let is_in = |link: &str| {
            fs::read_link(process.path().join(link)).is_ok_and(|target| target.starts_with(folder))
        };
        (is_in("exe") || is_in("cwd")).then(|| process.file_name().display().to_string())
    })
}
