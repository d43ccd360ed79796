//! A student edits the file of the exercise on time warping while the window is open.

use std::sync::PoisonError;

use viewer::draw::color_of;
use viewer::scene::{Off, Tint};

use super::TURN;
use super::display::{Display, Picture, wait_for};
use super::support::{self, Course};
use super::viewer::Viewer;

pub const TESTS: &[(&str, fn())] =
    &[("saved_functions_warp_the_motion_in_the_window_and_none_closes_it", edits)];

const SOLUTION: &str = include_str!("../../../../solutions/src/time_warp.rs");
const TEMPLATE: &str = include_str!("../../../../solutions/templates/time_warp.rs");

/// The solution with another line in place of one of its own.
fn with(line: &str, other: &str) -> String {
    support::with(SOLUTION, line, other)
}

/// From the template to the solution, and to what can go wrong on the way.
fn edits() {
    let _turn = TURN.lock().unwrap_or_else(PoisonError::into_inner);
    let course = Course::open("a window with spaces");
    let save = |source: &str| course.save_exercise("time-warp", source);
    save(TEMPLATE);
    let display = Display::start();
    let motion = concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/walk.amc");
    let viewer =
        Viewer::open_in(&display, &course.folder, &["--exercise", "time-warp", motion, "--frame", "301"]);
    viewer.wait_for_words("Time warping: 0 of 15 points");
    let off = |picture: &Picture| picture.count(color_of(Tint::Off(Off::Much)).channels());
    let template = display.picture();
    assert_eq!(off(&template), 0, "nothing is wrong before it is begun");

    viewer.forget_words();
    save(&with("[x, y, z].map(f32::to_degrees)", "[z, y, x].map(f32::to_degrees)"));
    viewer.wait_for_words("You mix up which angle is about which axis");
    viewer.wait_for_change("the mixed-up figure", &template, 0.01);
    wait_for("joints that are off", || (off(&display.picture()) > 100).then_some(()));

    viewer.forget_words();
    save(SOLUTION);
    viewer.wait_for_words("Time warping: 15 of 15 points");
    wait_for("all joints to be in their places", || (off(&display.picture()) == 0).then_some(()));
    // The functions are asked again for another number of frames.
    let right = display.picture();
    viewer.key("Up");
    wait_for("another warp", || viewer.title().contains("480 → 1008 frames").then_some(()));
    viewer.wait_for_change("the figure of another warp", &right, 0.002);
    wait_for("all joints to be in their places again", || (off(&display.picture()) == 0).then_some(()));

    viewer.forget_words();
    save(&with("let last =", "assert!(new_frame < 700, \"not today\");\n    let last ="));
    viewer.wait_for_words("not today");
    viewer.wait_for_words("in part1, old_position");

    viewer.forget_words();
    save(&with("(0..new_count).map(posture)", "(0..).map(posture)"));
    viewer.wait_for_words("in part3, warp");
    viewer.key("w");
    viewer.wait_for_frame(302);

    viewer.forget_words();
    save(SOLUTION);
    viewer.wait_for_words("15 of 15 points");
    viewer.close();
}
