//! Files for the program, and what it says of them.

use std::fs;
use std::path::{Path, PathBuf};

use super::command::view;

/// What it says, and what it complains of.
pub fn run(arguments: &[&str]) -> Result<(String, String), String> {
    let output = view(arguments);
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).unwrap();
    match output.status.success() {
        true => Ok((text(&output.stdout), text(&output.stderr))),
        false => {
            assert_eq!(text(&output.stdout), "", "something was written all the same");
            Err(text(&output.stderr))
        }
    }
}

/// An empty folder with a blank in its name.
pub struct Folder(tempfile::TempDir);

impl Folder {
    pub fn new() -> Folder {
        Folder(tempfile::Builder::new().prefix("with blank ").tempdir().unwrap())
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub fn text(&self, name: &str) -> String {
        self.path(name).to_str().unwrap().to_owned()
    }

    /// What is in it.
    pub fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(self.0.path()).unwrap();
        let mut names: Vec<String> =
            entries.map(|entry| entry.unwrap().file_name().to_string_lossy().into()).collect();
        names.sort();
        names
    }
}

/// A file of the project's own motions.
pub fn data(name: &str) -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data").join(name).to_str().unwrap().to_owned()
}
