//! Motions of all kinds, and motions that change while they are shown.

use std::fs;
use std::path::Path;

use super::display::{Display, wait_for};
use super::viewer::Viewer;

pub const TESTS: &[(&str, fn())] = &[
    ("a_file_that_changes_is_read_again", a_file_that_changes_is_read_again),
    ("motions_without_much_in_them_are_shown", motions_without_much_in_them_are_shown),
    ("a_large_motion_plays", a_large_motion_plays),
    ("several_motions_share_the_window", several_motions_share_the_window),
];

/// A chain of `joints` joints in `frames` frames.
fn chain(joints: usize, frames: usize) -> String {
    let six = "Xposition Yposition Zposition Zrotation Xrotation Yrotation";
    let mut text = format!("HIERARCHY\nROOT r\n{{\nOFFSET 0 0 0\nCHANNELS 6 {six}\n");
    for joint in 1..joints {
        text += &format!("JOINT j{joint}\n{{\nOFFSET 0 1 0.1\nCHANNELS 3 Zrotation Xrotation Yrotation\n");
    }
    text += "End Site\n{\nOFFSET 0 1 0\n}\n";
    text += &"}\n".repeat(joints);
    text += &format!("MOTION\nFrames: {frames}\nFrame Time: 0.01\n");
    for frame in 0..frames {
        let angle = (frame % 90) as f32 / 30.0;
        text += &format!("{angle} {}\n", vec![format!("{angle:.2}"); 2 + 3 * joints].join(" "));
    }
    text
}

fn save(path: &Path, text: &str) {
    fs::write(path, text).unwrap();
}

fn a_file_that_changes_is_read_again() {
    let folder = tempfile::Builder::new().prefix("with blank ").tempdir().unwrap();
    let path = folder.path().join("my motion.bvh");
    save(&path, &chain(3, 20));
    let display = Display::start();
    let viewer = Viewer::open(&display, &[path.to_str().unwrap(), "--solution"]);
    viewer.key("End");
    viewer.wait_for_frame(19);
    save(&path, &chain(5, 8));
    wait_for("the shorter motion", || viewer.title().contains("frame 7 / 8").then_some(()));

    let before = display.picture();
    viewer.forget_words();
    save(&path, "HIERARCHY\nROOT r\n{\n  OFFSET 0 zero 0\n}\n");
    viewer.wait_for_words("my motion.bvh:4:12");
    viewer.wait_for_change("the message in the window", &before, 0.002);
    assert!(viewer.title().contains("frame 7 / 8"), "the last state that could be read stays");
    save(&path, &chain(5, 9));
    wait_for("the mended motion", || viewer.title().contains("frame 7 / 9").then_some(()));
    viewer.close();

    // One that cannot be read from the beginning.
    save(&path, "nothing");
    let viewer = Viewer::open(&display, &[path.to_str().unwrap(), "--solution"]);
    viewer.wait_for_words("my motion.bvh:1:1");
    save(&path, &chain(2, 4));
    wait_for("the mended motion", || viewer.title().contains("frame 0 / 4").then_some(()));
    viewer.close();
}

fn motions_without_much_in_them_are_shown() {
    let folder = tempfile::tempdir().unwrap();
    let display = Display::start();
    for (joints, frames) in [(2, 0), (1, 1), (2, 1)] {
        let path = folder.path().join(format!("{joints} {frames}.bvh"));
        save(&path, &chain(joints, frames));
        let viewer = Viewer::open(&display, &[path.to_str().unwrap(), "--solution"]);
        for key in [
            "space",
            "w",
            "Left",
            "r",
            "bracketleft",
            "bracketright",
            "Tab",
            "f",
            "l",
            "h",
            "i",
            "e",
            "p",
            "b",
            "k",
            "Up",
            "shift+Down",
            "End",
        ] {
            viewer.key(key);
        }
        assert!(viewer.title().contains(&format!("frame 0 / {frames}")));
        viewer.close();
    }
}

fn a_large_motion_plays() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("large.bvh");
    save(&path, &chain(173, 6000));
    let display = Display::start();
    let viewer = Viewer::open(&display, &[path.to_str().unwrap(), "--solution"]);
    viewer.key("space");
    wait_for("frames to pass", || (viewer.frame() > 100).then_some(()));
    viewer.key("End");
    viewer.wait_for_frame(5999);
    viewer.close();
}

fn several_motions_share_the_window() {
    let folder = tempfile::tempdir().unwrap();
    let (a, b) = (folder.path().join("a.bvh"), folder.path().join("b.bvh"));
    save(&a, &chain(3, 20));
    save(&b, &chain(4, 30));
    let display = Display::start();
    let viewer = Viewer::open(&display, &[a.to_str().unwrap(), b.to_str().unwrap(), "--solution"]);
    assert_eq!(viewer.title(), "a.bvh · b.bvh");
    viewer.key("w");
    for title in ["a.bvh · frame 1 / 20", "b.bvh · frame 1 / 30", "a.bvh · b.bvh"] {
        viewer.key("m");
        wait_for(title, || (viewer.title() == title).then_some(()));
    }
    viewer.close();
}
