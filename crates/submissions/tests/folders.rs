//! Folders with things in them that are no submissions.
#![cfg(unix)]
#![allow(clippy::unwrap_used)] // Helpers of tests.

mod support;

use std::fs::{self, File, Permissions};
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::{PermissionsExt, symlink};
use std::os::unix::net::UnixListener;
use std::path::Path;
use std::process::Command;

use submissions::{Batch, MAX_FILES, Rejection, read_one};
use support::{CODE, Member, code, rejected, source, wanted, write, zip};

fn make_pipe(path: &Path) {
    assert!(Command::new("mkfifo").arg(path).status().unwrap().success());
}

fn read(path: &Path) -> submissions::Loaded {
    read_one(path, &wanted()).1
}

/// The only submission of a folder.
fn read_in(folder: &Path) -> submissions::Loaded {
    let batch = Batch::open(folder, &wanted()).unwrap();
    assert_eq!(batch.entries().len(), 1);
    batch.load(&batch.entries()[0])
}

#[test]
fn links_are_not_followed() {
    let folder = tempfile::tempdir().unwrap();
    let outside = tempfile::tempdir().unwrap();
    write(outside.path().join("fk.rs"), CODE);
    write(outside.path().join("a.zip"), zip(&[Member::stored("fk.rs", CODE)]));
    for (name, target) in [("300000001_A.rs", "fk.rs"), ("300000001_A.zip", "a.zip"), ("300000001_A", "")] {
        let link = folder.path().join(name);
        symlink(outside.path().join(target), &link).unwrap();
        assert_eq!(code(read_in(folder.path())), "link", "{name}");
        fs::remove_file(link).unwrap();
    }
    let inner = folder.path().join("300000001_A");
    fs::create_dir(&inner).unwrap();
    symlink(outside.path().join("fk.rs"), inner.join("fk.rs")).unwrap();
    assert_eq!(code(read_in(folder.path())), "link");
    fs::remove_file(inner.join("fk.rs")).unwrap();
    symlink(outside.path(), inner.join("src")).unwrap();
    assert_eq!(code(read_in(folder.path())), "no_source");
    symlink(&inner, inner.join("loop")).unwrap();
    write(inner.join("deep/fk.rs"), CODE);
    assert_eq!(source(read_in(folder.path())).text, CODE);
}

#[test]
fn the_path_that_was_asked_for_may_be_a_link() {
    let folder = tempfile::tempdir().unwrap();
    write(folder.path().join("real/fk.rs"), CODE);
    symlink(folder.path().join("real"), folder.path().join("link")).unwrap();
    assert_eq!(source(read(&folder.path().join("link"))).text, CODE);
    write(folder.path().join("300000001_A.zip"), zip(&[Member::stored("fk.rs", CODE)]));
    symlink("300000001_A.zip", folder.path().join("b.zip")).unwrap();
    let batch = Batch::open(&folder.path().join("b.zip"), &wanted()).unwrap();
    assert_eq!(source(batch.load(&batch.entries()[0])).text, CODE);
}

#[test]
fn pipes_sockets_and_devices_keep_nobody_waiting() {
    let folder = tempfile::tempdir().unwrap();
    make_pipe(&folder.path().join("300000001_A.rs"));
    assert_eq!(code(read_in(folder.path())), "special_file");
    let inner = tempfile::tempdir().unwrap();
    make_pipe(&inner.path().join("fk.rs"));
    assert_eq!(code(read(inner.path())), "special_file");
    let other = tempfile::tempdir().unwrap();
    let _socket = UnixListener::bind(other.path().join("fk.rs")).unwrap();
    assert_eq!(code(read(other.path())), "special_file");
    assert_eq!(code(read(Path::new("/dev/zero"))), "special_file");
    assert!(Batch::open(Path::new("/dev/zero"), &wanted()).is_err());
}

#[test]
fn a_pipe_beside_the_file_is_not_opened() {
    let folder = tempfile::tempdir().unwrap();
    make_pipe(&folder.path().join("a.zip"));
    make_pipe(&folder.path().join("other.rs"));
    write(folder.path().join("fk.rs"), CODE);
    assert_eq!(source(read(folder.path())).text, CODE);
}

#[test]
fn enormous_files_are_refused_unread() {
    let folder = tempfile::tempdir().unwrap();
    for (name, expected) in [("fk.rs", "too_large"), ("a.zip", "archive_damaged"), ("a.bin", "wrong_type")] {
        let path = folder.path().join(name);
        let file = File::create(&path).unwrap();
        file.set_len(1 << 40).unwrap();
        if name == "a.zip" {
            file.set_len(1 << 20).unwrap();
        }
        let found = code(read(&path));
        assert!(found == expected || found == "not_a_zip", "{name}: {found}");
    }
}

#[test]
fn a_file_that_cannot_be_read_is_said_so() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("fk.rs");
    write(&path, CODE);
    fs::set_permissions(&path, Permissions::from_mode(0o000)).unwrap();
    // Root may read everything.
    match File::open(&path) {
        Ok(_) => assert_eq!(source(read(&path)).text, CODE),
        Err(_) => assert_eq!(code(read(&path)), "unreadable"),
    }
}

#[test]
fn folders_without_end_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let deep: std::path::PathBuf = std::iter::repeat_n("d", 40).collect();
    write(folder.path().join(deep).join("fk.rs"), CODE);
    assert_eq!(code(read(folder.path())), "folder_too_large");
    let wide = tempfile::tempdir().unwrap();
    for i in 0..=MAX_FILES {
        File::create(wide.path().join(i.to_string())).unwrap();
    }
    assert_eq!(code(read(wide.path())), "folder_too_large");
}

#[test]
fn a_folder_is_chosen_from_as_an_archive_is() {
    let folder = tempfile::tempdir().unwrap();
    let archive = zip(&[Member::stored("fk.rs", "zipped")]);
    write(folder.path().join("a.zip"), &archive);
    assert_eq!(source(read(folder.path())).text, "zipped");
    write(folder.path().join("src/fk.rs"), CODE);
    let both = source(read(folder.path()));
    assert_eq!(both.text, CODE);
    assert!(both.remarks[0].contains("a.zip, which was not opened"), "{:?}", both.remarks);
    write(folder.path().join("copy/fk.rs"), CODE);
    let two: Rejection = rejected(read(folder.path()));
    assert_eq!(two.code, "two_candidates");
    assert!(two.why.contains("src/fk.rs") && two.why.contains("copy/fk.rs"), "{two:?}");
    let nested = tempfile::tempdir().unwrap();
    write(nested.path().join("a.zip"), zip(&[Member::stored("b.zip", archive)]));
    assert_eq!(code(read(nested.path())), "archive_nested");
}

#[test]
fn names_that_are_no_text_are_shown_as_well_as_can_be() {
    let folder = tempfile::tempdir().unwrap();
    for name in [&b"300000001_Ter\xffry.rs"[..], b"300000001_Ter\xfery.rs", b"\x1b[31m\nred.rs"] {
        write(folder.path().join(std::ffi::OsStr::from_bytes(name)), CODE);
    }
    let batch = Batch::open(folder.path(), &wanted()).unwrap();
    assert_eq!(batch.entries().len(), 3);
    for entry in batch.entries() {
        assert!(entry.file.chars().all(|c| !c.is_control()), "{entry:?}");
        assert_eq!(source(batch.load(entry)).text, CODE);
    }
}
