//! From a student's source to a program that can be asked.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::time::Duration;
use std::{fs, io};

use results::{CompileError, Verdict};
use sandbox::{Confinement, Finished, Limit, Limits, Sandbox};

use crate::diagnostics;
use crate::exercise::Exercise;
use crate::kit::{Host, Kit};
use crate::toolchain::{Linker, Toolchain};

/// Compiles submissions, each in a folder of its own.
#[derive(Debug)]
pub struct Compiler<'a> {
    /// The exercise.
    pub exercise: &'a Exercise,
    /// The compiler.
    pub toolchain: &'a Toolchain,
    /// The libraries.
    pub kit: &'a Kit,
    /// Where it runs.
    pub sandbox: &'a Sandbox,
    /// What a compiler may use.
    pub limits: Limits,
}

/// A program that answers by a student's functions.
#[derive(Clone, Debug)]
pub struct Worker {
    /// The program.
    pub program: PathBuf,
    /// What it must be able to read, itself included.
    pub reads: Vec<PathBuf>,
    /// Its environment.
    pub environment: Vec<(OsString, OsString)>,
}

/// What came of compiling.
#[derive(Debug)]
pub enum Compiled {
    /// A program.
    Worker(Worker),
    /// No program. Whose fault it is, is in the verdict.
    Not(Verdict),
}

impl Compiler<'_> {
    /// Compiles `source` in `folder`, which is made anew, with the compiler confined to it. `slot` is the number of the
    /// job that does so.
    ///
    /// # Errors
    ///
    /// When this machine fails, not the source.
    pub fn compile(&self, slot: u32, folder: &Path, source: &str) -> io::Result<(Compiled, Duration)> {
        match fs::remove_dir_all(folder) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error),
            _ => {}
        }
        let (build, run) = (&folder.join("build"), &folder.join("run"));
        fs::create_dir_all(run)?;
        let library = build.join(self.exercise.library_path());
        if let Some(parent) = library.parent() {
            fs::create_dir_all(parent)?;
        }
        fs::write(&library, self.exercise.worker())?;
        fs::write(build.join(self.exercise.path()), source)?;

        let rustc = self.run(slot, build, &self.toolchain.rustc, &self.rustc_arguments())?;
        let mut time = rustc.cpu;
        if !is_success(&rustc) {
            return Ok((Compiled::Not(self.verdict(&rustc, build)), time));
        }
        if let Linker::Direct { program, options, .. } = &self.toolchain.linker {
            let files = ["-soname", Host::LIBRARY, "-o", Host::LIBRARY, "worker.o"].map(OsString::from);
            let linker = self.run(slot, build, program, &[options.as_slice(), &files].concat())?;
            time += linker.cpu;
            if !is_success(&linker) {
                return Ok((Compiled::Not(link_verdict(&linker)), time));
            }
        }
        Ok((Compiled::Worker(self.worker(build, run)?), time))
    }

    /// Takes what was linked out of the folder that the compiler could write, to where nothing confined can.
    fn worker(&self, build: &Path, run: &Path) -> io::Result<Worker> {
        let (Linker::Direct { system, .. }, Some(host)) = (&self.toolchain.linker, &self.kit.host) else {
            let program = run.join(program_name());
            copy_program(&build.join(program_name()), &program)?;
            return Ok(Worker { reads: vec![program.clone()], program, environment: Vec::new() });
        };
        copy_program(&build.join(Host::LIBRARY), &run.join(Host::LIBRARY))?;
        let mut reads = system.clone();
        reads.extend([run.to_path_buf(), host.program.clone(), host.exam.clone()]);
        reads.extend(self.toolchain.shared_standard_library());
        let environment = vec![("LD_LIBRARY_PATH".into(), run.into())];
        Ok(Worker { program: host.program.clone(), reads, environment })
    }

    fn run(&self, slot: u32, folder: &Path, program: &Path, arguments: &[OsString]) -> io::Result<Finished> {
        self.sandbox.run(slot, &self.confinement(folder), program, arguments)
    }

    /// What the compiler and the linker may read: the toolchain, our libraries, the system's libraries.
    fn confinement(&self, folder: &Path) -> Confinement {
        let mut read = vec![self.toolchain.sysroot.clone(), self.kit.dependencies.clone()];
        read.extend(self.kit.host.iter().map(|host| host.exam.clone()));
        if let Linker::Direct { program, system, .. } = &self.toolchain.linker {
            read.push(program.clone());
            read.extend(system.iter().cloned());
        }
        // `env!` gives what it gives under cargo, as far as that says nothing about this machine.
        let mut environment: Vec<(OsString, OsString)> = vec![
            ("TMPDIR".into(), folder.into()),
            ("CARGO_PKG_NAME".into(), self.exercise.name().into()),
            ("CARGO_CRATE_NAME".into(), self.exercise.crate_name().into()),
            ("CARGO_PKG_VERSION".into(), env!("CARGO_PKG_VERSION").into()),
            ("CARGO_MANIFEST_DIR".into(), ".".into()),
        ];
        if matches!(self.toolchain.linker, Linker::ByRustc) {
            // The compiler looks for the C compiler's linker, and on Windows for much more.
            environment.extend(std::env::vars_os());
        }
        Confinement { read, folder: Some(folder.to_path_buf()), environment, limits: self.limits }
    }

    /// As cargo would call it for `cargo test -p fk`, but for what only debuggers need.
    fn rustc_arguments(&self) -> Vec<OsString> {
        let is_direct = matches!(self.toolchain.linker, Linker::Direct { .. });
        let name = self.exercise.crate_name();
        let fixed = ["--edition", "2024", "--crate-name", &name, "--crate-type", "bin"];
        let codegen = ["-Copt-level=0", "-Cdebuginfo=0", "-Ccodegen-units=1", "-Cembed-bitcode=no"];
        // Warnings cost time and give no points. `--cap-lints` would do more than that: it lifts the ban of unsafe
        // code and the end of endless constants.
        let lints = ["-Wunused_qualifications", "-Awarnings", "-Funsafe_code", "--error-format=json"];
        let conditions = ["--check-cfg", "cfg(docsrs,test)", "--check-cfg", "cfg(feature, values())"];
        let fixed = fixed.into_iter().chain(codegen).chain(lints).chain(conditions);
        let mut arguments: Vec<OsString> = fixed.map(OsString::from).collect();
        for (name, file) in &self.kit.externs {
            let mut value = OsString::from(format!("{name}="));
            value.push(file);
            arguments.extend(["--extern".into(), value]);
        }
        let mut dependencies = OsString::from("dependency=");
        dependencies.push(&self.kit.dependencies);
        let (emit, output) = if is_direct { ("obj", "worker.o".into()) } else { ("link", program_name()) };
        arguments.extend(["-L".into(), dependencies, "--emit".into(), emit.into()]);
        arguments.extend(["-o".into(), output.into(), self.exercise.library_path().into()]);
        arguments
    }

    fn verdict(&self, rustc: &Finished, folder: &Path) -> Verdict {
        let hide = [
            (folder, "."),
            (self.toolchain.sysroot.as_path(), "rust"),
            (self.kit.dependencies.as_path(), "libraries"),
        ];
        if let Some(what) = machine_trouble(rustc) {
            return Verdict::HarnessError { what };
        }
        let found = diagnostics::read(&rustc.stderr, &self.exercise.path(), &hide);
        match &rustc.limit {
            // Errors without end are errors all the same.
            Some(Limit::Output) if !found.errors.is_empty() => {}
            Some(limit) => return too_expensive(limit),
            None if found.errors.is_empty() => {
                let how = rustc.status.map_or_else(|| "unknown".to_owned(), |status| status.to_string());
                return Verdict::DoesNotCompile { errors: vec![crashed(&how)], left_out: 0 };
            }
            None => {}
        }
        Verdict::DoesNotCompile { errors: found.errors, left_out: found.left_out }
    }
}

/// Trouble that no source can bring about: the machine has no thread, no room or no memory left. It must not cost points.
fn machine_trouble(finished: &Finished) -> Option<String> {
    if finished.limit.is_some() {
        return None;
    }
    #[cfg(unix)]
    if finished.status.is_some_and(|status| std::os::unix::process::ExitStatusExt::signal(&status) == Some(9))
    {
        return Some("the system ended the compiler, perhaps for lack of memory".to_owned());
    }
    let words = ["Resource temporarily unavailable", "No space left on device", "Disk quota exceeded"];
    let text = String::from_utf8_lossy(&finished.stderr);
    // Where the source is quoted, the words may be the student's.
    let is_own = |line: &&str| !line.contains("\"spans\":[{") && words.iter().any(|word| line.contains(word));
    let line = text.lines().find(is_own)?;
    Some(format!("the compiler or the linker ran out of something: {}", diagnostics::clean(line, 300)))
}

fn is_success(finished: &Finished) -> bool {
    finished.limit.is_none() && finished.status.is_some_and(|status| status.success())
}

/// Copies a file that something confined has written.
fn copy_program(from: &Path, to: &Path) -> io::Result<()> {
    let mut options = fs::OpenOptions::new();
    options.read(true);
    // No honest linker leaves a link.
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::custom_flags(&mut options, libc::O_NOFOLLOW | libc::O_NONBLOCK);
    let mut program = options.open(from)?;
    if !program.metadata()?.is_file() {
        return Err(io::Error::other("the linker left something that is no file"));
    }
    let mut options = fs::OpenOptions::new();
    options.write(true).create_new(true);
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::mode(&mut options, 0o755);
    io::copy(&mut program, &mut options.open(to)?).map(drop)
}

fn program_name() -> String {
    format!("worker{}", std::env::consts::EXE_SUFFIX)
}

fn too_expensive(limit: &Limit) -> Verdict {
    let (limit, text) = match limit {
        Limit::Cpu | Limit::Wall => {
            ("time", "Compiling it takes too long. Look for macros or constants that grow without end.")
        }
        Limit::Memory => {
            ("memory", "Compiling it takes too much memory. Look for macros, types or statics that are huge.")
        }
        Limit::Output => ("output", "The compiler's messages have no end."),
    };
    Verdict::TooExpensiveToCompile { limit: limit.to_owned(), text: text.to_owned() }
}

/// What a student reads when the compiler ends without a word.
fn crashed(how: &str) -> CompileError {
    CompileError {
        message: "the compiler itself broke down on this file".to_owned(),
        line: None,
        column: None,
        text: format!(
            "The compiler itself broke down on this file ({how}). Code that is nested very deeply does that."
        ),
    }
}

/// What compiles also links, unless the code asks the linker for something.
fn link_verdict(linker: &Finished) -> Verdict {
    if let Some(what) = machine_trouble(linker) {
        return Verdict::HarnessError { what };
    }
    match &linker.limit {
        Some(limit) => too_expensive(limit),
        None => Verdict::DoesNotCompile {
            errors: vec![CompileError {
                message: "the file compiles, but cannot be linked".to_owned(),
                line: None,
                column: None,
                text: diagnostics::clean(&String::from_utf8_lossy(&linker.stderr), 2000),
            }],
            left_out: 0,
        },
    }
}

#[cfg(all(test, unix))]
mod tests {
    use std::os::unix::process::ExitStatusExt;
    use std::process::ExitStatus;

    use super::*;

    fn finished(stderr: &str, status: i32) -> Finished {
        Finished {
            status: Some(ExitStatus::from_raw(status)),
            stdout: Vec::new(),
            stderr: stderr.as_bytes().to_vec(),
            limit: None,
            cpu: Duration::ZERO,
        }
    }

    #[test]
    fn a_machine_without_room_costs_no_points() {
        let full = r#"{"message":"failed to write: No space left on device (os error 28)","level":"error","spans":[]}"#;
        assert!(machine_trouble(&finished(full, 256)).is_some());
        assert!(machine_trouble(&finished("ld: final link failed: No space left on device", 256)).is_some());
        assert!(machine_trouble(&finished("", 9)).is_some(), "killed");
    }

    #[test]
    fn the_students_own_words_are_not_taken_for_it() {
        let own = r#"{"message":"No space left on device","level":"error","spans":[{"line_start":1}]}"#;
        assert_eq!(machine_trouble(&finished(own, 256)), None);
        assert_eq!(machine_trouble(&finished("error", 11)), None, "nested too deeply");
        let limited = Finished { limit: Some(Limit::Memory), ..finished("", 9) };
        assert_eq!(machine_trouble(&limited), None);
    }
}
