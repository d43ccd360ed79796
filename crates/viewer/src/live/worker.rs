//! Compiling the student's functions into a program that can be asked.

use std::fs::File;
use std::io::{self, BufRead, BufReader, IsTerminal, Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread;
use std::time::SystemTime;

use exam::WorkerProcess;
use serde_json::Value;

use crate::live::diagnostic::{self, Found};
use crate::live::package::Package;
use crate::live::version::Version;

/// Why the student's functions cannot be shown, in words for the student.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Trouble {
    /// What happened, in one short line.
    pub headline: String,
    /// More about it, line by line.
    pub details: Vec<String>,
}

/// Stands below the few lines that the window has room for.
const IN_TERMINAL: &str = "The compiler's own words are in the terminal.";

impl Trouble {
    /// Whether the terminal has been told already, and better.
    pub fn is_in_terminal(&self) -> bool {
        self.details.last().is_some_and(|line| line == IN_TERMINAL)
    }
}

/// A program that answers for one version of an exercise's functions.
pub struct Program {
    executable: PathBuf,
    version: Version,
}

impl Program {
    /// A process of it, started by the first question. It is ended when the version is abandoned; until then what it prints
    /// goes to the terminal.
    pub fn worker(&self) -> WorkerProcess {
        let worker = WorkerProcess::new(Command::new(&self.executable))
            .printing_to(self.version.voice(io::stdout()))
            .errors_to(self.version.voice(io::stderr()))
            // The voices have a limit of their own, for every question.
            .print_limit(usize::MAX);
        self.ending(worker)
    }

    /// The same, for questions about nothing that is shown: what it prints is lost.
    pub fn silent_worker(&self) -> WorkerProcess {
        self.ending(
            WorkerProcess::new(Command::new(&self.executable)).printing_to(io::sink()).errors_to(io::sink()),
        )
    }

    fn ending(&self, worker: WorkerProcess) -> WorkerProcess {
        let stopper = worker.stopper();
        self.version.when_abandoned(move || stopper.stop());
        worker
    }
}

/// Compiles `package` in the workspace that `folder` lies in, for `version`, and gives the program that runs its functions.
///
/// What the compiler says goes to the terminal as it is. The program is found by cargo's own word, wherever its
/// target folder is.
///
/// # Errors
///
/// When cargo cannot be started or the package does not compile.
pub fn compile(package: Package, folder: &Path, version: &Version) -> Result<Program, Trouble> {
    run(package, cargo_build(package, folder), version)
}

/// The same, with `target` as the target folder: two copies of the workspace cannot share one.
///
/// # Errors
///
/// As for [`compile`].
pub fn compile_into(
    target: &Path,
    package: Package,
    folder: &Path,
    version: &Version,
) -> Result<Program, Trouble> {
    let mut command = cargo_build(package, folder);
    command.arg("--target-dir").arg(target);
    run(package, command, version)
}

/// Lets cargo build `package` again although its file may be older than what was built last: a copy that is put in its
/// place keeps its time. Cargo looks at times, and not at what files hold.
pub fn make_stale(package: Package, folder: &Path) {
    let fixed = package.sources(folder).join("lib.rs");
    // Where that cannot be done, newer files are built all the same.
    let _ = File::options().append(true).open(fixed).and_then(|file| file.set_modified(SystemTime::now()));
}

fn cargo_build(package: Package, folder: &Path) -> Command {
    let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    let color = if io::stderr().is_terminal() { "always" } else { "never" };
    command
        .args(["build", "--quiet", "--package", package.name(), "--bin", &package.worker(), "--color", color])
        .arg("--message-format=json-diagnostic-rendered-ansi")
        .current_dir(folder)
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    command
}

fn run(package: Package, mut command: Command, version: &Version) -> Result<Program, Trouble> {
    // The build itself is never ended: what it leaves half-written could be taken for the next one's.
    let mut child = command.spawn().map_err(|error| Trouble {
        headline: "cargo could not be started, so your functions are not shown".into(),
        details: vec![
            format!("{}: {error}", command.get_program().display()),
            "Install Rust from https://rustup.rs, open a new terminal, and start the viewer with `cargo view`.".into(),
        ],
    })?;
    let (stderr, listener) = (child.stderr.take(), version.clone());
    let errors = thread::spawn(move || stderr.map(|stderr| pass_on(stderr, &listener)).unwrap_or_default());
    let built = child.stdout.take().map(|stdout| read_messages(package, stdout, version)).unwrap_or_default();
    if let Some((executable, rest)) = built.executable {
        // The program is there. What is left for cargo to do makes no difference to it.
        thread::spawn(move || {
            let _ = io::copy(&mut { rest }, &mut io::sink());
            let _ = child.wait();
        });
        return Ok(Program { executable, version: version.clone() });
    }
    let status = child.wait();
    let cargos_error = errors.join().unwrap_or_default();
    // Without a place it is none of the student's lines: a linker is missing, or room on the disk.
    let students = built.first_error.as_ref().is_some_and(|found| found.place.is_some());
    let headline = if students { "your code does not compile" } else { "your functions could not be built" };
    let found = built.first_error.unwrap_or(Found { words: cargos_error, ..Found::default() });
    let students_file = format!("src/{}:", package.file());
    let in_fixed = |place: &String| !place.replace('\\', "/").contains(&students_file);
    let fixed = found.place.as_ref().is_some_and(in_fixed);
    let mut details = found.lines();
    if fixed {
        details.push(fixed_words(package));
    }
    if details.is_empty() {
        let how = status.map_or_else(|error| error.to_string(), |status| status.to_string());
        details.push(format!("cargo ended without a word: {how}"));
    }
    details.push(IN_TERMINAL.into());
    Err(Trouble { headline: headline.into(), details })
}

/// What to do where the compiler points into a file that is not the student's.
fn fixed_words(package: Package) -> String {
    let file = package.file();
    format!(
        "Your file no longer fits the fixed ones: is {file} there, and are the first lines of its three functions as they were? \
         A fresh one is solutions/templates/{file}."
    )
}

/// Copies what cargo itself says to the terminal and gives its first error.
fn pass_on(stderr: impl Read, version: &Version) -> Vec<String> {
    let mut first_error = Vec::new();
    let mut lines = BufReader::new(stderr).split(b'\n');
    while let Some(Ok(mut line)) = lines.next() {
        line.push(b'\n');
        say(&line, version);
        let line = diagnostic::without_colors(&String::from_utf8_lossy(&line));
        if first_error.is_empty() && line.starts_with("error") {
            first_error.push(line.trim().to_owned());
        }
    }
    first_error
}

/// What cargo's messages say.
struct Built<R> {
    /// The program, and what cargo has not said yet.
    executable: Option<(PathBuf, R)>,
    first_error: Option<Found>,
}

impl<R> Default for Built<R> {
    fn default() -> Self {
        Built { executable: None, first_error: None }
    }
}

/// Reads cargo's messages until the program is there, or to their end, and copies the compiler's words to the terminal.
fn read_messages<R: Read>(package: Package, stdout: R, version: &Version) -> Built<BufReader<R>> {
    let worker = package.worker();
    let mut built = Built::default();
    let (mut source, mut line) = (BufReader::new(stdout), Vec::new());
    while source.read_until(b'\n', &mut line).is_ok_and(|count| count > 0) {
        let message = serde_json::from_slice(&line).unwrap_or(Value::Null);
        line.clear();
        if message["reason"] == "compiler-artifact"
            && message["target"]["name"] == worker.as_str()
            && let Some(executable) = message["executable"].as_str()
        {
            built.executable = Some((executable.into(), source));
            return built;
        }
        if message["reason"] == "compiler-message" {
            let diagnostic = &message["message"];
            say(diagnostic["rendered"].as_str().unwrap_or_default().as_bytes(), version);
            built.first_error = built.first_error.or_else(|| diagnostic::error(diagnostic));
        }
    }
    built
}

/// Writes to the terminal, with colours only where it has them, unless nobody is interested any more.
fn say(text: &[u8], version: &Version) {
    if !version.is_abandoned() {
        // The terminal may be gone; that must not keep the compiler from ending.
        let _ = anstream::stderr().write_all(text);
    }
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::time::Duration;

    use clap::ValueEnum;
    use exam::{Question, Subject};
    use skeleton::Skeleton;

    use super::*;

    /// The package `fk` by itself, without dependencies, in a folder with a blank in its name.
    fn package(worker: &str) -> tempfile::TempDir {
        package_of(Package::Fk, worker)
    }

    fn package_of(package: Package, worker: &str) -> tempfile::TempDir {
        let folder = tempfile::Builder::new().prefix("with blank ").tempdir().unwrap();
        let (name, program) = (package.name(), package.worker());
        let manifest = format!(
            "[package]\nname = \"{name}\"\nedition = \"2024\"\n[[bin]]\nname = \"{program}\"\npath = \"worker.rs\"\n[workspace]\n"
        );
        fs::write(folder.path().join("Cargo.toml"), manifest).unwrap();
        fs::write(folder.path().join("worker.rs"), worker).unwrap();
        folder
    }

    /// Compiles it in its own folder, whatever target folder the tests use.
    fn compile_alone(folder: &Path) -> Result<Program, Trouble> {
        compile_into(&folder.join("target"), Package::Fk, folder, &Version::default())
    }

    #[test]
    fn code_that_does_not_compile_is_told_with_its_first_error_its_place_and_its_line() {
        let folder = package("fn main() {\n    let x: u8 = \"text\";\n}\nfn other() -> u8 { 'c' }\n");
        let trouble = compile_alone(folder.path()).err().unwrap();
        assert_eq!(trouble.headline, "your code does not compile");
        assert_eq!(trouble.details[..2], ["error[E0308]: mismatched types", "worker.rs:2:17"]);
        let source = ["let x: u8 = \"text\";", "\"text\"  <- expected `u8`, found `&str`"];
        assert_eq!(trouble.details[2..4], source);
    }

    #[test]
    fn every_exercise_is_built_by_its_name_and_told_with_its_file() {
        for &exercise in Package::value_variants() {
            let students = "pub fn wrong() -> u8 { 'c' }\n";
            let module = exercise.file().replace(".rs", "");
            let folder = package_of(exercise, &format!("mod {module};\nfn main() {{}}\n"));
            let compile =
                || compile_into(&folder.path().join("target"), exercise, folder.path(), &Version::default());
            let file = exercise.file();
            let trouble = compile().err().unwrap();
            assert!(
                trouble.details.iter().any(|line| line.contains(&format!("is {file} there"))),
                "{trouble:?}"
            );
            fs::create_dir(folder.path().join("src")).unwrap();
            fs::write(folder.path().join("src").join(&file), students).unwrap();
            let path = format!("#[path = \"src/{file}\"]\nmod student;\nfn main() {{ student::wrong(); }}\n");
            fs::write(folder.path().join("worker.rs"), path).unwrap();
            let trouble = compile().err().unwrap();
            assert!(
                trouble.details[1].replace('\\', "/").ends_with(&format!("src/{file}:1:24")),
                "{trouble:?}"
            );
            assert!(!trouble.details.iter().any(|line| line.contains("fixed ones")), "{trouble:?}");
        }
    }

    #[test]
    fn code_that_compiles_becomes_a_program_that_is_asked() {
        let folder = package("fn main() { std::process::exit(7) }");
        let mut worker = compile_alone(folder.path()).ok().unwrap().worker();
        let question = exam::fk::Question::Poses { skeleton: Skeleton::new(), frames: Vec::new() };
        let failure = worker.ask(&Question::Fk(question), Duration::from_secs(60)).unwrap_err();
        assert!(failure.to_string().contains('7'), "{failure}");
    }

    #[test]
    fn a_folder_without_a_package_is_told() {
        let folder = tempfile::tempdir().unwrap();
        let trouble = compile_alone(folder.path()).err().unwrap();
        assert!(trouble.details[0].contains("Cargo.toml"), "{trouble:?}");
    }

    #[test]
    fn without_cargo_it_is_told_where_to_get_it() {
        let trouble = run(Package::Fk, Command::new("/no/such/cargo"), &Version::default()).err().unwrap();
        assert!(trouble.headline.contains("cargo could not be started"), "{trouble:?}");
        assert!(trouble.details[1].contains("rustup.rs"), "{trouble:?}");
    }

    #[test]
    fn without_a_linker_it_is_told_what_to_install() {
        let folder = package("fn main() {}");
        let mut command = cargo_build(Package::Fk, folder.path());
        command.env("CARGO_TARGET_DIR", folder.path().join("target"));
        command.env("RUSTFLAGS", "-Clinker=/no/such/linker");
        let trouble = run(Package::Fk, command, &Version::default()).err().unwrap();
        assert!(trouble.details[0].contains("linker"), "{trouble:?}");
        assert!(trouble.details[1].contains("build-essential"), "{trouble:?}");
    }
}
