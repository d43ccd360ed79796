//! Every output, word for word. After a change, `FK_LAB_BLESS=1 cargo test -p results --test goldens` writes the expected files
//! again: look at them before you keep them.
#![allow(clippy::unwrap_used)] // Helpers of tests.

mod common;

use std::path::{Path, PathBuf};
use std::{env, fs};

use common::{groups, records, run, write};
use results::{Gradebook, LateList, LatePolicy, Options, Overrides, Roster, gradescope};

fn input(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/inputs").join(name)
}

fn options() -> Options {
    let policy = LatePolicy { percent_per_day: "12.5".parse().unwrap(), cap: "50".parse().unwrap() };
    Options {
        roster: Some(Roster::read(&input("roster.csv")).unwrap()),
        late: Some(LateList::read(&input("late.csv"), policy).unwrap()),
        overrides: Some(Overrides::read(&input("overrides.csv"), &run()).unwrap()),
        groups: groups(),
        ..Options::default()
    }
}

#[test]
fn everything_with_names() {
    let gradebook = |name| Some(Gradebook { path: input(name), column: None });
    let options = Options { canvas: gradebook("canvas.csv"), moodle: gradebook("moodle.csv"), ..options() };
    check("named", &options);
}

#[test]
fn everything_without_names() {
    check("anonymous", &Options { anonymous: true, ..options() });
}

#[test]
fn gradescope_results() {
    let folder = tempfile::tempdir().unwrap();
    for record in records() {
        let value = gradescope(&run(), &record);
        let text = format!("{}\n", serde_json::to_string_pretty(&value).unwrap());
        fs::write(folder.path().join(format!("{}.json", record.id)), text).unwrap();
    }
    compare("gradescope", folder.path());
}

fn check(name: &str, options: &Options) {
    let folder = tempfile::tempdir().unwrap();
    let summary = write(folder.path(), &run(), &records(), options).unwrap();
    // Inputs are named with their paths.
    let here = format!("{}{}", env!("CARGO_MANIFEST_DIR"), std::path::MAIN_SEPARATOR);
    let attention = format!("{}\n", summary.attention.join("\n"));
    fs::write(folder.path().join("attention.txt"), attention).unwrap();
    for file in files(folder.path()) {
        let text = fs::read_to_string(folder.path().join(&file)).unwrap();
        if text.contains(&here) {
            fs::write(folder.path().join(&file), text.replace(&here, "")).unwrap();
        }
    }
    compare(name, folder.path());
}

fn compare(name: &str, written: &Path) {
    let golden = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden").join(name);
    if env::var_os("FK_LAB_BLESS").is_some() {
        let _ = fs::remove_dir_all(&golden);
        for file in files(written) {
            let path = golden.join(&file);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::copy(written.join(&file), path).unwrap();
        }
    }
    assert_eq!(files(written), files(&golden), "{name}");
    for file in files(written) {
        let text = fs::read_to_string(written.join(&file)).unwrap();
        let expected = fs::read_to_string(golden.join(&file)).unwrap();
        assert!(text == expected, "{}: {}", golden.join(&file).display(), first_difference(&text, &expected));
    }
}

fn first_difference(text: &str, expected: &str) -> String {
    let lines = text.lines().zip(expected.lines()).enumerate();
    let mut different = lines.filter(|(_, (one, other))| one != other);
    match different.next() {
        Some((line, (one, other))) => format!("line {}:\n  is       {one}\n  expected {other}", line + 1),
        None => "one is longer".to_owned(),
    }
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut open = vec![folder.to_owned()];
    while let Some(next) = open.pop() {
        for entry in fs::read_dir(next).into_iter().flatten() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                open.push(path);
            } else {
                found.push(path.strip_prefix(folder).unwrap().to_owned());
            }
        }
    }
    found.sort();
    found
}
