//! Reads a folder of motion files and compares the reference solution with poses computed elsewhere.
//!
//! The folder is the workspace's `data/`, or the one that the environment variable `FK_LAB_CORPUS` names, with
//! all folders inside it. In it, next to a motion file `X`, stands
//!
//! - `X.expected.json` (see the `Expected` of each format): reading must succeed and the poses must agree;
//! - or `X.expected-error`, an empty file: reading must fail with an error that names line and column;
//! - or neither: reading must end in a motion or in such an error. In `data/` no motion may be without poses.
//!
//! What is expected of a file that is not there is an error of the folder. A skeleton (`.asf`) is read for itself, too.

mod acclaim;
mod bvh;

use std::ffi::OsStr;
use std::fs;
use std::io::Write;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};

/// The farthest a joint may be off, as a part of the skeleton's extent: `f32` along a chain of joints.
const POSITION_TOLERANCE: f64 = 1e-4;

/// The most a joint may be turned too far, in degrees.
const ROTATION_TOLERANCE: f64 = 0.01;

/// How far off the worst joint is.
#[derive(Clone, Copy, Default)]
struct Worst {
    /// As a part of the skeleton's extent.
    position: f64,
    /// In degrees.
    rotation: f64,
}

/// What came of reading a file.
enum Reading {
    /// It was read, and compared with what is expected of it, if something is.
    Read(Option<Result<Worst, String>>),
    /// It was refused, with a message that names a line and a column of it, or with another one.
    Refused { message: String, names_its_place: bool },
}

/// What came of one motion file.
enum Verdict {
    /// As expected. `None` where there were no poses to compare.
    Right(Option<Worst>),
    Wrong(String),
}

#[test]
fn corpus_agrees_with_the_reference_solution() {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let other_folder = std::env::var_os("FK_LAB_CORPUS").map(PathBuf::from);
    let must_compare = other_folder.is_none();
    let folder = other_folder.unwrap_or(workspace.join("data"));
    let Found { motions: mut files, mut orphans } = find_files(&folder);
    files.sort();
    orphans.sort();

    let (mut right, mut compared) = (0, 0);
    let mut failures: Vec<String> = orphans
        .iter()
        .map(|orphan| format!("{}: the motion file that it is about is missing", orphan.display()))
        .collect();
    let mut worst = Worst::default();
    for file in &files {
        match check(file, &folder) {
            Verdict::Right(None) if must_compare && !has_extension(file, "asf") => {
                failures.push(format!("{}: there are no poses to compare it with", file.display()));
            }
            Verdict::Right(difference) => {
                right += 1;
                compared += usize::from(difference.is_some());
                worst.include(difference.unwrap_or_default());
            }
            Verdict::Wrong(why) => failures.push(format!("{}: {why}", file.display())),
        }
    }

    let checked = right + failures.len();
    // Written past the test's own capture: what has not been checked must be seen even if all is well.
    let mut out = std::io::stderr();
    let Worst { position, rotation } = worst;
    let summary = format!(
        "corpus {}: {checked} files checked, {} failed, {compared} compared pose by pose \
         (worst position {position:.1e} of the extent, worst rotation {rotation:.1e} degrees)\n",
        folder.display(),
        failures.len(),
    );
    out.write_all(summary.as_bytes()).expect("stderr can be written");
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    assert!(compared > 0 || !must_compare, "no motion was compared in {}", folder.display());
    assert!(checked > 0, "no motion file was checked in {}", folder.display());
}

/// What a folder holds.
#[derive(Default)]
struct Found {
    motions: Vec<PathBuf>,
    /// Files that say what is expected of a motion file which is not there.
    orphans: Vec<PathBuf>,
}

fn find_files(folder: &Path) -> Found {
    let mut found = Found::default();
    let mut folders = vec![folder.to_owned()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display())) {
            let entry = entry.expect("a folder can be listed");
            let path = entry.path();
            if entry.file_type().expect("an entry has a type").is_dir() {
                folders.push(path);
            } else if ["bvh", "asf", "amc"].into_iter().any(|wanted| has_extension(&path, wanted)) {
                found.motions.push(path);
            } else if expected_of(&path).is_some_and(|motion| !motion.exists()) {
                found.orphans.push(path);
            }
        }
    }
    found
}

/// `walk.bvh.expected.json` and `walk.bvh.expected-error` give `walk.bvh`.
fn expected_of(path: &Path) -> Option<PathBuf> {
    let name = path.file_name()?.to_str()?;
    let motion = [".expected.json", ".expected-error"].into_iter().find_map(|end| name.strip_suffix(end))?;
    Some(path.with_file_name(motion))
}

#[test]
fn expectations_of_missing_files_are_found() {
    let folder = tempfile::tempdir().expect("a folder");
    let inner = folder.path().join("inner");
    fs::create_dir(&inner).expect("a folder");
    for name in ["a.bvh", "a.bvh.expected.json", "b.bvh.expected.json", "c.bvh.expected-error", "notes.md"] {
        fs::write(inner.join(name), "").expect("a file");
    }
    let Found { motions, mut orphans } = find_files(folder.path());
    orphans.sort();
    assert_eq!(motions, [inner.join("a.bvh")]);
    assert_eq!(orphans, ["b.bvh.expected.json", "c.bvh.expected-error"].map(|name| inner.join(name)));
}

fn has_extension(path: &Path, wanted: &str) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case(wanted))
}

/// `walk.bvh` and `.expected.json` give `walk.bvh.expected.json`.
fn beside(file: &Path, suffix: &str) -> PathBuf {
    let name: &OsStr = file.file_name().unwrap_or_default();
    let mut name = name.to_owned();
    name.push(suffix);
    file.with_file_name(name)
}

fn check(file: &Path, folder: &Path) -> Verdict {
    let json = Some(beside(file, ".expected.json")).filter(|json| json.exists());
    let must_fail = beside(file, ".expected-error").exists();
    let read = || match file.extension() {
        Some(extension) if extension.eq_ignore_ascii_case("asf") => acclaim::check_skeleton(file),
        Some(extension) if extension.eq_ignore_ascii_case("amc") => {
            acclaim::check_motion(file, folder, json.as_deref())
        }
        _ => bvh::check(file, json.as_deref()),
    };
    match catch_unwind(AssertUnwindSafe(read)) {
        Err(_) => Verdict::Wrong("the reader panicked".into()),
        Ok(Reading::Read(_)) if must_fail => Verdict::Wrong("was read, but must be refused".into()),
        Ok(Reading::Read(None)) => Verdict::Right(None),
        Ok(Reading::Read(Some(Ok(worst)))) => Verdict::Right(Some(worst)),
        Ok(Reading::Read(Some(Err(why)))) => Verdict::Wrong(why),
        Ok(Reading::Refused { message, names_its_place: false }) => {
            Verdict::Wrong(format!("no line and column: {message}"))
        }
        Ok(Reading::Refused { message, .. }) if json.is_some() => {
            Verdict::Wrong(format!("was refused: {message}"))
        }
        Ok(Reading::Refused { .. }) => Verdict::Right(None),
    }
}

fn refused<K: parser::Kind>(error: &parser::FileError<K>, file: &Path) -> Reading {
    let message = error.to_string();
    let names_its_place = match error {
        parser::FileError::Open { .. } => false,
        parser::FileError::Read { cause, .. } => {
            let (line, column) = (cause.line(), cause.column());
            line > 0 && column > 0 && message.starts_with(&format!("{}:{line}:{column}: ", file.display()))
        }
    };
    Reading::Refused { message, names_its_place }
}

fn same<T: PartialEq + std::fmt::Debug>(what: &str, got: &T, expected: &T) -> Result<(), String> {
    if got == expected { Ok(()) } else { Err(format!("{what}: {got:?}, expected {expected:?}")) }
}

fn distance(got: [f32; 3], expected: [f64; 3]) -> f64 {
    let square = |i: usize| (f64::from(got[i]) - expected[i]).powi(2);
    (square(0) + square(1) + square(2)).sqrt()
}

impl Worst {
    fn include(&mut self, other: Worst) {
        self.position = larger(self.position, other.position);
        self.rotation = larger(self.rotation, other.rotation);
    }
}

/// The larger of two differences; NaN, if one is NaN.
fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}
