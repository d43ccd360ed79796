//! The commands as a teaching assistant types them.
#![allow(clippy::unwrap_used)] // Helpers of tests.

mod support;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use serde_json::Value;
use support::{Harness, submissions};

/// A folder with blanks in its name, with some submissions in it.
struct Evening {
    folder: tempfile::TempDir,
}

impl Evening {
    fn new(count: usize) -> Evening {
        let folder = tempfile::Builder::new().prefix("an evening ").tempdir().unwrap();
        submissions::write(&folder.path().join("given"), count);
        Evening { folder }
    }

    fn given(&self) -> PathBuf {
        self.folder.path().join("given")
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn grade(&self, out: &str, more: &[&str]) -> Run {
        run(Harness::grade(&self.given(), &self.path(out)).args(more))
    }

    fn results(&self, out: &str) -> Value {
        serde_json::from_slice(&fs::read(self.path(out).join("results.json")).unwrap()).unwrap()
    }
}

struct Run {
    output: Output,
    text: String,
}

fn run(command: &mut Command) -> Run {
    let output = command.output().unwrap();
    let text =
        String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr);
    Run { output, text }
}

impl Run {
    fn succeeds(self) -> Run {
        assert!(self.output.status.success(), "{}", self.text);
        self
    }

    fn says(self, words: &str) -> Run {
        assert!(self.text.contains(words), "{words:?} is not in:\n{}", self.text);
        self
    }

    fn fails(self) -> Run {
        assert_eq!(self.output.status.code(), Some(1), "{}", self.text);
        self
    }
}

#[test]
fn a_folder_gives_marks_and_the_same_once_more() {
    let evening = Evening::new(6);
    evening.grade("one", &[]).succeeds().says("report.html");
    let mut alone = Harness::command();
    alone.arg("grade").arg(evening.given()).arg("--out").arg(evening.path("two"));
    run(alone.args(["--seed", "7", "--jobs", "1"])).succeeds();
    for file in ["results.json", "grades.csv", "report.html", "junit.xml"] {
        let read = |out| fs::read(evening.path(out).join(file)).unwrap();
        assert!(read("one") == read("two"), "{file} differs");
    }
    let grades = fs::read_to_string(evening.path("one").join("grades.csv")).unwrap();
    assert_eq!(grades.lines().count(), 7, "{grades}");
    let log = fs::read_to_string(evening.path("one").join("log.txt")).unwrap();
    assert!(log.contains("300000000_Student0: graded, 15 points"), "{log}");
}

#[test]
fn a_compile_error_reaches_the_feedback_with_the_line_of_the_students_file() {
    let evening = Evening::new(5);
    evening.grade("out", &["--only", "300000004_Student4"]).succeeds();
    let feedback = fs::read_to_string(evening.path("out/feedback/300000004_Student4.md")).unwrap();
    let line =
        submissions::source(4).lines().position(|line| line.contains("pose[parent] * local,")).unwrap();
    assert!(feedback.contains("cannot multiply"), "{feedback}");
    assert!(feedback.contains(&format!("exercises/fk/src/fk.rs:{}:", line + 1)), "{feedback}");
}

#[test]
fn feedback_does_not_tell_the_questions() {
    let evening = Evening::new(0);
    let source = submissions::solution_with(
        "        return Quat::IDENTITY;\n",
        "        panic!(\"LEAK {joint:?}\");\n",
    );
    fs::write(evening.given().join("300000000_A.rs"), source).unwrap();
    evening.grade("out", &[]).succeeds();
    for file in ["feedback/300000000_A.md", "feedback/300000000_A.html"] {
        let feedback = fs::read_to_string(evening.path("out").join(file)).unwrap();
        assert!(feedback.contains("your code panicked at exercises/fk/src/fk.rs:"), "{feedback}");
        for secret in ["LEAK", "rotation_order", "Vec3", evening.folder.path().to_str().unwrap(), "seed"] {
            assert!(!feedback.contains(secret), "{file} tells {secret}:\n{feedback}");
        }
    }
    assert!(evening.results("out").to_string().contains("LEAK"), "the teaching assistant is not told");
}

#[test]
fn a_run_is_not_overwritten_and_goes_on_when_asked_to() {
    let evening = Evening::new(3);
    evening.grade("out", &[]).succeeds();
    evening.grade("out", &[]).fails().says("--resume");
    evening.grade("out", &["--resume", "--run-wall", "3"]).fails().says("another set of limits");
    submissions::write(&evening.given(), 4);
    // What a killed run leaves where it wrote.
    let leftovers = ["out/.fk-lab-1.part", "out/feedback/.fk-lab-2.part"].map(|name| evening.path(name));
    leftovers.iter().for_each(|path| fs::write(path, "half").unwrap());
    fs::write(evening.given().join("300000000_Student0.rs"), submissions::TEMPLATE).unwrap();
    evening.grade("out", &["--resume"]).succeeds();
    assert!(leftovers.iter().all(|path| !path.exists()));
    let grades = fs::read_to_string(evening.path("out/grades.csv")).unwrap();
    assert_eq!(grades.lines().count(), 5, "{grades}");
    let log = fs::read_to_string(evening.path("out/log.txt")).unwrap();
    let times = |id: &str| log.lines().filter(|line| line.contains(&format!(" {id}: "))).count();
    assert_eq!([0, 1, 2, 3].map(|n| times(&format!("30000000{n}_Student{n}"))), [2, 1, 1, 1], "{log}");
}

#[cfg(unix)]
#[test]
fn ctrl_c_stops_cleanly_and_the_run_goes_on() {
    use nix::sys::signal::{Signal, kill};
    use nix::unistd::Pid;

    let evening = Evening::new(16);
    let out = evening.path("out");
    let mut command = Harness::grade(&evening.given(), &out);
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::null()).spawn().unwrap();
    // The first line is the head of the run.
    let lines = || fs::read_to_string(out.join("journal.jsonl")).unwrap_or_default().lines().count();
    while lines() < 3 {
        assert!(child.try_wait().unwrap().is_none(), "it ended before anything was marked");
        std::thread::yield_now();
    }
    kill(Pid::from_raw(child.id() as i32), Signal::SIGINT).unwrap();
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(130));
    let said = String::from_utf8(output.stdout).unwrap();
    assert!(said.contains("of 16 submissions are marked") && said.contains("--resume"), "{said}");
    assert!(!out.join("results.json").exists() && !out.join(".scratch").exists());

    evening.grade("out", &["--resume"]).succeeds();
    let grades = fs::read_to_string(out.join("grades.csv")).unwrap();
    assert_eq!(grades.lines().count(), 17, "{grades}");
}

#[test]
fn shares_put_together_are_the_whole() {
    let evening = Evening::new(7);
    evening.grade("whole", &[]).succeeds();
    for share in ["1/2", "2/2"] {
        evening.grade(&format!("share {}", &share[..1]), &["--shard", share]).succeeds();
    }
    let merge = |shares: &[&str], out: &str| {
        let mut command = Harness::command();
        command.arg("merge").args(shares.iter().map(|share| evening.path(share)));
        run(command.arg("--out").arg(evening.path(out)))
    };
    merge(&["share 1"], "merged").fails().says("missing: 2");
    merge(&["share 1", "share 1"], "merged").fails();
    merge(&["share 1", "whole"], "merged").fails();
    merge(&["share 2", "share 1"], "merged").succeeds();
    for file in ["results.json", "grades.csv", "report.html", "junit.xml"] {
        let read = |out| fs::read(evening.path(out).join(file)).unwrap();
        assert!(read("whole") == read("merged"), "{file} differs");
    }
}

#[test]
fn what_cannot_be_is_said_before_anything_is_marked() {
    let evening = Evening::new(1);
    evening.grade("out", &["--roster", "no such file.csv"]).fails().says("no such file.csv");
    evening.grade("out", &["--only", "nobody"]).fails().says("nobody");
    assert!(!evening.path("out/journal.jsonl").exists(), "a run was begun");
    run(&mut Harness::grade(Path::new("no such folder"), &evening.path("o"))).fails().says("no such folder");
    let usage = evening.grade("out", &["--shard", "3/2"]);
    assert_eq!(usage.output.status.code(), Some(2));
    usage.says("write 1/4 for the first of four shares");
}

#[test]
fn an_output_folder_that_cannot_be_written_is_said() {
    let evening = Evening::new(1);
    fs::write(evening.path("file"), "").unwrap();
    evening.grade("file/out", &[]).fails().says("cannot be written");
}

/// In a file system of its own, of 200 KiB.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_said_and_leaves_no_half_file() {
    let evening = Evening::new(6);
    let script = "mount -t tmpfs -o size=200k none \"$1\" || exit 99
        head -c 120000 /dev/zero > \"$1/filler\"
        \"$2\" grade \"$3\" --out \"$1/out\" --seed 7 2>&1; echo \"code $?\"; find \"$1/out\" | sort
        rm \"$1/filler\"; mount -o remount,size=100m \"$1\"
        \"$2\" grade \"$3\" --out \"$1/out\" --seed 7 --resume 2>&1; echo \"code $?\"; find \"$1/out\" | sort";
    let disk = evening.path("disk");
    fs::create_dir(&disk).unwrap();
    let mut command = Command::new("unshare");
    command.args(["--mount", "--map-root-user", "sh", "-c", script, "sh"]);
    command.arg(&disk).arg(env!("CARGO_BIN_EXE_harness")).arg(evening.given());
    let Ok(output) = command.output() else {
        eprintln!("NOT RUN: there is no `unshare`");
        return;
    };
    let text = String::from_utf8_lossy(&output.stdout);
    if output.status.code() == Some(99) || text.is_empty() {
        eprintln!("NOT RUN: no file system can be mounted here: {}", String::from_utf8_lossy(&output.stderr));
        return;
    }
    let (full, mended) = text.split_once("code 1\n").expect(&text);
    assert!(full.contains("No space left") || full.contains("cannot be written"), "{text}");
    let (left, mended) = mended.split_once("code 0\n").expect(&text);
    assert!(!left.contains(".part"), "{left}");
    assert!(mended.contains("report.html"), "{text}");
}

#[test]
fn a_submission_is_packed_and_checked() {
    let folder = tempfile::tempdir().unwrap();
    let submit = |number: &str| {
        let mut command = Harness::command();
        run(command.args(["submit", number, "Terry", "Fox", "--out"]).arg(folder.path()))
    };
    let packed = submit("300000001");
    let packed = packed.says("300000001_TerryFox.zip").says("Checking it as it will be marked");
    // The exercise as it is handed out has no points. What somebody has made of it since may have any, or not compile.
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let read = |file: &str| fs::read_to_string(workspace.join(file)).unwrap().replace("\r\n", "\n");
    if read("exercises/fk/src/fk.rs") == read("solutions/templates/fk.rs") {
        packed.succeeds().says("0 of 15 points");
    }
    assert!(folder.path().join("300000001_TerryFox.zip").exists());
    submit("me").fails().says("student number");

    // The archive of another exercise has the same name, and stays.
    let archive = folder.path().join("300000001_TerryFox.zip");
    let before = fs::read(&archive).unwrap();
    let mut other = Harness::command();
    other.args(["submit", "--exercise", "time-warp", "300000001", "Terry", "Fox", "--out"]);
    run(other.arg(folder.path())).fails().says("holds no time_warp.rs").says("--out DIR");
    assert_eq!(fs::read(&archive).unwrap(), before);
}

#[test]
fn gradescope_gets_an_archive_and_a_result() {
    let folder = tempfile::tempdir().unwrap();
    let archive = folder.path().join("autograder.zip");
    let mut bundle = Harness::command();
    run(bundle.args(["gradescope", "--seed", "7", "--out"]).arg(&archive)).succeeds();
    let bytes = fs::read(&archive).unwrap();
    let has = |name: &str| bytes.windows(name.len()).any(|window| window == name.as_bytes());
    for name in
        ["setup.sh", "run_autograder", "Cargo.lock", "crates/harness/src/main.rs", "solutions/src/fk.rs"]
    {
        assert!(has(name), "{name} is not in the archive");
    }

    let submission = folder.path().join("submission");
    fs::create_dir(&submission).unwrap();
    fs::write(submission.join("fk.rs"), submissions::source(2)).unwrap();
    let result = folder.path().join("results.json");
    let mut inside = Harness::command();
    inside.args(["gradescope", "--seed", "7", "--submission"]).arg(&submission).arg("--results").arg(&result);
    run(&mut inside).succeeds();
    let result: Value = serde_json::from_slice(&fs::read(&result).unwrap()).unwrap();
    assert_eq!(result["score"], 11, "{result}");
}

#[test]
fn results_without_names_hold_no_name() {
    let evening = Evening::new(3);
    evening.grade("out", &["--anonymous"]).succeeds().says("anonymous");
    let folder = evening.path("out/anonymous");
    let mut files = vec![folder.clone()];
    let mut checked = 0;
    while let Some(path) = files.pop() {
        if path.is_dir() {
            files.extend(fs::read_dir(path).unwrap().map(|entry| entry.unwrap().path()));
        } else if path != folder.join("key.csv") {
            let text = path.display().to_string() + &String::from_utf8_lossy(&fs::read(&path).unwrap());
            assert!(!text.contains("Student1") && !text.contains("300000001"), "{}", path.display());
            checked += 1;
        }
    }
    assert!(checked > 8, "{checked}");
    assert!(fs::read_to_string(folder.join("key.csv")).unwrap().contains("300000001"));
}

#[test]
fn sources_are_written_for_tools_that_look_for_copies() {
    let evening = Evening::new(2);
    evening.grade("out", &["--sources"]).succeeds();
    let source = fs::read_to_string(evening.path("out/sources/300000001_Student1/fk.rs")).unwrap();
    assert_eq!(source, submissions::source(1));
}

#[test]
fn the_doctor_says_what_there_is() {
    let mut command = Harness::command();
    run(command.arg("doctor")).says("Compiler   rustc").says("Sandbox");
}

/// The book and its examples name only commands and options that there are.
#[test]
fn what_the_book_says_to_type_exists() {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs");
    let examples = fs::read_dir(docs.join("examples")).unwrap().map(|entry| entry.unwrap().path());
    let pages = ["grading.md", "getting-started.md"].map(|page| docs.join(page));
    let mut checked = 0;
    for path in examples.chain(pages) {
        let text = fs::read_to_string(&path).unwrap().replace("\\\n", " ");
        for line in text.lines() {
            for (command, rest) in
                [("grade", "cargo grade "), ("submit", "cargo submit "), ("", "cargo harness ")]
                    .into_iter()
                    .filter_map(|(command, start)| Some((command, line.split_once(start)?.1)))
            {
                let first = rest.split_whitespace().next().unwrap();
                let command = if command.is_empty() { first } else { command };
                let help = run(Harness::command().args([command, "--help"])).succeeds().text;
                let is_option = |word: &&str| word.starts_with("--");
                for option in rest.split([' ', '`', '"', ')']).filter(is_option) {
                    assert!(help.contains(option), "{}: {command} knows no {option}", path.display());
                    checked += 1;
                }
            }
        }
    }
    assert!(checked > 15, "{checked}");
}
