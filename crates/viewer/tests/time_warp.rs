//! The exercise on time warping in pictures: in a copy of it, with the real compiler and the real worker.
#![allow(clippy::unwrap_used)] // Helpers of tests.

#[path = "../../grading/tests/support/mod.rs"]
mod support;

use std::fs::File;
use std::io::BufReader;
use std::path::Path;
use std::process::{Command, Output};

use support::Course;

const SOLUTION: &str = include_str!("../../../solutions/src/time_warp.rs");
const TEMPLATE: &str = include_str!("../../../solutions/templates/time_warp.rs");

/// The picture of one frame of the pair, without words, as the program writes it in the copy; and what it says of trouble.
fn picture(course: &Course, arguments: &[&str]) -> (Picture, String) {
    let file = course.folder.join("warped bones.png");
    let usual = ["--png", file.to_str().unwrap(), "--frame", "301", "--size", "480x240", "--camera", "40,10"];
    let output = view(course, &[&usual[..], &["--hide", "words,traces,goal"], arguments].concat());
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{said}");
    (Picture::read(&file), said)
}

/// The pixels of a picture.
struct Picture(Vec<u8>);

impl Picture {
    fn read(file: &Path) -> Picture {
        let mut reader = png::Decoder::new(BufReader::new(File::open(file).unwrap())).read_info().unwrap();
        let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut bytes).unwrap();
        Picture(bytes)
    }

    /// Whether the figures are the same. The two programs may round differently, which moves edges by less than a pixel.
    fn is_like(&self, other: &Picture) -> bool {
        assert_eq!(self.0.len(), other.0.len());
        let differs = |(a, b): &(&u8, &u8)| a.abs_diff(**b) > 24;
        1000 * self.0.iter().zip(&other.0).filter(differs).count() < 2 * self.0.len()
    }
}

/// The program, in the copy, on the walk and what the exercise's functions make of it.
fn view(course: &Course, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_view"))
        .env("CARGO_MANIFEST_DIR", course.folder.join("crates/viewer"))
        .env_remove("DISPLAY")
        .args(["--exercise", "time-warp"])
        .arg(format!("{}/data/walk.amc", support::WORKSPACE))
        .args(arguments)
        .output()
        .unwrap()
}

/// The solution with another line in place of one of its own.
fn with(line: &str, other: &str) -> String {
    support::with(SOLUTION, line, other)
}

#[test]
fn a_students_functions_make_the_warped_figure() {
    let course = Course::open("a course with spaces");
    course.save_exercise("time-warp", SOLUTION);
    let stretch = ["--between", "100,160", "--warp", "300"];
    let [whole, part] = [&[][..], &stretch].map(|how| {
        let right = picture(&course, &[how, &["--solution"]].concat()).0;
        let (own, said) = picture(&course, how);
        assert!(own.is_like(&right) && said.is_empty(), "{how:?}: {said}");
        right
    });
    assert!(!whole.is_like(&part));

    // Part 3 still gives the motion as it was: other places, and frames that are not there.
    course.save_exercise("time-warp", TEMPLATE);
    let (template, said) = picture(&course, &[]);
    assert!(!template.is_like(&whole) && said.is_empty(), "{said}");

    // In a stretch part 2 is at work, and no other.
    course.save_exercise(
        "time-warp",
        &with("[x, y, z].map(f32::to_degrees)", "[z, y, x].map(f32::to_degrees)"),
    );
    assert!(!picture(&course, &stretch).0.is_like(&part));
    let panics = with("let last =", "assert!(new_frame < 700, \"not today\");\n    let last =");
    course.save_exercise("time-warp", &panics);
    let (_, said) = picture(&course, &[]);
    assert!(said.contains("not today: the picture shows only the goal"), "{said}");
    assert!(said.contains("in part1, old_position"), "{said}");
    assert!(picture(&course, &stretch).0.is_like(&part), "there part 1 has no part in it");
}
