//! What a submission is compiled and linked with: the libraries that a student's file may use, built once.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use serde_json::Value;

use crate::toolchain::{Linker, Toolchain};
use crate::{Error, workspace};

/// The libraries, built. Cargo keeps them, so that this takes a moment from the second time on.
#[derive(Clone, Debug)]
pub struct Kit {
    /// `name` and file of each library that the student's file may name.
    pub externs: Vec<(String, PathBuf)>,
    /// The folder with what these libraries use in turn.
    pub dependencies: PathBuf,
    /// The shared library to link with, where the linker is called directly.
    pub shared: Option<PathBuf>,
}

/// The libraries that an exercise's package depends on.
const LIBRARIES: [&str; 3] = ["exam", "glam", "skeleton"];

impl Kit {
    /// Builds what is not up to date. `say` is told, in words, what takes a while.
    ///
    /// # Errors
    ///
    /// When cargo fails.
    pub fn build(workspace: &Path, toolchain: &Toolchain) -> Result<Kit, Error> {
        let is_shared = matches!(toolchain.linker, Linker::Direct { .. });
        let crate_type = if is_shared { "dylib" } else { "rlib" };
        let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
        let mut command = Command::new(cargo);
        // The profile is the one of `cargo test`: what a student tries and what is marked behave alike.
        command
            .args(["rustc", "--quiet", "--locked", "--package", "exam", "--lib", "--crate-type", crate_type])
            .arg("--message-format=json-render-diagnostics")
            .arg("--target-dir")
            .arg(workspace::target(workspace).join("worker"))
            .current_dir(workspace)
            .env("CARGO_ENCODED_RUSTFLAGS", flags(workspace, is_shared))
            .stdin(Stdio::null())
            .stderr(Stdio::inherit());
        let output = command.output().map_err(|error| Error::Kit(error.to_string()))?;
        if !output.status.success() {
            return Err(Error::Kit(format!("cargo ended with {}", output.status)));
        }
        let artifacts = Artifacts::from_messages(&output.stdout);
        let find = |name: &str| {
            let wanted = if name == "exam" && is_shared { std::env::consts::DLL_EXTENSION } else { "rlib" };
            artifacts.find(name, wanted).ok_or_else(|| Error::Kit(format!("cargo built no library `{name}`")))
        };
        let mut externs = Vec::new();
        for name in LIBRARIES {
            externs.push((name.to_owned(), find(name)?));
        }
        let dependencies = find("glam")?.parent().map(Path::to_path_buf).unwrap_or_default();
        let shared = if is_shared { Some(find("exam")?) } else { None };
        Ok(Kit { externs, dependencies, shared })
    }
}

/// Where sources lie on this machine must not reach a student by a compiler's note.
fn flags(workspace: &Path, is_shared: bool) -> String {
    let mut flags = vec![format!("--remap-path-prefix={}=.", workspace.display())];
    if let Some(home) = workspace::cargo_home() {
        flags.push(format!("--remap-path-prefix={}=cargo", home.display()));
    }
    if is_shared {
        flags.push("-Cprefer-dynamic".to_owned());
    }
    // The character that cargo wants between them: paths may hold spaces.
    flags.join("\u{1f}")
}

/// The files that cargo says it built.
struct Artifacts(Vec<(String, PathBuf)>);

impl Artifacts {
    fn from_messages(lines: &[u8]) -> Artifacts {
        let messages =
            lines.split(|&byte| byte == b'\n').filter_map(|line| serde_json::from_slice(line).ok());
        let artifacts = messages.filter(|message: &Value| message["reason"] == "compiler-artifact");
        let files = artifacts.flat_map(|message| {
            let name = message["target"]["name"].as_str().unwrap_or_default().to_owned();
            let files = message["filenames"].as_array().cloned().unwrap_or_default();
            files.into_iter().filter_map(move |file| Some((name.clone(), PathBuf::from(file.as_str()?))))
        });
        Artifacts(files.collect())
    }

    fn find(&self, name: &str, extension: &str) -> Option<PathBuf> {
        let is_it = |(crate_name, file): &&(String, PathBuf)| {
            crate_name == name && file.extension().is_some_and(|found| found == extension)
        };
        self.0.iter().find(is_it).map(|(_, file)| file.clone())
    }
}
