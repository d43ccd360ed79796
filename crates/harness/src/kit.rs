//! What a submission is compiled and linked with: the libraries that a student's file may use, built once.

use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use serde_json::Value;

use crate::toolchain::{Linker, Toolchain};
use crate::{Error, digest, workspace};

/// The libraries, built. Cargo keeps them, so that this takes a moment from the second time on.
#[derive(Clone, Debug)]
pub struct Kit {
    /// `name` and file of each library that the student's file may name.
    pub externs: Vec<(String, PathBuf)>,
    /// The folder with what these libraries use in turn.
    pub dependencies: PathBuf,
    /// What a program needs besides its own library, where the linker is called directly.
    pub host: Option<Host>,
}

/// A program without a main function of its own: it takes that from [`Host::LIBRARY`], which the system's loader looks for.
/// So linking a submission is making that library, without a look at any other.
#[derive(Clone, Debug)]
pub struct Host {
    /// The program.
    pub program: PathBuf,
    /// The library with everything that is asked and answered.
    pub exam: PathBuf,
}

impl Host {
    /// The name of the library with the main function.
    pub const LIBRARY: &str = "libworker.so";
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
        let host = match &toolchain.linker {
            Linker::Direct { program, options, .. } => {
                let exam = find("exam")?;
                Some(Host { program: host(workspace, toolchain, program, options, &exam)?, exam })
            }
            Linker::ByRustc => None,
        };
        Ok(Kit { externs, dependencies, host })
    }
}

/// Links the host program, if that was not done before.
fn host(
    workspace: &Path,
    toolchain: &Toolchain,
    linker: &Path,
    options: &[OsString],
    exam: &Path,
) -> Result<PathBuf, Error> {
    let trouble = |error: std::io::Error| Error::Kit(error.to_string());
    let standard = toolchain.shared_standard_library();
    let standard =
        standard.ok_or_else(|| Error::Kit("the toolchain has no shared standard library".to_owned()))?;
    let parts = format!("{}\n{}\n{}", toolchain.version, standard.display(), exam.display());
    let folder = workspace::target(workspace).join("worker");
    let program = folder.join(format!("host-{}", &digest::of(parts.as_bytes())[..16]));
    if program.exists() {
        return Ok(program);
    }
    let scratch = tempfile::tempdir_in(&folder).map_err(trouble)?;
    let path = |name: &str| scratch.path().join(name);
    fs::write(path("main.rs"), "fn main() {}").map_err(trouble)?;
    let run = |command: &mut Command| {
        let output = command.current_dir(scratch.path()).output().map_err(trouble)?;
        let words = || String::from_utf8_lossy(&output.stderr).trim().to_owned();
        if output.status.success() { Ok(()) } else { Err(Error::Kit(words())) }
    };
    run(Command::new(&toolchain.rustc).args([
        "--crate-type",
        "bin",
        "--emit",
        "obj",
        "-o",
        "main.o",
        "main.rs",
    ]))?;
    run(Command::new(linker).args(options).args(["-soname", Host::LIBRARY, "-o", Host::LIBRARY, "main.o"]))?;
    let folders = [exam.parent(), standard.parent()].into_iter().flatten();
    let places = folders.map(|folder| format!("-Wl,-rpath,{}", folder.display()));
    run(Command::new("cc")
        .args(["-Wl,--no-as-needed", "-o", "host"])
        .arg(path(Host::LIBRARY))
        .arg(exam)
        .arg(&standard)
        .args(["-lm", "-lgcc_s"])
        .args(places))?;
    // Another command may have been faster: both made the same.
    fs::rename(path("host"), &program).map_err(trouble)?;
    Ok(program)
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
