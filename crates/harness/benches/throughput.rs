//! How many submissions are marked, as ratios to `cargo test` for each and to the bare compiler, measured in one run.
//!
//! `cargo bench -p harness --bench throughput`
#![allow(clippy::unwrap_used)] // A benchmark.

#[path = "../tests/support/mod.rs"]
mod support;

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};
use std::{env, fs, thread};

use harness::kit::Kit;
use harness::toolchain::Toolchain;
use harness::workspace;
use nix::sys::resource::{UsageWho, getrusage};
use nix::sys::time::TimeValLike;
use support::{Harness, submissions};

const SUBMISSIONS: usize = 300;

/// How many of them are also tested by `cargo test`, in two copies of the workspace side by side.
const TESTED: usize = 20;

fn main() {
    let folder = tempfile::tempdir().unwrap();
    let given = folder.path().join("given");
    submissions::write(&given, SUBMISSIONS);
    // Builds the libraries, and warms the caches.
    let some = folder.path().join("some");
    submissions::write(&some, 6);
    let output = Harness::grade(&some, &folder.path().join("warm")).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));

    let (wall, cpu) = measured(|| {
        let output = Harness::grade(&given, &folder.path().join("out")).output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    });
    let (_, bare) = measured(|| bare_compiler(&given, folder.path()));
    let tested = cargo_tests();

    let each = |time: Duration| time.as_secs_f64() * 1000.0 / SUBMISSIONS as f64;
    println!("{SUBMISSIONS} submissions, 2 jobs");
    println!("harness: {:.1} ms each by the clock, {:.1} ms of processor time", each(wall), each(cpu));
    println!("rustc --emit=obj alone: {:.1} ms of processor time each", each(bare));
    let test_each = tested.as_secs_f64() * 1000.0 / TESTED as f64;
    println!("cargo test -p fk, warm, 2 at a time: {test_each:.1} ms each by the clock");
    println!("throughput, to cargo test:     {:.1} (aim: at least 10)", test_each / each(wall));
    println!(
        "processor time, to bare rustc: {:.2} (aim: at most 1.3)",
        cpu.as_secs_f64() / bare.as_secs_f64()
    );
    println!("endless loops, to their limits over the jobs: {:.2} (aim: at most 1)", loops(folder.path()));
}

/// How much longer a batch takes with endless loops in it, as a share of what their limits allow.
fn loops(folder: &Path) -> f64 {
    const LOOPING: usize = 6;
    /// Two seconds for the first check, half a second for the eleven others and the whole motion.
    const LIMIT: f64 = 2.0 + 12.0 * 0.5;
    let given = folder.join("some with loops");
    submissions::write(&given, 60);
    let mark = |out: &str| {
        let output = Harness::grade(&given, &folder.join(out)).output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    };
    let (without, _) = measured(|| mark("without loops"));
    let looping =
        submissions::solution_with("    match joint.parent {", "    loop {}\n    match joint.parent {");
    for number in 0..LOOPING {
        let source = format!("{looping}\nconst _: usize = {number};\n");
        fs::write(given.join(format!("looping{number}.rs")), source).unwrap();
    }
    let (with, _) = measured(|| mark("with loops"));
    (with.as_secs_f64() - without.as_secs_f64()) / (LOOPING as f64 * LIMIT / 2.0)
}

/// Time by the clock, and processor time of the processes that ended meanwhile.
fn measured(work: impl FnOnce()) -> (Duration, Duration) {
    let cpu = || {
        let usage = getrusage(UsageWho::RUSAGE_CHILDREN).unwrap();
        usage.user_time().num_microseconds() + usage.system_time().num_microseconds()
    };
    let (start, before) = (Instant::now(), cpu());
    work();
    (start.elapsed(), Duration::from_micros((cpu() - before) as u64))
}

/// Calls the compiler for the same sources, with nothing around it.
fn bare_compiler(given: &Path, folder: &Path) {
    let workspace = workspace::find().unwrap();
    let toolchain = Toolchain::find(&workspace).unwrap();
    let kit = Kit::build(&workspace, &toolchain).unwrap();
    let exercise = harness::exercise::Exercise::named("fk").unwrap();
    let crate_folder = folder.join("bare");
    fs::create_dir_all(&crate_folder).unwrap();
    fs::write(crate_folder.join("lib.rs"), exercise.worker()).unwrap();
    for entry in fs::read_dir(given).unwrap() {
        fs::copy(entry.unwrap().path(), crate_folder.join("fk.rs")).unwrap();
        let mut command = Command::new(&toolchain.rustc);
        command
            .args(["--edition", "2024", "--crate-name", "fk", "--crate-type", "bin", "--emit", "obj"])
            .args(["-Copt-level=0", "-Cdebuginfo=0", "-Ccodegen-units=1", "-Cembed-bitcode=no", "-Awarnings"])
            .arg("-L")
            .arg(format!("dependency={}", kit.dependencies.display()));
        for (name, file) in &kit.externs {
            command.arg("--extern").arg(format!("{name}={}", file.display()));
        }
        command.args(["-o", "fk.o", "lib.rs"]).current_dir(&crate_folder).env_clear();
        command.stdout(Stdio::null()).stderr(Stdio::null()).status().unwrap();
    }
}

/// Tests some of them as their authors would: save, `cargo test -p fk`.
fn cargo_tests() -> Duration {
    let courses: Vec<PathBuf> = (0..2).map(course).collect();
    for course in &courses {
        test(course, SUBMISSIONS);
    }
    let start = Instant::now();
    thread::scope(|scope| {
        for (index, course) in courses.iter().enumerate() {
            scope.spawn(move || {
                for number in (index..TESTED).step_by(2) {
                    test(course, number);
                }
            });
        }
    });
    start.elapsed()
}

fn test(course: &Path, number: usize) {
    fs::write(course.join("exercises/fk/src/fk.rs"), submissions::source(number)).unwrap();
    let mut command = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    for (name, _) in env::vars_os() {
        let name = name.to_string_lossy().into_owned();
        if name.starts_with("CARGO_") && name != "CARGO_HOME" {
            command.env_remove(name);
        }
    }
    command.args(["test", "--quiet", "--offline", "-p", "fk"]).current_dir(course);
    command.stdout(Stdio::null()).stderr(Stdio::null()).status().unwrap();
}

/// A copy of the workspace, kept from one measurement to the next.
fn course(number: usize) -> PathBuf {
    let workspace = workspace::find().unwrap();
    let course = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("course {number}"));
    for part in ["Cargo.toml", "Cargo.lock", ".cargo", "crates", "exercises", "solutions", "data"] {
        copy(&workspace.join(part), &course.join(part));
    }
    course
}

fn copy(from: &Path, to: &Path) {
    if from.is_dir() {
        for entry in fs::read_dir(from).unwrap() {
            let name = entry.unwrap().file_name();
            copy(&from.join(&name), &to.join(&name));
        }
    } else if fs::read(to).ok() != fs::read(from).ok() {
        fs::create_dir_all(to.parent().unwrap()).unwrap();
        fs::copy(from, to).unwrap();
    }
}
