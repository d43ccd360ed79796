//! A student edits the file of another exercise while the window is open.

use std::sync::PoisonError;

use viewer::live::package::Package;

use super::TURN;
use super::display::Display;
use super::support::{self, Course};
use super::viewer::Viewer;

pub const TESTS: &[(&str, fn())] =
    &[("saved_functions_of_another_exercise_change_what_is_edited_and_none_closes_the_window", edits)];

const SOLUTION: &str = include_str!("../../../../solutions/src/interpolation.rs");
const TEMPLATE: &str = include_str!("../../../../solutions/templates/interpolation.rs");

/// From the template to the solution, through all that can go wrong on the way.
fn edits() {
    let _turn = TURN.lock().unwrap_or_else(PoisonError::into_inner);
    let course = Course::open("a window with spaces");
    let file = Package::Interpolation.sources(&course.folder).join(Package::Interpolation.file());
    let save = |source: &str| support::write(&file, source.as_bytes());
    // Part 3 begins like this.
    let begin = "let (mut angles_from, mut angles_to) =";
    assert!(SOLUTION.contains(begin), "the solution has changed");
    let with = |line: &str| SOLUTION.replace(begin, &format!("{line}\n    {begin}"));

    save(TEMPLATE);
    let display = Display::start();
    let motion = concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/dance.bvh");
    let arguments = ["--exercise", "interpolation", motion, "--frame", "70"];
    let viewer = Viewer::open_in(&display, &course.folder, &arguments);
    viewer.wait_for_words("Interpolation: 0 of 15 points");
    let template = display.picture();

    viewer.forget_words();
    save(SOLUTION);
    viewer.wait_for_words("Interpolation: 15 of 15 points");
    let right = viewer.wait_for_change("the figure", &template, 0.02);

    viewer.forget_words();
    save(&with("assert!(t < 0.25, \"not today\");"));
    viewer.wait_for_words("not today");
    viewer.wait_for_words("in frame 35, t = 0.250");
    viewer.wait_for_change("the pale figure", &right, 0.02);
    viewer.key("w");
    viewer.wait_for_frame(71);

    viewer.forget_words();
    save(&with("let wrong = ;"));
    viewer.wait_for_words("your code does not compile");
    viewer.key("w");
    viewer.wait_for_frame(72);

    viewer.forget_words();
    save(&with("while t > 0.25 { std::hint::spin_loop() }"));
    viewer.wait_for_words("look for a loop that never ends");
    viewer.key("w");
    viewer.wait_for_frame(73);

    viewer.forget_words();
    save(&with("if t > 0.25 { return LocalPose::default(); }"));
    viewer.wait_for_words("your interpolate_frame gives 0 rotations");
    viewer.key("w");
    viewer.wait_for_frame(74);

    viewer.forget_words();
    save(&with("if t == 0.5 { println!(\"here I am\"); }"));
    viewer.wait_for_words("here I am");
    viewer.wait_for_words("15 of 15 points");
    viewer.close();
}
