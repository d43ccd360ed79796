//! What the watcher tells of real files, written in the ways of editors.
#![allow(clippy::unwrap_used)] // Helpers of tests.

use std::fs::{self, OpenOptions};
use std::io::Write;
use std::path::PathBuf;
use std::sync::mpsc;
use std::thread;
use std::time::{Duration, Instant};

use tempfile::TempDir;
use viewer::live::watch::{Baseline, Change, Watcher};

/// Far longer than a change takes to be told.
const PATIENCE: Duration = Duration::from_secs(60);

/// A folder with blanks in its name, an exercise and a motion.
struct Saved {
    folder: TempDir,
    watcher: Watcher,
}

impl Saved {
    fn new() -> Saved {
        let folder = tempfile::Builder::new().prefix("with blanks ").tempdir().unwrap();
        for (path, content) in
            [("src/fk.rs", "first"), ("src/lib.rs", "mod fk;"), ("data/a motion.bvh", "HIERARCHY")]
        {
            let path = folder.path().join(path);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, content).unwrap();
        }
        let baseline =
            Baseline::now(&folder.path().join("src"), &[vec![folder.path().join("data/a motion.bvh")]]);
        let watcher = Watcher::start(baseline, |_| ());
        assert_eq!(watcher.note(), None, "the system tells what happens in a temporary folder");
        Saved { folder, watcher }
    }

    fn path(&self, path: &str) -> PathBuf {
        self.folder.path().join(path)
    }

    fn next(&mut self) -> Change {
        let start = Instant::now();
        loop {
            if let Some(change) = self.watcher.changes().next() {
                return change;
            }
            assert!(start.elapsed() < PATIENCE, "no change was told");
            thread::yield_now();
        }
    }

    /// Saves something else, and sees that nothing was told before that.
    fn nothing_until_the_motion_is_saved(&mut self, content: &str) {
        fs::write(self.path("data/a motion.bvh"), content).unwrap();
        assert_eq!(self.next(), Change::Motion(self.path("data/a motion.bvh")));
        assert_eq!(self.watcher.changes().next(), None);
    }
}

#[test]
fn a_file_that_is_written_in_place_is_told_once() {
    let mut saved = Saved::new();
    fs::write(saved.path("src/fk.rs"), "second").unwrap();
    assert_eq!(saved.next(), Change::Exercise);
    saved.nothing_until_the_motion_is_saved("HIERARCHY 2");
}

#[test]
fn a_file_that_takes_the_old_ones_place_is_told() {
    let mut saved = Saved::new();
    for content in ["second", "third"] {
        fs::write(saved.path("src/.fk.rs.new"), content).unwrap();
        fs::rename(saved.path("src/.fk.rs.new"), saved.path("src/fk.rs")).unwrap();
        assert_eq!(saved.next(), Change::Exercise);
    }
    // Others put the old one aside first.
    fs::rename(saved.path("src/fk.rs"), saved.path("src/fk.rs~")).unwrap();
    fs::write(saved.path("src/fk.rs"), "fourth").unwrap();
    assert_eq!(saved.next(), Change::Exercise);
    saved.nothing_until_the_motion_is_saved("HIERARCHY 2");
}

#[test]
fn a_file_that_is_emptied_or_taken_away_first_is_told_once_it_is_back() {
    let mut saved = Saved::new();
    let path = saved.path("src/fk.rs");
    let mut file = OpenOptions::new().write(true).truncate(true).open(&path).unwrap();
    file.write_all(b"second").unwrap();
    drop(file);
    assert_eq!(saved.next(), Change::Exercise);

    fs::remove_file(&path).unwrap();
    fs::write(&path, "third").unwrap();
    assert_eq!(saved.next(), Change::Exercise);
    saved.nothing_until_the_motion_is_saved("HIERARCHY 2");
}

#[test]
fn a_file_that_stays_away_is_told_and_so_is_its_return() {
    let mut saved = Saved::new();
    let path = saved.path("src/fk.rs");
    fs::remove_file(&path).unwrap();
    assert_eq!(saved.next(), Change::Exercise);
    fs::write(&path, "first").unwrap();
    assert_eq!(saved.next(), Change::Exercise);
}

#[test]
fn what_changes_nothing_is_not_told() {
    let mut saved = Saved::new();
    let path = saved.path("src/fk.rs");
    fs::write(&path, "first").unwrap();
    fs::File::options().append(true).open(&path).unwrap().set_modified(std::time::SystemTime::now()).unwrap();
    fs::read(&path).unwrap();
    fs::write(saved.path("src/notes.txt"), "not built").unwrap();
    fs::write(saved.path("src/.#fk.rs"), "an editor's own").unwrap();
    saved.nothing_until_the_motion_is_saved("HIERARCHY 2");
}

#[test]
fn after_a_burst_the_last_content_is_told() {
    let mut saved = Saved::new();
    let path = saved.path("src/fk.rs");
    for i in 0..50 {
        fs::write(&path, format!("content {i}")).unwrap();
    }
    // However many were told, the last was: after some time to tell them all, the same content again is nothing new.
    for i in 0..5 {
        fs::write(saved.path("data/a motion.bvh"), format!("HIERARCHY {i}")).unwrap();
        while saved.next() == Change::Exercise {}
    }
    fs::write(&path, "content 49").unwrap();
    saved.nothing_until_the_motion_is_saved("HIERARCHY");
    fs::write(&path, "content 48").unwrap();
    assert_eq!(saved.next(), Change::Exercise);
}

#[test]
fn a_new_source_and_a_new_motion_are_told() {
    let mut saved = Saved::new();
    fs::write(saved.path("src/helper.rs"), "fn help() {}").unwrap();
    assert_eq!(saved.next(), Change::Exercise);
    saved.nothing_until_the_motion_is_saved("HIERARCHY 2");
}

#[test]
fn what_is_saved_before_the_watcher_listens_is_told_too() {
    let folder = tempfile::tempdir().unwrap();
    let source = folder.path().join("fk.rs");
    fs::write(&source, "first").unwrap();
    let baseline = Baseline::now(folder.path(), &[]);
    fs::write(&source, "second").unwrap();
    let (sender, changes) = mpsc::channel();
    let _watcher = Watcher::start(baseline, move |change| drop(sender.send(change.clone())));
    assert_eq!(changes.recv_timeout(PATIENCE).unwrap(), Change::Exercise);
}

#[test]
fn without_word_from_the_system_the_files_are_looked_at() {
    let folder = tempfile::tempdir().unwrap();
    let source = folder.path().join("not there yet");
    let mut watcher = Watcher::start(Baseline::now(&source, &[]), |_| ());
    let note = watcher.note().unwrap();
    assert!(note.contains("twice a second"), "{note}");
    fs::create_dir(&source).unwrap();
    fs::write(source.join("fk.rs"), "first").unwrap();
    let start = Instant::now();
    while watcher.changes().next() != Some(Change::Exercise) {
        assert!(start.elapsed() < PATIENCE);
        thread::yield_now();
    }
}
