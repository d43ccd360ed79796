//! `cargo test -p interpolation` as a student runs it, in a copy of the workspace in which the exercise is edited. What
//! all exercises have in common is tested with `fk`, in `self_grading.rs`.
#![allow(clippy::unwrap_used)] // Helpers of tests.

mod support;

use solutions::template;
use support::Course;

const SOLUTION: &str = include_str!("../../../solutions/src/interpolation.rs");

/// One after the other: both edit the same copy.
#[test]
fn the_template_gets_nothing_and_the_solution_everything() {
    let course = Course::open("a course with spaces");
    let (text, is_success) = grade(&course, &template::strip(SOLUTION).unwrap());
    assert!(!is_success && text.contains("\nInterpolation: 0 of 15 points."), "{text}");
    assert_eq!(text.matches("0 of 5  not started").count(), 3, "{text}");
    assert!(!text.contains("warning"), "{text}");

    let (text, is_success) = grade(&course, SOLUTION);
    assert!(is_success && text.contains("\nInterpolation: 15 of 15 points. Well done"), "{text}");
    assert!(text.contains("whole motion: right"), "{text}");
}

/// What `cargo test -p interpolation` says of this file, and whether it is content.
fn grade(course: &Course, source: &str) -> (String, bool) {
    course.save_exercise("interpolation", source);
    let output = course.test_exercise("interpolation").output().unwrap();
    let text = [&output.stdout, &output.stderr].map(|text| String::from_utf8_lossy(text).into_owned());
    (text.concat(), output.status.success())
}
