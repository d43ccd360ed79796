//! Compiling the student's functions into a program that can be asked.

use std::io::{self, BufRead, BufReader, IsTerminal, Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread;

use exam::WorkerProcess;
use serde_json::Value;

/// Why the student's functions cannot be shown, in words for the student.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Trouble {
    /// What happened, in one short line.
    pub headline: String,
    /// More about it, line by line.
    pub details: Vec<String>,
}

/// Compiles the package `fk` of the workspace that `folder` lies in and gives a worker that runs its functions.
///
/// What the compiler says goes to the terminal as it is. The program is found by cargo's own word, wherever its
/// target folder is.
///
/// # Errors
///
/// When cargo cannot be started or the package does not compile.
pub fn compile(folder: &Path) -> Result<WorkerProcess, Trouble> {
    run(cargo_build(folder))
}

fn cargo_build(folder: &Path) -> Command {
    let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    let color = if io::stderr().is_terminal() { "always" } else { "never" };
    command
        .args(["build", "--quiet", "--package", "fk", "--bin", "fk-worker", "--color", color])
        .arg("--message-format=json-render-diagnostics")
        .current_dir(folder)
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    command
}

fn run(mut command: Command) -> Result<WorkerProcess, Trouble> {
    let mut child = command.spawn().map_err(|error| Trouble {
        headline: "cargo could not be started, so your functions are not shown".into(),
        details: vec![format!("{}: {error}", command.get_program().display())],
    })?;
    let stderr = child.stderr.take();
    let errors = thread::spawn(move || stderr.map(pass_on).unwrap_or_default());
    let executable = child.stdout.take().and_then(find_executable);
    let status = child.wait();
    let first_error = errors.join().unwrap_or_default();

    match (status, executable) {
        (Ok(status), Some(executable)) if status.success() => {
            Ok(WorkerProcess::new(Command::new(executable)))
        }
        _ => {
            let details =
                first_error.into_iter().chain(["The compiler's own words are in the terminal.".into()]);
            Err(Trouble { headline: "your code does not compile".into(), details: details.collect() })
        }
    }
}

/// Copies the compiler's words to the terminal and gives those that say what is wrong first, and where.
fn pass_on(stderr: impl Read) -> Vec<String> {
    let mut first_error = Vec::new();
    let mut lines = BufReader::new(stderr).split(b'\n');
    while let Some(Ok(line)) = lines.next() {
        // The terminal may be gone; that must not keep the compiler from ending.
        let _ = io::stderr().write_all(&line).and_then(|()| io::stderr().write_all(b"\n"));
        let line = without_colors(&String::from_utf8_lossy(&line));
        let place = line.trim_start().starts_with("--> ");
        if (first_error.is_empty() && line.starts_with("error")) || (first_error.len() == 1 && place) {
            first_error.push(line.trim().trim_start_matches("--> ").to_owned());
        }
    }
    first_error
}

/// Reads cargo's messages to their end and gives the path of the program `fk-worker`.
fn find_executable(stdout: impl Read) -> Option<PathBuf> {
    let mut executable = None;
    let mut lines = BufReader::new(stdout).split(b'\n');
    while let Some(Ok(line)) = lines.next() {
        let Ok(message) = serde_json::from_slice::<Value>(&line) else { continue };
        if message["reason"] == "compiler-artifact" && message["target"]["name"] == "fk-worker" {
            executable = message["executable"].as_str().map(PathBuf::from).or(executable);
        }
    }
    executable
}

/// `line` without the escape sequences that set colours: ESC `[` … letter.
fn without_colors(line: &str) -> String {
    let mut parts = line.split("\u{1b}[");
    let mut plain = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let end = part.find(|c: char| c.is_ascii_alphabetic()).map_or(part.len(), |letter| letter + 1);
        plain.push_str(&part[end..]);
    }
    plain
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::time::Duration;

    use exam::{Question, Subject};
    use skeleton::Skeleton;

    use super::*;

    /// A package `fk` of its own, without dependencies, in a folder with a blank in its name.
    fn package(worker: &str) -> tempfile::TempDir {
        let folder = tempfile::Builder::new().prefix("with blank ").tempdir().unwrap();
        let manifest = "[package]\nname = \"fk\"\nedition = \"2024\"\n[[bin]]\nname = \"fk-worker\"\npath = \"worker.rs\"\n[workspace]\n";
        fs::write(folder.path().join("Cargo.toml"), manifest).unwrap();
        fs::write(folder.path().join("worker.rs"), worker).unwrap();
        folder
    }

    /// Compiles it in its own folder, whatever target folder the tests use.
    fn compile_alone(folder: &Path) -> Result<WorkerProcess, Trouble> {
        let mut command = cargo_build(folder);
        command.env("CARGO_TARGET_DIR", folder.join("target"));
        run(command)
    }

    #[test]
    fn code_that_does_not_compile_is_told_with_its_first_error_and_its_place() {
        let folder = package("fn main() {\n    let x: u8 = \"text\";\n}\n");
        let trouble = compile_alone(folder.path()).err().unwrap();
        assert_eq!(trouble.headline, "your code does not compile");
        assert_eq!(trouble.details[..2], ["error[E0308]: mismatched types", "worker.rs:2:17"]);
    }

    #[test]
    fn code_that_compiles_becomes_a_program_that_is_asked() {
        let folder = package("fn main() { std::process::exit(7) }");
        let mut worker = compile_alone(folder.path()).unwrap();
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
    fn colours_are_taken_out() {
        assert_eq!(without_colors("\u{1b}[0m\u{1b}[1m\u{1b}[38;5;9merror\u{1b}[0m: x"), "error: x");
        assert_eq!(without_colors("plain [m]"), "plain [m]");
        assert_eq!(without_colors("\u{1b}["), "");
    }
}
