//! An evening of marking: innocent and hostile submissions in one folder, one run, and a look at everything around it.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use std::time::{Duration, Instant};

use libtest_mimic::Failed;
use serde_json::Value;

use crate::broken::broken;
use crate::corpus::{attacks, fill, solution};
use crate::expected::{Expected, brief, points};
use crate::hard_coded;
use crate::modes::Mode;
use crate::planted::{Planted, WORD, files};
use crate::undertaker::LEFT;

#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Size {
    Few,
    All,
}

const JOBS: u32 = 2;
/// Seconds for a check, and for the compiler.
const RUN_WALL: u32 = 3;
const COMPILE_CPU: u32 = 5;
const COMPILE_WALL: u32 = 20;

/// Nobody knows this seed.
const SEED: &str = "20260131";

/// What is left of answers that are known by heart: a point for taking the angles from the frame.
const BY_HEART: &str = "graded 1; part1 partly-right; part2 not-started; part3 not-started";

/// The file that others try to steal.
const NEIGHBOUR: &str = "300000000_Innocent.rs";

/// One submission of the evening.
struct Handed {
    /// Its name in the folder.
    file: String,
    name: String,
    expect: Expected,
}

/// Runs the hostile ones among the innocent ones, protected.
pub fn attacked(mode: Mode, size: Size) -> Result<(), Failed> {
    if let Some(why) = mode.missing() {
        println!("NOT RUN: {why}");
        return Ok(());
    }
    let before = Planted::new();
    let innocent = innocents(&before.given());
    mode.prepare(before.path());
    let start = Instant::now();
    let alone = grade(mode, &before, &[])?;
    let alone = Alone { points: points_of(&alone, &innocent), time: start.elapsed() };

    let planted = Planted::new();
    let innocent = innocents(&planted.given());
    let handed = hostile(&planted, mode, size);
    mode.prepare(planted.path());
    let snapshot = planted.snapshot();
    let start = Instant::now();
    let records = grade(mode, &planted, &[])?;
    let time = start.elapsed();

    let mut wrong = Wrong::default();
    verdicts(&records, &handed, &mut wrong);
    let given = fs::read_dir(planted.given()).unwrap().count();
    wrong.check(records.len() == given, || format!("{given} submissions in, {} results out", records.len()));
    let now = points_of(&records, &innocent);
    wrong.check(now == alone.points, || format!("innocent points: {now:?} instead of {:?}", alone.points));
    let after = planted.snapshot();
    let changed = |path: &&std::path::PathBuf| snapshot.get(*path) != after.get(*path);
    let all: BTreeSet<&std::path::PathBuf> = snapshot.keys().chain(after.keys()).collect();
    for path in all.into_iter().filter(changed) {
        let (then, now) = (snapshot.get(path), after.get(path));
        wrong.say(format!("{} was changed: {then:?}, now {now:?}", path.display()));
    }
    for path in planted.left_behind() {
        wrong.say(format!("left behind: {}", path.display()));
    }
    for service in planted.called() {
        wrong.say(format!("the {service} service was called"));
    }
    nothing_leaks(&planted.out(), &mut wrong);
    sandbox(&planted.out(), mode, &mut wrong);
    let count = u32::try_from(records.len()).unwrap();
    let bound = alone.time / innocent.len() as u32 * count * 4 + limits(&handed);
    wrong.check(time <= bound, || format!("it took {time:?}, more than the limits allow: {bound:?}"));
    println!("{} submissions in {time:.1?}", records.len());
    wrong.result()
}

struct Alone {
    points: BTreeMap<String, Option<u64>>,
    time: Duration,
}

/// The longest that those may take together that run into a limit, spread over the jobs.
fn limits(handed: &[Handed]) -> Duration {
    let slow = handed.iter().filter(|handed| handed.expect.runs_out_of_time()).count() as u32;
    // A check at its limit, twelve more and the whole motion at a tenth of it; or the compiler at its limit.
    let each = Duration::from_secs(u64::from(COMPILE_WALL.max(RUN_WALL * 3)));
    each * slow / JOBS
}

/// Runs those attacks without a sandbox that harm nothing but what was planted. Each must succeed: what cannot, proves nothing.
pub fn unprotected(size: Size) -> Result<(), Failed> {
    let planted = Planted::new();
    innocents(&planted.given());
    let names = planted.names(NEIGHBOUR);
    let mut handed = Vec::new();
    let attacks = attacks().into_iter().filter(|attack| size == Size::All || attack.quick);
    for (number, attack) in (300_001_000..).zip(attacks) {
        let Some(expect) = attack.unprotected.clone() else { continue };
        let file = write(&planted.given(), number, &attack.name, &attack.source(&names));
        let expect = expect.map_words(|words| fill(words, &names));
        handed.push(Handed { file, name: attack.name, expect });
    }
    let records = grade(Mode::PLAIN, &planted, &["--unsandboxed"])?;
    let mut wrong = Wrong::default();
    verdicts(&records, &handed, &mut wrong);
    let called: BTreeSet<&str> = planted.called().into_iter().collect();
    wrong.check(called.contains("tcp"), || "the listener was not reached".to_owned());
    if size == Size::All {
        let all = ["abstract", "tcp", "udp", "unix"].into();
        wrong.check(called == all, || format!("only these services were reached: {called:?}"));
    }
    for path in planted.left_behind() {
        let _ = fs::remove_file(path);
    }
    println!("{} attacks without a sandbox", handed.len());
    wrong.result()
}

/// Answers that are known by heart help with the seed that is known, and with no other.
pub fn answers_by_heart() -> Result<(), Failed> {
    let mut wrong = Wrong::default();
    for (seed, expect) in [(grading::PUBLIC_SEED.to_string(), "graded 15"), (SEED.to_owned(), BY_HEART)] {
        let planted = Planted::new();
        let file = write(&planted.given(), 300_000_001, "by_heart", &hard_coded::source());
        let records = grade(Mode::PLAIN, &planted, &["--seed", &seed])?;
        let handed =
            Handed { file, name: format!("by heart, seed {seed}"), expect: Expected::parse(expect)? };
        verdicts(&records, &[handed], &mut wrong);
    }
    wrong.result()
}

/// Those that nobody else may harm. Gives their files.
fn innocents(given: &Path) -> Vec<String> {
    let solution = solution();
    let change = |right: &str, wrong: &str| {
        assert!(solution.contains(right), "the solution no longer contains {right:?}");
        solution.replace(right, wrong)
    };
    let sources = [
        solution.clone(),
        change("pose[parent].rotation * local,", "local * pose[parent].rotation,"),
        change(
            "turn(first, a) * turn(second, b) * turn(third, c)",
            "turn(third, c) * turn(second, b) * turn(first, a)",
        ),
        change(
            "pose[parent].position + pose[parent].rotation * local_position",
            "pose[parent].position + local_position",
        ),
        change("degrees.to_radians()", "degrees * 3.14 / 180.0"),
        change(
            "        return Quat::IDENTITY;\n",
            "        println!(\"{}\", joint.name);\n        return Quat::IDENTITY;\n",
        ),
        change(
            "Some(parent) => pose[parent].rotation * local,",
            "Some(parent) => pose[parent].rotation * locl,",
        ),
    ];
    // Among the others, from the first to the last.
    let each = sources.iter().enumerate().map(|(number, source)| {
        let file = if number == 0 { NEIGHBOUR.to_owned() } else { format!("30000{number}500_Innocent.rs") };
        fs::write(given.join(&file), format!("{source}\npub const NUMBER: u32 = {number};\n")).unwrap();
        file
    });
    each.collect()
}

fn hostile(planted: &Planted, mode: Mode, size: Size) -> Vec<Handed> {
    let given = planted.given();
    let names = planted.names(NEIGHBOUR);
    let mut handed = Vec::new();
    let wanted = |quick| size == Size::All || quick;
    let is_known = |name: &str| cfg!(target_arch = "x86_64") || !name.starts_with("raw/");
    if !cfg!(target_arch = "x86_64") {
        println!("NOT RUN: the system calls of tests/hostile/raw are those of x86-64");
    }
    let numbers = (300_000_001..).step_by(25);
    let attacks = attacks().into_iter().filter(|attack| wanted(attack.quick) && is_known(&attack.name));
    for (number, attack) in numbers.zip(attacks) {
        let expect = match &attack.without_namespaces {
            Some(other) if !mode.namespaces => other.clone(),
            _ => attack.expect.clone(),
        };
        let file = write(&given, number, &attack.name, &attack.source(&names));
        handed.push(Handed {
            file,
            expect: expect.map_words(|words| fill(words, &names)),
            name: attack.name,
        });
    }
    let numbers = (300_000_003..).step_by(50);
    for (number, broken) in numbers.zip(broken().into_iter().filter(|broken| wanted(broken.quick))) {
        broken.write(&given, number, &names);
        let file = broken.file_name(number);
        handed.push(Handed { file, name: broken.text.to_owned(), expect: broken.expect.clone() });
    }
    let file = write(&given, 300_000_002, "by_heart", &hard_coded::source());
    handed.push(Handed {
        file,
        name: "answers by heart".to_owned(),
        expect: Expected::parse(BY_HEART).unwrap(),
    });
    handed
}

fn write(given: &Path, number: u32, name: &str, source: &str) -> String {
    let name = name.rsplit('/').next().unwrap();
    let file = format!("{number}_{name}.rs");
    // No two are the same file.
    fs::write(given.join(&file), format!("{source}\npub const NUMBER: u32 = {number};\n")).unwrap();
    file
}

fn grade(mode: Mode, planted: &Planted, more: &[&str]) -> Result<Vec<Value>, Failed> {
    let mut command = mode.harness(planted.path());
    command.arg("grade").arg(planted.given()).arg("--out").arg(planted.out());
    if !more.contains(&"--seed") {
        command.args(["--seed", SEED]);
    }
    let flag = |command: &mut Command, name: &str, value: u32| {
        command.arg(name).arg(value.to_string());
    };
    flag(&mut command, "--jobs", JOBS);
    flag(&mut command, "--run-wall", RUN_WALL);
    flag(&mut command, "--compile-cpu", COMPILE_CPU);
    flag(&mut command, "--compile-wall", COMPILE_WALL);
    let Output { status, stdout, stderr } = command.args(more).env("FK_LAB_PLANTED", WORD).output()?;
    let text = String::from_utf8_lossy(&stdout).into_owned() + &String::from_utf8_lossy(&stderr);
    let results =
        fs::read(planted.out().join("results.json")).map_err(|error| format!("{error}, {status}: {text}"))?;
    if let Some(left) = text.lines().find(|line| line.starts_with(LEFT)) {
        return Err(left.into());
    }
    if !status.success() {
        println!("{status}: {text}");
    }
    let results: Value = serde_json::from_slice(&results)?;
    Ok(results["records"].as_array().ok_or("no records")?.clone())
}

/// The record of a submission, by the name of its file.
fn record<'a>(records: &'a [Value], file: &str) -> Option<&'a Value> {
    let shown = submissions::printable(file);
    records.iter().find(|record| record["file"] == shown)
}

fn points_of(records: &[Value], files: &[String]) -> BTreeMap<String, Option<u64>> {
    files.iter().map(|file| (file.clone(), record(records, file).and_then(points))).collect()
}

fn verdicts(records: &[Value], handed: &[Handed], wrong: &mut Wrong) {
    for Handed { file, name, expect } in handed {
        match record(records, file) {
            None => wrong.say(format!("{name}: no result ({file})")),
            Some(record) if expect.is_met_by(record) => {}
            Some(record) => wrong.say(format!("{name}: expected {}; got {}", expect.text(), brief(record))),
        }
    }
}

/// No file that comes out holds the secret, commands for a terminal, or a student's script.
fn nothing_leaks(out: &Path, wrong: &mut Wrong) {
    for file in files(out) {
        let bytes = fs::read(&file).unwrap_or_default();
        let text = String::from_utf8_lossy(&bytes);
        let is_page = file.extension().is_some_and(|extension| extension == "html");
        let forbidden =
            [("the secret", WORD), ("a command for a terminal", "\u{1b}"), ("turned text", "\u{202e}")];
        let scripts =
            [("a student's script", "<script>document.title"), ("a student's script", "<img src=x")];
        for (what, words) in forbidden.into_iter().chain(scripts.into_iter().filter(|_| is_page)) {
            wrong.check(!text.contains(words), || format!("{what} is in {}", file.display()));
        }
    }
}

/// The mode was the one that was asked for, and stands in the results.
fn sandbox(out: &Path, mode: Mode, wrong: &mut Wrong) {
    let results: Value = serde_json::from_slice(&fs::read(out.join("results.json")).unwrap()).unwrap();
    let layers = results["run"]["sandbox"].as_str().unwrap_or_default().to_owned();
    println!("sandbox: {layers}");
    let has = |layer: &str| layers.split(", ").any(|found| found == layer);
    if !mode.namespaces {
        wrong.check(!has("namespaces"), || format!("namespaces were not refused: {layers}"));
    } else if !has("namespaces") {
        println!("NOT RUN with namespaces: this machine gives out none");
    }
    wrong.check(results["run"]["sandboxed"] == true, || "not sandboxed".to_owned());
    wrong.check(!mode.as_user || !has("own user"), || format!("not an ordinary user: {layers}"));
}

/// Everything that is wrong, not just the first.
#[derive(Default)]
struct Wrong(Vec<String>);

impl Wrong {
    fn say(&mut self, what: String) {
        self.0.push(what);
    }

    fn check(&mut self, is_right: bool, what: impl Fn() -> String) {
        if !is_right {
            self.say(what());
        }
    }

    fn result(self) -> Result<(), Failed> {
        if self.0.is_empty() {
            Ok(())
        } else {
            Err(format!("{} things are wrong:\n{}", self.0.len(), self.0.join("\n")).into())
        }
    }
}
