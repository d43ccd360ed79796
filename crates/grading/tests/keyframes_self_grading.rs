//! `cargo test -p keyframes` as a student runs it, in a copy of the workspace in which the exercise is edited.
#![allow(clippy::unwrap_used)] // Helpers of tests.

mod support;

use std::process::Output;

use support::{Course, cargo, write};

const SOLUTION: &str = include_str!("../../../solutions/src/keyframes.rs");

/// One after the other: both edit the same copy.
#[test]
fn the_template_is_not_started_and_the_solution_gets_everything() {
    let course = Course::open("a course with spaces");
    let template = solutions::template::strip(SOLUTION).unwrap();
    let (output, text) = grade(&course, &template);
    assert!(!output.status.success());
    for line in ["part1  pose error            0 of 5", "part2  removal cost          0 of 5"] {
        assert!(text.contains(&format!("  {line}  not started\n")), "{text}");
    }
    assert!(text.contains("  part3  reduction             0 of 5  not started\n"), "{text}");
    assert!(text.contains("\nKeyframes: 0 of 15 points.\n"), "{text}");
    assert!(!text.contains("warning"), "{text}");

    let (output, text) = grade(&course, SOLUTION);
    assert!(output.status.success(), "{text}");
    assert!(text.contains("whole motion: right"), "{text}");
    assert!(text.contains("\nKeyframes: 15 of 15 points. Well done: "), "{text}");
    assert!(!text.contains("warning"), "{text}");
}

/// Saves the student's file and types what a student types.
fn grade(course: &Course, source: &str) -> (Output, String) {
    write(&course.folder.join("exercises/keyframes/src/keyframes.rs"), source.as_bytes());
    let output = cargo(&course.folder).args(["test", "-p", "keyframes"]).output().unwrap();
    let text =
        String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr);
    (output, text)
}
