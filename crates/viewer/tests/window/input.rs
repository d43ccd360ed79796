//! Keys and mouse reach the window, whatever happens to it.

use viewer::draw::color_of;
use viewer::scene::Tint;

use super::display::{Display, wait_for};
use super::viewer::Viewer;

pub const TESTS: &[(&str, fn())] = &[
    ("keys_step_play_and_close", keys_step_play_and_close),
    ("twenty_fast_taps_all_count", twenty_fast_taps_all_count),
    ("a_held_key_goes_on_and_stops", a_held_key_goes_on_and_stops),
    ("the_mouse_turns_moves_and_scrubs", the_mouse_turns_moves_and_scrubs),
    ("keys_edit_the_motion", keys_edit_the_motion),
    (
        "the_window_begins_with_keyframes_where_they_are_asked_for",
        the_window_begins_with_keyframes_where_they_are_asked_for,
    ),
    ("a_storm_of_sizes_is_survived", a_storm_of_sizes_is_survived),
];

fn keys_step_play_and_close() {
    let display = Display::start();
    let viewer = Viewer::open(&display, &["--solution"]);
    assert_eq!(viewer.frame(), 0);
    for (key, frame) in [
        ("w", 1),
        ("Right", 2),
        ("period", 3),
        ("comma", 2),
        ("Left", 1),
        ("shift+Right", 11),
        ("End", 1376),
        ("Home", 0),
    ] {
        viewer.key(key);
        viewer.wait_for_frame(frame);
    }
    viewer.key("space");
    wait_for("the motion to play", || {
        (viewer.frame() > 30 && viewer.title().ends_with("playing")).then_some(())
    });
    viewer.key("space");
    wait_for("the pause", || (!viewer.title().ends_with("playing")).then_some(()));
    let paused = viewer.frame();
    viewer.key("w");
    viewer.wait_for_frame(paused + 1);
    let printed = viewer.close();
    assert!(printed.contains("Hips") && printed.contains("frame time"), "the skeleton is printed: {printed}");
}

fn twenty_fast_taps_all_count() {
    let display = Display::start();
    let viewer = Viewer::open(&display, &["--solution"]);
    display.xdotool(&["key", "--delay", "1", "--repeat", "20", "w"]).unwrap();
    viewer.wait_for_frame(20);
    // Nothing comes later either: the next key is the next frame.
    viewer.key("w");
    viewer.wait_for_frame(21);
    viewer.close();
}

fn a_held_key_goes_on_and_stops() {
    let display = Display::start();
    let viewer = Viewer::open(&display, &["--solution"]);
    display.xdotool(&["keydown", "Right"]).unwrap();
    wait_for("repeats", || (viewer.frame() > 5).then_some(()));
    display.xdotool(&["keyup", "Right"]).unwrap();
    viewer.key("Home");
    viewer.wait_for_frame(0);
    viewer.key("w");
    viewer.wait_for_frame(1);
    viewer.close();
}

fn the_mouse_turns_moves_and_scrubs() {
    let display = Display::start();
    let viewer = Viewer::open(&display, &["--solution", "--hide", "words"]);
    for (button, what) in [("1", "the view to turn"), ("3", "the picture to move")] {
        viewer.move_to(600, 300);
        let before = display.picture();
        viewer.mouse(&["mousedown", button]);
        // In steps, as hands do it: a press and a move within one picture are one.
        for step in 1..=10 {
            viewer.move_to(600 + 12 * step, 300 + 6 * step);
        }
        viewer.wait_for_change(what, &before, 0.02);
        viewer.mouse(&["mouseup", button]);
    }
    let before = display.picture();
    viewer.mouse(&["click", "--repeat", "3", "4"]);
    viewer.wait_for_change("the picture to come closer", &before, 0.02);
    viewer.close();

    let viewer = Viewer::open(&display, &["--solution"]);
    viewer.move_to(640, 693);
    viewer.mouse(&["mousedown", "1"]);
    wait_for("the middle of the motion", || viewer.frame().checked_sub(600).filter(|over| *over < 180));
    viewer.move_to(1270, 300);
    wait_for("the end of the motion", || (viewer.frame() > 1300).then_some(()));
    viewer.mouse(&["mouseup", "1"]);
    viewer.close();
}

fn keys_edit_the_motion() {
    let display = Display::start();
    let motion = concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/dance.bvh");
    let viewer = Viewer::open(&display, &[motion, "--solution", "--frame", "93"]);
    let wait_for_title = |part: &str| wait_for(part, || viewer.title().contains(part).then_some(()));
    // The figure, the words and the bar change with each of these, and the arrows and the plot are there.
    let mut before = display.picture();
    for (key, title, share) in [
        ("i", "interpolated, Euler angles", 0.01),
        ("i", "interpolated, quaternions", 0.001),
        ("k", "20 keyframes, quaternions", 0.002),
        ("i", "20 keyframes, Euler angles", 0.0005),
        ("Up", "21 keyframes", 0.0002),
        ("shift+Down", "11 keyframes", 0.0002),
    ] {
        viewer.key(key);
        wait_for_title(title);
        before = viewer.wait_for_change(title, &before, share);
    }
    let magenta = color_of(Tint::Error).channels();
    // The legend has one already.
    viewer.key("e");
    wait_for("error vectors", || (display.picture().count(magenta) > 200).then_some(()));
    let before = display.picture();
    viewer.key("p");
    viewer.wait_for_change("the plot", &before, 0.04);
    let before = display.picture();
    viewer.key("b");
    viewer.wait_for_change("two figures beside each other", &before, 0.02);
    display.xdotool(&["keydown", "Up"]).unwrap();
    wait_title_count(&viewer, 30);
    display.xdotool(&["keyup", "Up"]).unwrap();
    viewer.key("k");
    wait_for("the stretch", || viewer.title().contains("interpolated, Euler").then_some(()));
    viewer.key("i");
    viewer.key("i");
    wait_for("the motion as it is", || viewer.title().ends_with("/ 141").then_some(()));
    viewer.close();
}

fn the_window_begins_with_keyframes_where_they_are_asked_for() {
    let display = Display::start();
    let motion = concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/dance.bvh");
    let arguments = [motion, "--solution", "--frame", "93", "--keyframes", "12", "--mode", "euler"];
    let viewer = Viewer::open(&display, &arguments);
    wait_for("the title", || viewer.title().ends_with("12 keyframes, Euler angles").then_some(()));
    let green = color_of(Tint::Keyframe).channels();
    wait_for("posts on the bar", || (display.picture().count(green) > 12 * 8).then_some(()));
    viewer.close();
}

/// Waits until there are so many keyframes, or more.
fn wait_title_count(viewer: &Viewer, least: usize) {
    wait_for("more keyframes", || {
        let title = viewer.title();
        let count =
            title.split(" · ").find_map(|part| part.split_once(" keyframes"))?.0.parse::<usize>().ok()?;
        (count >= least).then_some(())
    });
}

fn a_storm_of_sizes_is_survived() {
    let display = Display::start();
    let viewer = Viewer::open(&display, &["--solution"]);
    viewer.key("space");
    // Sizes from an inch to more than the screen, without waiting for any of them.
    let mut number = 12345u32;
    let mut side = |most: u32| {
        number = number.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        1 + (number >> 8) % most
    };
    for _ in 0..150 {
        let (width, height) = (side(1500), side(1000));
        viewer.resize(width as usize, height as usize);
    }
    viewer.window("windowunmap");
    viewer.window("windowmap");
    viewer.resize(1000, 600);
    display.xdotool(&["windowfocus", "--sync", &display.xdotool(&["search", "--name", "bvh"]).unwrap()]);
    viewer.key("Home");
    viewer.wait_for_frame(0);
    viewer.key("w");
    viewer.wait_for_frame(1);
    viewer.close();
}
