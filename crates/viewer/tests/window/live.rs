//! A student edits the file while the window is open.

use std::sync::PoisonError;

use viewer::draw::color_of;
use viewer::scene::{Off, Tint};

use super::TURN;
use super::display::{Display, wait_for};
use super::support::Course;
use super::viewer::Viewer;

pub const TESTS: &[(&str, fn())] = &[("saved_edits_change_the_picture_and_none_closes_the_window", edits)];

const SOLUTION: &str = include_str!("../../../../solutions/src/fk.rs");
const TEMPLATE: &str = include_str!("../../../../solutions/templates/fk.rs");

/// From the template to the solution, through all that can go wrong on the way.
fn edits() {
    let _turn = TURN.lock().unwrap_or_else(PoisonError::into_inner);
    let course = Course::open("a window with spaces");
    course.save(TEMPLATE);
    let display = Display::start();
    let motion = concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/running.bvh");
    let viewer = Viewer::open_in(&display, &course.folder, &[motion, "--frame", "40"]);
    viewer.wait_for_words("Forward kinematics: 0 of 15 points");
    let off = |picture: &super::display::Picture| picture.count(color_of(Tint::Off(Off::Much)).channels());
    let template = display.picture();
    assert_eq!(off(&template), 0, "nothing is wrong before it is begun");

    viewer.forget_words();
    course.save(&SOLUTION.replace("pose[parent].rotation * local_position", "local_position"));
    viewer.wait_for_words("You do not turn the local position.");
    viewer.wait_for_change("the figure", &template, 0.02);
    wait_for("joints that are off", || (off(&display.picture()) > 200).then_some(()));

    viewer.forget_words();
    course.save(SOLUTION);
    viewer.wait_for_words("Forward kinematics: 15 of 15 points");
    wait_for("all joints to be in their places", || (off(&display.picture()) == 0).then_some(()));

    viewer.forget_words();
    course.save(&SOLUTION.replace("None => local_position,", "None => panic!(\"not today\"),"));
    viewer.wait_for_words("not today");
    viewer.wait_for_words("in frame 40");
    viewer.key("w");
    viewer.wait_for_frame(41);

    viewer.forget_words();
    course.save(&SOLUTION.replace("None => local_position,", "None => local_position +,"));
    viewer.wait_for_words("your code does not compile");
    viewer.key("w");
    viewer.wait_for_frame(42);

    viewer.forget_words();
    let looping = "None => loop { std::hint::spin_loop() },";
    course.save(&SOLUTION.replace("None => local_position,", looping));
    viewer.wait_for_words("look for a loop that never ends");
    viewer.key("w");
    viewer.wait_for_frame(43);

    viewer.forget_words();
    course.save(&SOLUTION.replace("None => local_position,", "None => local_position * f32::NAN,"));
    viewer.wait_for_words("Forward kinematics: 14 of 15 points");
    viewer.key("w");
    viewer.wait_for_frame(44);

    viewer.forget_words();
    let printing = "None => { println!(\"here I am\"); local_position }";
    course.save(&SOLUTION.replace("None => local_position,", printing));
    viewer.wait_for_words("here I am");
    viewer.wait_for_words("15 of 15 points");
    viewer.close();
}
