//! Where things lie.

use std::env;
use std::path::{Path, PathBuf};

use crate::Error;

/// The workspace that this program belongs to: the one that cargo runs it from, or the one that it was built in.
///
/// # Errors
///
/// When neither is there.
pub fn find() -> Result<PathBuf, Error> {
    let candidates =
        [env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from), Some(env!("CARGO_MANIFEST_DIR").into())];
    let roots = candidates.into_iter().flatten().filter_map(|folder| {
        let root = folder.ancestors().nth(2)?.to_path_buf();
        root.join("exercises").is_dir().then_some(root)
    });
    roots.into_iter().next().ok_or(Error::NoWorkspace)
}

/// The folder for what is built.
pub fn target(workspace: &Path) -> PathBuf {
    match env::var_os("CARGO_TARGET_DIR") {
        Some(folder) => workspace.join(folder),
        None => workspace.join("target"),
    }
}

/// Cargo's own folder, where the sources of libraries lie.
pub fn cargo_home() -> Option<PathBuf> {
    env::var_os("CARGO_HOME").map(PathBuf::from).or_else(|| Some(env::home_dir()?.join(".cargo")))
}
