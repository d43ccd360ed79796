//! A run that is killed at any moment and goes on gives the bytes of an undisturbed one, and leaves nothing behind.
#![allow(clippy::unwrap_used)] // Helpers of tests.

mod support;

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::{Child, Stdio};
use std::time::{Duration, Instant};

use support::{Harness, submissions};

#[test]
fn killed_three_times() {
    killed(3);
}

#[test]
#[ignore = "takes minutes: .ci/run does it"]
fn killed_fifty_times() {
    let mut kills = 0;
    while kills < 50 {
        kills += killed(10);
        eprintln!("killed {kills} times");
    }
}

/// Kills a run up to `most` times, at moments spread over what is left of it, and compares what comes out in the end.
fn killed(most: usize) -> usize {
    let folder = tempfile::Builder::new().prefix("killed run ").tempdir().unwrap();
    let given = folder.path().join("given");
    submissions::write_some(&given);
    let undisturbed = folder.path().join("undisturbed");
    let start = Instant::now();
    let output = Harness::grade(&given, &undisturbed).output().unwrap();
    let whole = start.elapsed();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));

    let out = folder.path().join("out");
    let mut kills = 0;
    for turn in 0..most {
        let mut command = Harness::grade(&given, &out);
        if out.join("journal.jsonl").exists() {
            command.arg("--resume");
        }
        let mut child = command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
        // The moments differ from turn to turn: from the very start to shortly before the end.
        let part = (turn as u32 * 7 + 3) % 20;
        if ended_within(&mut child, whole * part / 20) {
            break;
        }
        child.kill().unwrap();
        child.wait().unwrap();
        kills += 1;
        support::nothing_runs_in(&out);
    }
    let mut command = Harness::grade(&given, &out);
    if out.join("journal.jsonl").exists() {
        command.arg("--resume");
    }
    let output = command.output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));

    assert_eq!(results(&undisturbed), results(&out));
    support::nothing_runs_in(&out);
    kills.max(1)
}

fn ended_within(child: &mut Child, time: Duration) -> bool {
    let start = Instant::now();
    while start.elapsed() < time {
        if child.try_wait().unwrap().is_some() {
            return true;
        }
        std::thread::yield_now();
    }
    false
}

/// All files of a run but those that hold times.
fn results(out: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut files = BTreeMap::new();
    collect(out, out, &mut files);
    for name in ["journal.jsonl", "log.txt", "times.csv"] {
        assert!(files.remove(name).is_some(), "there is no {name}");
    }
    assert!(files.contains_key("results.json"), "{:?}", files.keys());
    files
}

fn collect(root: &Path, folder: &Path, files: &mut BTreeMap<String, Vec<u8>>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            collect(root, &path, files);
        } else {
            let name = path.strip_prefix(root).unwrap().to_str().unwrap().to_owned();
            files.insert(name, fs::read(&path).unwrap());
        }
    }
}
