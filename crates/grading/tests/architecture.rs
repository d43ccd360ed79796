//! The rules of docs/architecture.md that a machine can check.
#![allow(clippy::unwrap_used)] // Helpers of tests.

use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;
use std::{env, fs};

const WORKSPACE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// Which of our own crates each may use, directly or not.
const ARROWS: [(&str, &[&str]); 18] = [
    ("skeleton", &[]),
    ("parser", &["skeleton"]),
    ("exam", &["skeleton"]),
    ("solutions", &["skeleton"]),
    ("fk", &["exam", "skeleton"]),
    ("interpolation", &["exam", "skeleton"]),
    ("acclaim", &["exam", "skeleton"]),
    ("time-warp", &["exam", "skeleton"]),
    ("keyframes", &["exam", "inbetween", "skeleton"]),
    ("inbetween", &["skeleton"]),
    ("reduction", &["inbetween", "skeleton", "solutions"]),
    ("grading", &["exam", "skeleton", "solutions"]),
    ("generator", &["parser", "skeleton"]),
    ("harness", &["exam", "grading", "parser", "results", "sandbox", "skeleton", "solutions", "submissions"]),
    ("results", &[]),
    ("sandbox", &[]),
    ("submissions", &[]),
    ("viewer", &["exam", "grading", "inbetween", "parser", "reduction", "skeleton", "solutions"]),
];

#[test]
fn no_crate_uses_what_it_must_not() {
    let ours: BTreeSet<String> = ARROWS.iter().map(|(name, _)| (*name).to_owned()).collect();
    for (name, allowed) in ARROWS {
        let used = crates(name, "normal,build");
        let used: BTreeSet<&String> = used.intersection(&ours).filter(|used| *used != name).collect();
        let allowed: BTreeSet<String> = allowed.iter().map(|name| (*name).to_owned()).collect();
        assert!(
            used.iter().all(|used| allowed.contains(*used)),
            "{name} uses {used:?}, it may use {allowed:?}"
        );
    }
}

#[test]
fn every_crate_of_the_workspace_is_in_the_table() {
    for folder in ["crates", "exercises"] {
        for entry in fs::read_dir(Path::new(WORKSPACE).join(folder)).unwrap() {
            let name = entry.unwrap().file_name().into_string().unwrap();
            assert!(
                ARROWS.iter().any(|(known, _)| *known == name),
                "{folder}/{name} is not in the table of arrows"
            );
        }
    }
}

/// Self-grading builds fast, and on a machine without a display.
#[test]
fn self_grading_needs_few_crates_and_no_window() {
    for exercise in grading::EXERCISES.iter().map(|exercise| exercise.rubric.exercise) {
        let names = crates(exercise, "all");
        assert!(names.contains("grading") && names.contains("glam"), "{exercise}: {names:?}");
        assert!(!names.contains("minifb") && !names.contains("viewer"), "{exercise}: {names:?}");
        assert!(names.len() <= 40, "{exercise}: {}: {names:?}", names.len());
    }
}

#[test]
fn a_source_file_has_at_most_400_lines() {
    let mut long = Vec::new();
    for folder in ["crates", "exercises", "solutions"] {
        for_each_source(&Path::new(WORKSPACE).join(folder), &mut |path, text| {
            if text.lines().count() > 400 {
                long.push(path.display().to_string());
            }
        });
    }
    assert!(long.is_empty(), "{long:?}");
}

fn for_each_source(folder: &Path, visit: &mut dyn FnMut(&Path, &str)) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            for_each_source(&path, visit);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            visit(&path, &fs::read_to_string(&path).unwrap());
        }
    }
}

/// The crates that a package is built from, itself included.
fn crates(package: &str, edges: &str) -> BTreeSet<String> {
    let mut cargo = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    let tree = cargo
        .current_dir(WORKSPACE)
        .args(["tree", "--locked", "--package", package, "--edges", edges, "--prefix", "none"])
        .output()
        .unwrap();
    assert!(tree.status.success(), "{}", String::from_utf8_lossy(&tree.stderr));
    let lines = String::from_utf8(tree.stdout).unwrap();
    let name = |line: &str| Some(line.split_once(" v")?.0.to_owned());
    lines.lines().filter(|line| !line.contains(" feature ")).filter_map(name).collect()
}
