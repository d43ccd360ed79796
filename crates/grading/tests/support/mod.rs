//! A copy of the workspace in which the exercise is edited, as a student does.
#![allow(dead_code)] // No test uses all of it.
#![allow(clippy::unwrap_used)] // Helpers of tests.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

/// This workspace.
pub const WORKSPACE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// A copy of what the exercise needs.
pub struct Course {
    /// Where the copy is.
    pub folder: PathBuf,
}

impl Course {
    /// The copy of this name, brought up to date.
    pub fn open(name: &str) -> Course {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        for part in ["Cargo.toml", "Cargo.lock", ".cargo", "crates", "exercises", "solutions"] {
            copy(&Path::new(WORKSPACE).join(part), &folder.join(part));
        }
        Course { folder }
    }

    /// What a student does: saves the file.
    pub fn save(&self, source: &str) {
        self.save_exercise("fk", source);
    }

    /// The same in another exercise.
    pub fn save_exercise(&self, exercise: &str, source: &str) {
        let module = exercise.replace('-', "_");
        let file = self.folder.join(format!("exercises/{exercise}/src/{module}.rs"));
        write(&file, source.as_bytes());
    }

    /// What a student types: `cargo test -p fk`.
    pub fn test_command(&self) -> Command {
        self.test_exercise("fk")
    }

    /// The same in another exercise.
    pub fn test_exercise(&self, exercise: &str) -> Command {
        let mut command = cargo(&self.folder);
        command.args(["test", "-p", exercise]);
        command
    }
}

/// Cargo as a student would call it, not as a part of the cargo that runs these tests.
pub fn cargo(folder: &Path) -> Command {
    let mut command = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.current_dir(folder);
    for (name, _) in env::vars_os() {
        let name = name.to_string_lossy().into_owned();
        if name.starts_with("CARGO_") && name != "CARGO_HOME" || name.starts_with("RUST_BACKTRACE") {
            command.env_remove(name);
        }
    }
    command
}

/// Copies what has changed, so that only that is built again.
fn copy(from: &Path, to: &Path) {
    if from.is_dir() {
        for entry in fs::read_dir(from).unwrap() {
            let name = entry.unwrap().file_name();
            copy(&from.join(&name), &to.join(&name));
        }
    } else {
        write(to, &fs::read(from).unwrap());
    }
}

/// A solution with something else in place of one of its lines, or of a part of it.
pub fn with(solution: &str, line: &str, other: &str) -> String {
    assert!(solution.contains(line), "the solution has changed");
    solution.replace(line, other)
}

/// Writes what has changed.
pub fn write(path: &Path, bytes: &[u8]) {
    if fs::read(path).is_ok_and(|old| old == bytes) {
        return;
    }
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(path, bytes).unwrap();
}
