//! The compiler and the linker of this machine.

use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::Error;

/// The Rust compiler itself, not the proxy that chooses one.
#[derive(Clone, Debug)]
pub struct Toolchain {
    /// The program `rustc`.
    pub rustc: PathBuf,
    /// The folder that the compiler and its libraries lie in.
    pub sysroot: PathBuf,
    /// The folder with the standard library for this machine.
    pub libraries: PathBuf,
    /// For example `rustc 1.95.0 (f2d3ce0bd 2026-03-21)`.
    pub version: String,
    /// How programs are linked.
    pub linker: Linker,
}

/// How programs are linked.
#[derive(Clone, Debug)]
pub enum Linker {
    /// By calling the linker itself for a shared library, and nothing but the library: this takes a few milliseconds. A
    /// program that was linked once takes everything else from there.
    Direct {
        /// The program.
        program: PathBuf,
        /// Its first arguments.
        options: Vec<OsString>,
        /// The folders that the system's libraries lie in.
        system: Vec<PathBuf>,
    },
    /// By the compiler, in whatever way it does so.
    ByRustc,
}

impl Toolchain {
    /// Looks for the toolchain that cargo uses in `workspace`.
    ///
    /// # Errors
    ///
    /// When there is no Rust compiler.
    pub fn find(workspace: &Path) -> Result<Toolchain, Error> {
        let sysroot = PathBuf::from(output(workspace, "rustc", &["--print", "sysroot"])?);
        let rustc = sysroot.join("bin").join(format!("rustc{}", std::env::consts::EXE_SUFFIX));
        let verbose = output(workspace, &rustc.to_string_lossy(), &["-vV"])?;
        let version = verbose.lines().next().unwrap_or_default().to_owned();
        let host = verbose.lines().find_map(|line| line.strip_prefix("host: ")).unwrap_or_default();
        let target = sysroot.join("lib").join("rustlib").join(host);
        let linker = direct_linker(&target).unwrap_or(Linker::ByRustc);
        Ok(Toolchain { rustc, libraries: target.join("lib"), version, linker, sysroot })
    }
}

impl Toolchain {
    /// The standard library as a shared one. A toolchain holds exactly one.
    pub fn shared_standard_library(&self) -> Option<PathBuf> {
        let files = fs::read_dir(&self.libraries).ok()?.filter_map(|entry| Some(entry.ok()?.path()));
        files.into_iter().find(|path| {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            name.starts_with("libstd-") && name.ends_with(std::env::consts::DLL_SUFFIX)
        })
    }
}

/// What a command prints on standard output, without the last line's end.
fn output(folder: &Path, program: &str, arguments: &[&str]) -> Result<String, Error> {
    let run = Command::new(program).args(arguments).current_dir(folder).output();
    let trouble = |why: String| Error::Toolchain { program: program.to_owned(), why };
    let output = run.map_err(|error| trouble(error.to_string()))?;
    if !output.status.success() {
        return Err(trouble(String::from_utf8_lossy(&output.stderr).trim().to_owned()));
    }
    Ok(String::from_utf8_lossy(&output.stdout).trim_end().to_owned())
}

/// Only for Linux with the GNU C library: elsewhere the standard library is not shared, or linked otherwise.
fn direct_linker(target: &Path) -> Option<Linker> {
    if !cfg!(all(target_os = "linux", target_env = "gnu")) {
        return None;
    }
    let gnu = Path::new("/usr/bin/ld");
    let bundled = target.join("bin").join("rust-lld");
    let (program, flavor) = if gnu.exists() {
        (gnu.to_path_buf(), &[][..])
    } else if bundled.exists() {
        (bundled, &["-flavor", "gnu", "--threads=1"][..])
    } else {
        return None;
    };
    // Without the table of frames, a panic would end the program.
    let options =
        ["-shared", "--eh-frame-hdr", "--build-id=none", "-z", "relro", "-z", "now", "-z", "noexecstack"];
    let options = flavor.iter().chain(&options).map(OsString::from).collect();
    Some(Linker::Direct { program, options, system: sandbox::system_libraries() })
}
