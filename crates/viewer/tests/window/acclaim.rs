//! A student edits the file of the exercise on bones while the window is open.

use std::sync::PoisonError;

use viewer::draw::color_of;
use viewer::scene::{Off, Tint};

use super::TURN;
use super::display::{Display, Picture, wait_for};
use super::support::{self, Course};
use super::viewer::Viewer;

pub const TESTS: &[(&str, fn())] =
    &[("saved_functions_move_the_bones_in_the_window_and_none_closes_it", edits)];

const SOLUTION: &str = include_str!("../../../../solutions/src/acclaim.rs");
const TEMPLATE: &str = include_str!("../../../../solutions/templates/acclaim.rs");

/// The solution with another line in place of one of its own.
fn with(line: &str, other: &str) -> String {
    support::with(SOLUTION, line, other)
}

/// From the template to the solution, through all that can go wrong on the way.
fn edits() {
    let _turn = TURN.lock().unwrap_or_else(PoisonError::into_inner);
    let course = Course::open("a window with spaces");
    let save = |source: &str| course.save_exercise("acclaim", source);
    save(TEMPLATE);
    let display = Display::start();
    let motion = concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/walk.amc");
    let viewer = Viewer::open_in(
        &display,
        &course.folder,
        &["--exercise", "acclaim", motion, "--frame", "100", "--joint", "ltibia"],
    );
    viewer.wait_for_words("Acclaim forward kinematics: 0 of 15 points");
    let off = |picture: &Picture| picture.count(color_of(Tint::Off(Off::Much)).channels());
    let template = display.picture();
    assert_eq!(off(&template), 0, "nothing is wrong before it is begun");

    viewer.forget_words();
    save(&with(
        "Quat::from_rotation_z(z) * Quat::from_rotation_y(y) * Quat::from_rotation_x(x)",
        "Quat::IDENTITY",
    ));
    viewer.wait_for_words("part1  bone rotation");
    viewer.wait_for_change("the stiff figure", &template, 0.01);
    wait_for("joints that are off", || (off(&display.picture()) > 200).then_some(()));

    viewer.forget_words();
    save(SOLUTION);
    viewer.wait_for_words("Acclaim forward kinematics: 15 of 15 points");
    wait_for("all joints to be in their places", || (off(&display.picture()) == 0).then_some(()));

    viewer.forget_words();
    let turn = "let [x, y, z] = angles";
    save(&with(turn, &format!("assert!(bone.name != \"rtibia\", \"not today\");\n    {turn}")));
    viewer.wait_for_words("not today");
    viewer.wait_for_words("at bone rtibia, in frame 100");
    viewer.key("w");
    viewer.wait_for_frame(101);

    viewer.forget_words();
    save(&with("next = child.sibling;", "next = child.sibling +;"));
    viewer.wait_for_words("your code does not compile");
    viewer.key("w");
    viewer.wait_for_frame(102);

    viewer.forget_words();
    save(&with("visit_bones(skeleton, child, visitor);", "visit_bones(skeleton, bone, visitor);"));
    viewer.wait_for_words("a function that calls itself without end");
    viewer.key("Tab");
    viewer.key("w");
    viewer.wait_for_frame(103);

    viewer.forget_words();
    save(&with("next = child.sibling;", "next = Some(id);"));
    viewer.wait_for_words("look for a loop that never ends");
    viewer.wait_for_words("in part3, visit_bones");

    viewer.forget_words();
    let next = "let mut next = bone.child;";
    save(&with(next, &format!("if bone.is_root() {{ println!(\"here I am\"); }}\n    {next}")));
    viewer.wait_for_words("here I am");
    viewer.wait_for_words("15 of 15 points");
    viewer.close();
}
