//! Which submissions are found in a folder or an archive of them.

#![allow(clippy::unwrap_used)] // Helpers of tests.

mod support;

use std::fs;
use std::path::Path;

use submissions::{Batch, Entry, Error, Lms, Loaded, by_student, read_one};
use support::{CODE, Member, code, source, wanted, write, zip};

fn open(path: &Path) -> Batch {
    Batch::open(path, &wanted()).unwrap()
}

fn ids(batch: &Batch) -> Vec<&str> {
    batch.entries().iter().map(|entry| entry.id.as_str()).collect()
}

fn find<'a>(batch: &'a Batch, id: &str) -> &'a Entry {
    batch
        .entries()
        .iter()
        .find(|entry| entry.id == id)
        .unwrap_or_else(|| panic!("{id} is not in {:?}", ids(batch)))
}

fn submission() -> Vec<u8> {
    zip(&[Member::deflated("fk.rs", CODE)])
}

/// The same mixed submissions, as files of a folder.
fn mixed() -> Vec<(&'static str, Vec<u8>)> {
    vec![
        ("300000001_TerryFox.zip", submission()),
        ("300000002_AdaLovelace.rs", CODE.into()),
        ("300000003_EmmyNoether/fk.rs", CODE.into()),
        ("300000004_Deep/deeper/deepest/fk.rs", CODE.into()),
        ("Grace Hopper_1234_assignsubmission_file/300000005_GraceHopper.zip", submission()),
        ("hamiltonmargaret_LATE_77_4321_300000006_MargaretHamilton-1.zip", submission()),
        ("anything.rs", CODE.into()),
        ("notes.txt", b"hello".into()),
        ("broken.zip", b"no zip".into()),
        (".DS_Store", vec![0]),
        ("__MACOSX/300000001_TerryFox.zip", vec![0]),
    ]
}

const MIXED_IDS: [&str; 9] = [
    "300000001_TerryFox",
    "300000002_AdaLovelace",
    "300000003_EmmyNoether",
    "300000004_Deep",
    "Grace_Hopper_1234_assignsubmission_file",
    "anything",
    "broken",
    "hamiltonmargaret_LATE_77_4321_300000006_MargaretHamilton-1",
    "notes",
];

fn check_mixed(batch: &Batch) {
    assert_eq!(ids(batch), MIXED_IDS);
    for id in MIXED_IDS {
        let loaded = batch.load(find(batch, id));
        match id {
            "broken" => assert_eq!(code(loaded), "not_a_zip"),
            "notes" => assert_eq!(code(loaded), "wrong_type"),
            _ => assert_eq!(source(loaded).text, CODE, "{id}"),
        }
    }
    let grace = find(batch, "Grace_Hopper_1234_assignsubmission_file");
    assert_eq!(grace.student.name, "Grace Hopper");
    assert_eq!(grace.student.number.as_deref(), Some("300000005"));
    assert_eq!(grace.lms, Lms::Moodle { participant: "1234".into() });
    let margaret = find(batch, "hamiltonmargaret_LATE_77_4321_300000006_MargaretHamilton-1");
    assert!(margaret.marked_late);
    assert_eq!(margaret.lms, Lms::Canvas { user_id: "77".into() });
    assert_eq!(margaret.student.number.as_deref(), Some("300000006"));
    let anything = find(batch, "anything");
    assert_eq!((anything.student.number.as_deref(), anything.student.name.as_str()), (None, "anything"));
}

fn folder_of(files: &[(&str, Vec<u8>)]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (path, bytes) in files {
        write(folder.path().join(path), bytes);
    }
    folder
}

fn zip_of(files: &[(&str, Vec<u8>)], wrapper: &str) -> (tempfile::TempDir, std::path::PathBuf) {
    let members: Vec<Member> =
        files.iter().map(|(path, bytes)| Member::deflated(format!("{wrapper}{path}"), bytes)).collect();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("submissions.zip");
    write(&path, zip(&members));
    (folder, path)
}

#[test]
fn everything_in_a_folder_is_a_submission() {
    let folder = folder_of(&mixed());
    check_mixed(&open(folder.path()));
}

#[test]
fn everything_in_an_archive_is_a_submission() {
    let (_folder, path) = zip_of(&mixed(), "");
    check_mixed(&open(&path));
}

#[test]
fn a_folder_around_all_submissions_is_looked_through() {
    let folder = folder_of(&mixed());
    let outer = tempfile::tempdir().unwrap();
    fs::rename(folder.path(), outer.path().join("Assignment 2")).unwrap();
    check_mixed(&open(outer.path()));
    let (_folder, path) = zip_of(&mixed(), "Assignment 2/");
    check_mixed(&open(&path));
}

#[test]
fn one_folder_with_one_submission_is_that_submission() {
    let folders = [("300000003_E/a/fk.rs", CODE.into()), ("300000003_E/b/notes.txt", vec![])];
    assert_eq!(ids(&open(folder_of(&folders).path())), ["300000003_E"]);
    assert_eq!(ids(&open(&zip_of(&folders, "").1)), ["300000003_E"]);
    for path in ["300000003_EmmyNoether/fk.rs", "emmy/exercises/fk/src/fk.rs", "emmy/src/fk.rs"] {
        let folder = folder_of(&[(path, CODE.into())]);
        let batch = open(folder.path());
        assert_eq!(batch.entries().len(), 1);
        assert_eq!(source(batch.load(&batch.entries()[0])).text, CODE);
    }
}

#[test]
fn an_archive_that_is_a_submission_is_a_batch_of_one() {
    for name in ["300000001_TerryFox.zip", "terry.zip"] {
        let folder = folder_of(&[(name, submission())]);
        let batch = open(&folder.path().join(name));
        assert_eq!(ids(&batch), [name.strip_suffix(".zip").unwrap()]);
        assert_eq!(source(batch.load(&batch.entries()[0])).text, CODE);
    }
    let folder = folder_of(&[("fk.rs", CODE.into())]);
    let batch = open(&folder.path().join("fk.rs"));
    assert_eq!(source(batch.load(&batch.entries()[0])).text, CODE);
}

#[test]
fn a_path_that_is_no_batch_says_why() {
    let folder = folder_of(&[("grades.csv", b"a,b".into()), ("cut.zip", submission()[..30].to_vec())]);
    let message = |path: &Path| Batch::open(path, &wanted()).err().unwrap().to_string();
    assert!(message(&folder.path().join("nothing")).contains("cannot read"));
    assert!(message(&folder.path().join("grades.csv")).contains("neither a folder nor a zip archive"));
    assert!(message(&folder.path().join("cut.zip")).contains("the end of a zip archive is missing"));
    let empty = tempfile::tempdir().unwrap();
    assert!(open(empty.path()).entries().is_empty());
}

#[test]
fn submissions_with_one_name_are_all_kept() {
    let twice = [("300000001_TerryFox.zip", submission()), ("300000001_TerryFox.zip", submission())];
    let (_folder, path) = zip_of(&twice, "");
    let batch = open(&path);
    assert_eq!(batch.entries().len(), 2);
    let ids = ids(&batch);
    assert_eq!(ids[1], format!("{}-2", ids[0]));
    for entry in batch.entries() {
        assert_eq!(source(batch.load(entry)).text, CODE);
    }
}

#[test]
fn two_submissions_of_one_student_are_told() {
    let files = [
        ("300000001_TerryFox.zip", submission()),
        ("300000001_TerryFox.rs", CODE.into()),
        ("300000002_AdaLovelace.rs", CODE.into()),
        ("foxterry_7_1_a.rs", CODE.into()),
        ("foxterry_7_2_a-1.rs", CODE.into()),
    ];
    let folder = folder_of(&files);
    let batch = open(folder.path());
    let same = by_student(batch.entries());
    let students: Vec<&str> = same.iter().map(|one| one.student.as_str()).collect();
    assert_eq!(students, ["Canvas user 7", "student number 300000001"]);
    assert_eq!(same[0].ids, ["foxterry_7_1_a", "foxterry_7_2_a-1"]);
    assert_eq!(same[1].ids.len(), 2);
}

#[test]
fn a_folder_of_loose_files_is_read_as_one_submission() {
    let files =
        [("submission/300000001_TerryFox.zip", submission()), ("submission/readme.txt", b"hi".into())];
    let folder = folder_of(&files);
    let (entry, loaded) = read_one(&folder.path().join("submission"), &wanted());
    assert_eq!(source(loaded).text, CODE);
    assert_eq!(entry.student.number.as_deref(), Some("300000001"));
    assert_eq!((entry.id.as_str(), entry.student.name.as_str()), ("submission", "TerryFox"));
}

#[test]
fn what_is_not_there_is_rejected() {
    let folder = tempfile::tempdir().unwrap();
    let (entry, loaded) = read_one(&folder.path().join("300000001_TerryFox.zip"), &wanted());
    assert_eq!(code(loaded), "unreadable");
    assert_eq!(entry.id, "300000001_TerryFox");
}

#[test]
fn an_entry_of_another_batch_is_rejected_or_read_never_a_panic() {
    let (_folder, path) = zip_of(&mixed(), "");
    let in_archive = open(&path);
    let empty = tempfile::tempdir().unwrap();
    let other = open(empty.path());
    for entry in in_archive.entries() {
        assert_eq!(code(other.load(entry)), "unreadable");
    }
}

#[test]
fn errors_can_be_told_apart() {
    assert!(matches!(Batch::open(Path::new("/nowhere/at/all"), &wanted()), Err(Error::Io { .. })));
}

#[test]
fn many_submissions_are_listed_without_reading_them() {
    let members: Vec<Member> =
        (0..10_000).map(|i| Member::stored(format!("3{i:08}_Student.zip"), submission())).collect();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("submissions.zip");
    write(&path, zip(&members));
    let batch = open(&path);
    assert_eq!(batch.entries().len(), 10_000);
    for entry in batch.entries().iter().step_by(999) {
        assert!(matches!(batch.load(entry), Loaded::Source(_)));
    }
}
