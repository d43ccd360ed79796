//! `cargo test -p fk` as a student runs it, in a copy of the workspace in which the exercise is edited.
#![allow(clippy::unwrap_used)] // Helpers of tests.

mod support;

use std::process::Output;
use std::sync::{Mutex, PoisonError};

use grading::fk;
use solutions::template;

use support::Course;

const SOLUTION: &str = include_str!("../../../solutions/src/fk.rs");

#[test]
fn the_template_gets_nothing_and_is_told_not_started() {
    let run = grade(&template(), &[]);
    assert_eq!(run.points, [0, 1, 2].map(|part| marks(part, ALL, "not started")), "{}", run.text);
    assert!(!run.output.status.success());
    assert!(
        run.text.contains(&format!("Forward kinematics: 0 of {} points.", fk::RUBRIC.points())),
        "{}",
        run.text
    );
    assert!(!run.text.contains("warning"), "{}", run.text);
}

#[test]
fn the_solution_gets_everything() {
    let run = grade(SOLUTION, &[]);
    assert_eq!(run.points, [0, 1, 2].map(right), "{}", run.text);
    assert!(run.output.status.success(), "{}", run.text);
    assert!(
        run.text.contains(&format!("Forward kinematics: {0} of {0} points.", fk::RUBRIC.points())),
        "{}",
        run.text
    );
    assert!(run.text.contains("whole motion: right"), "{}", run.text);
}

#[test]
fn a_part_that_is_all_wrong_costs_its_five_points() {
    let source = solution_with("pose[parent].position + pose[parent].rotation * local_position", "Vec3::NAN")
        .replace("None => local_position", "None => Vec3::NAN");
    let run = grade(&source, &[]);
    assert_eq!(run.points, [right(0), right(1), marks(2, ALL, "wrong")], "{}", run.text);
    assert!(run.text.contains("> Hips") && run.text.contains("the first wrong joint"), "{}", run.text);
}

#[test]
fn a_misconception_is_named_and_the_first_wrong_joint_is_marked() {
    let source = solution_with("pose[parent].rotation * local,", "local * pose[parent].rotation,");
    let run = grade(&source, &[]);
    assert_eq!(
        run.points,
        [right(0), marks(1, &["child", "branch", "deep"], "partly right"), right(2)],
        "{}",
        run.text
    );
    assert!(run.text.contains("You multiply in the wrong order: local times parent."), "{}", run.text);
    assert!(run.text.contains(">   LeftUpLeg "), "{}", run.text);
}

#[test]
fn a_filter_asks_one_part() {
    let run = grade(SOLUTION, &["part2"]);
    assert_eq!(run.points, [right(1)], "{}", run.text);
    assert!(run.output.status.success(), "{}", run.text);
    assert!(run.text.contains("1 passed; 0 failed; 0 ignored; 0 measured; 3 filtered out"), "{}", run.text);
}

#[test]
fn a_panic_costs_the_checks_that_it_happens_in() {
    let source =
        solution_with("        return Quat::IDENTITY;\n", "        panic!(\"NONE is new to me\");\n");
    let run = grade(&source, &[]);
    assert_eq!(run.points, [marks(0, &["cursor"], "partly right"), right(1), right(2)], "{}", run.text);
    assert!(run.text.contains("exercises/fk/src/fk.rs:"), "{}", run.text);
    assert!(run.text.contains("NONE is new to me"), "{}", run.text);
}

#[test]
fn an_endless_loop_costs_the_check_that_it_happens_in() {
    let source = solution_with("        return Quat::IDENTITY;\n", "        loop {}\n");
    let run = grade(&source, &[]);
    assert_eq!(run.points, [marks(0, &["cursor"], "partly right"), right(1), right(2)], "{}", run.text);
    assert!(run.text.contains("did not finish within 10 seconds"), "{}", run.text);
}

#[test]
fn a_function_that_calls_itself_without_end_costs_its_part() {
    let source = solution_with(
        "Some(parent) => pose[parent].rotation * local,",
        "Some(_) => global_quaternion(joint, local, pose),",
    );
    let run = grade(&source, &[]);
    assert_eq!(
        run.points,
        [right(0), marks(1, &["child", "branch", "deep"], "partly right"), right(2)],
        "{}",
        run.text
    );
    assert!(run.text.contains("your code ended the program"), "{}", run.text);
}

#[test]
fn what_the_student_prints_reaches_the_terminal() {
    let source = solution_with(
        "    match joint.parent {",
        "    println!(\"I am {}\", joint.name);\n    match joint.parent {",
    );
    let run = grade(&source, &["part2"]);
    assert_eq!(run.points, [right(1)], "{}", run.text);
    assert!(run.text.contains("\nI am Hips\n"), "{}", run.text);
}

#[test]
fn a_filter_that_fits_nothing_says_what_there_is() {
    let run = grade(SOLUTION, &["part4"]);
    assert!(run.text.contains("There is part1_local_quaternion, part2_global_quaternion, "), "{}", run.text);
}

#[test]
fn colours_are_there_when_they_are_wanted_and_not_when_they_are_not() {
    let wanted = grade_with(&template(), &[], &[("CLICOLOR_FORCE", "1")]);
    assert!(wanted.text.contains("\x1b[2mnot started"), "{}", wanted.text);
    let unwanted = grade_with(&template(), &[], &[("CLICOLOR_FORCE", "0"), ("NO_COLOR", "1")]);
    assert!(!unwanted.text.contains('\x1b'), "{}", unwanted.text);
}

#[test]
fn no_colours_where_there_is_no_terminal() {
    let run = grade(&template(), &[]);
    assert!(!run.text.contains('\x1b'), "{}", run.text);
}

/// All checks of a part.
const ALL: &[&str] = &[];

/// What the summary says of a part (counted from 0) in which these checks are lost.
fn marks(part: usize, lost: &[&str], state: &str) -> String {
    let part = &fk::RUBRIC.parts[part];
    let kept = part.checks.iter().filter(|check| !lost.is_empty() && !lost.contains(&check.id));
    format!("{} of {}  {state}", kept.map(|check| check.points).sum::<u32>(), part.points())
}

fn right(part: usize) -> String {
    marks(part, &["none of them"], "right")
}

fn template() -> String {
    template::strip(SOLUTION).unwrap()
}

fn solution_with(right: &str, wrong: &str) -> String {
    assert!(SOLUTION.contains(right), "the solution no longer contains {right:?}");
    SOLUTION.replace(right, wrong)
}

struct Run {
    output: Output,
    text: String,
    /// What the summary says of each part.
    points: Vec<String>,
}

fn grade(source: &str, filter: &[&str]) -> Run {
    grade_with(source, filter, &[])
}

fn grade_with(source: &str, filter: &[&str], environment: &[(&str, &str)]) -> Run {
    // One test at a time edits the copy.
    static ALONE: Mutex<()> = Mutex::new(());
    let _alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
    let course = Course::open("a course with spaces");
    course.save(source);
    let output = course.test_command().args(filter).envs(environment.iter().copied()).output().unwrap();
    let text =
        String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr);
    let points = text.lines().filter(|line| line.starts_with("  part")).filter_map(|line| {
        let words: Vec<&str> = line.split_whitespace().collect();
        let of = words.iter().position(|word| *word == "of")?;
        Some(format!("{} of {}  {}", words[of - 1], words[of + 1], words[of + 2..].join(" ")))
    });
    let points = points.collect();
    Run { output, text, points }
}
