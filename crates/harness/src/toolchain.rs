//! The compiler and the linker of this machine.

use std::ffi::OsString;
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
    /// The standard library for this machine.
    pub libraries: PathBuf,
    /// For example `rustc 1.95.0 (f2d3ce0bd 2026-03-21)`.
    pub version: String,
    /// How programs are linked.
    pub linker: Linker,
}

/// How programs are linked.
#[derive(Clone, Debug)]
pub enum Linker {
    /// By calling the linker itself, against shared libraries: this takes a few milliseconds.
    Direct {
        /// The program.
        program: PathBuf,
        /// Its arguments before the compiled file.
        before: Vec<OsString>,
        /// Its arguments after our own libraries.
        after: Vec<OsString>,
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
        let linker = direct_linker(workspace, &target).unwrap_or(Linker::ByRustc);
        Ok(Toolchain { rustc, libraries: target.join("lib"), version, linker, sysroot })
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
fn direct_linker(workspace: &Path, target: &Path) -> Option<Linker> {
    let loader = match (cfg!(all(target_os = "linux", target_env = "gnu")), std::env::consts::ARCH) {
        (true, "x86_64") => "/lib64/ld-linux-x86-64.so.2",
        (true, "aarch64") => "/lib/ld-linux-aarch64.so.1",
        _ => return None,
    };
    // The C compiler knows where these lie. It gives back the bare name of what it does not find.
    let find = |name: &str| {
        let path = PathBuf::from(output(workspace, "cc", &[&format!("-print-file-name={name}")]).ok()?);
        path.is_absolute().then(|| path.canonicalize().ok())?
    };
    let gnu = Path::new("/usr/bin/ld");
    let bundled = target.join("bin").join("rust-lld");
    let (program, flavor) = if gnu.exists() {
        (gnu.to_path_buf(), &[][..])
    } else if bundled.exists() {
        (bundled, &["-flavor", "gnu"][..])
    } else {
        return None;
    };
    let options = ["-pie", "--eh-frame-hdr", "--gc-sections", "--build-id=none", "-z", "relro", "-z", "now"];
    let more = ["-z", "noexecstack", "--dynamic-linker", loader];
    let mut before: Vec<OsString> = flavor.iter().chain(&options).chain(&more).map(OsString::from).collect();
    before.extend([find("Scrt1.o")?.into(), find("crti.o")?.into()]);
    let libraries = [find("libgcc_s.so.1")?, find("libm.so.6")?, find("libc.so.6")?];
    let after = libraries.iter().map(OsString::from).chain([find("crtn.o")?.into()]).collect();

    let mut system = sandbox::system_libraries();
    let files = libraries.iter().cloned().chain(["Scrt1.o", "crti.o", "crtn.o"].into_iter().filter_map(find));
    system.extend(files.filter_map(|file| Some(file.parent()?.to_path_buf())));
    system.sort();
    system.dedup();
    Some(Linker::Direct { program, before, after, system })
}
