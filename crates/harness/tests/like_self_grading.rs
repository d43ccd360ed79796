//! What compiles and runs in `cargo test -p fk` does so in the harness, with the same points, and the other way round.
#![allow(clippy::unwrap_used)] // Helpers of tests.

#[path = "../../grading/tests/support/mod.rs"]
mod course;
mod support;

use std::fs;

use course::Course;
use serde_json::Value;
use support::{Harness, submissions};

/// Names, and sources in which a student uses more of the language than the template does.
fn sources() -> Vec<(&'static str, String)> {
    let right = submissions::SOLUTION;
    let with = |more: &str| format!("{right}\n{more}\n");
    let first = |inner: &str| format!("{inner}\n{right}");
    let call = |call: &str, more: &str| {
        let source = submissions::solution_with(
            "    match joint.parent {",
            &format!("    {call};\n    match joint.parent {{"),
        );
        format!("{source}\n{more}\n")
    };
    vec![
        ("crate_path", call("crate::fk::helper()", "pub fn helper() {}")),
        ("super_path", call("let _ = super::FUNCTIONS", "")),
        ("inner_attribute", first("#![allow(dead_code, unused_imports)]") + "\nfn unused() {}\n"),
        ("warnings_denied", first("#![deny(warnings)]") + "\npub fn nobody_calls_this() {}\n"),
        ("warnings_denied_and_one_there", first("#![deny(warnings)]") + "\nfn nobody_calls_this() {}\n"),
        (
            "nested_modules",
            call("inner::deeper::helper()", "mod inner { pub(super) mod deeper { pub(in crate::fk) fn helper() { use super::super::*; let _ = Vec3::ZERO; } } }"),
        ),
        ("macro", call("nothing!()", "").replace("pub fn local_quaternion", "#[macro_export]\nmacro_rules! nothing { () => { $crate::fk::nothing() } }\npub fn nothing() {}\npub fn local_quaternion")),
        ("own_main", with("pub fn main() {}")),
        ("own_test", with("#[cfg(test)]\nmod tests {\n    #[test]\n    fn one() {}\n}")),
        ("unsafe_block", call("unsafe { std::hint::unreachable_unchecked() }", "")),
        ("unsafe_allowed", first("#![allow(unsafe_code)]")),
        ("overflow", call("let _ = one() - 2", "#[inline(never)]\nfn one() -> u32 { std::hint::black_box(1) }")),
        ("debug_assertion", call("debug_assert!(joint.parent.is_none())", "")),
        ("environment", call("let _ = env!(\"CARGO_PKG_NAME\")", "")),
        ("fixed_crates", with("#[allow(unused_imports)]\nuse {exam::Question, glam::Mat3, skeleton::Skeleton};")),
        ("hidden_crate", with("extern crate serde;")),
        ("the_solutions", with("#[allow(unused_imports)]\nuse solutions::FK;")),
        ("crate_attributes", first("#![no_std]\n#![no_main]")),
        ("unknown_condition", first("#![deny(warnings)]") + "\n#[cfg(some_condition)]\npub fn a() {}\n"),
        ("generic_function", submissions::solution_with("joint: &Joint, local: Quat,", "joint: &Joint, local: impl Into<Quat>,").replace("pose[parent].rotation * local,", "pose[parent].rotation * local.into(),").replace("None => local,", "None => local.into(),")),
    ]
}

#[test]
fn both_ways_to_points_agree() {
    let some = ["super_path", "warnings_denied", "unsafe_allowed", "overflow", "generic_function"];
    agree(sources().into_iter().filter(|(name, _)| some.contains(name)).collect());
}

#[test]
#[ignore = "takes a minute: .ci/run does it"]
fn both_ways_to_points_agree_on_everything() {
    agree(sources());
}

fn agree(sources: Vec<(&str, String)>) {
    let folder = tempfile::tempdir().unwrap();
    let given = folder.path().join("given");
    fs::create_dir(&given).unwrap();
    for (name, source) in &sources {
        fs::write(given.join(format!("{name}.rs")), source).unwrap();
    }
    let out = folder.path().join("out");
    let output = Harness::grade(&given, &out).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let results: Value = serde_json::from_slice(&fs::read(out.join("results.json")).unwrap()).unwrap();

    let course = Course::open("a course with spaces");
    let mut differences = Vec::new();
    for (name, source) in sources {
        course.save(&source);
        let output = course.test_command().output().unwrap();
        let student = points_of_self_grading(&String::from_utf8_lossy(&output.stdout));
        let harness = points_of_harness(&results, name);
        println!("{name}: {student:?}");
        if student != harness {
            let errors = String::from_utf8_lossy(&output.stderr).into_owned();
            differences.push(format!("{name}: student {student:?}, harness {harness:?}\n{errors}"));
        }
    }
    course.save(submissions::TEMPLATE);
    assert!(differences.is_empty(), "{}", differences.join("\n"));
}

/// The points of each part; nothing when it does not compile.
fn points_of_self_grading(text: &str) -> Vec<u64> {
    let parts = text.lines().filter(|line| line.starts_with("  part"));
    let points = parts.filter_map(|line| {
        let words: Vec<&str> = line.split_whitespace().collect();
        words[words.iter().position(|word| *word == "of")? - 1].parse().ok()
    });
    points.collect()
}

fn points_of_harness(results: &Value, id: &str) -> Vec<u64> {
    let records = results["records"].as_array().unwrap();
    let record = records.iter().find(|record| record["id"] == id).unwrap();
    let verdict = &record["verdict"];
    match verdict["status"].as_str().unwrap() {
        "graded" => {
            let parts = verdict["parts"].as_array().unwrap();
            parts.iter().map(|part| part["points"].as_u64().unwrap()).collect()
        }
        "does-not-compile" => Vec::new(),
        other => panic!("{id}: {other}"),
    }
}
