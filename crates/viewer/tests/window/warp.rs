//! A motion and the same one warped, in one window.

use std::fs;

use viewer::draw::color_of;
use viewer::scene::Tint;

use super::display::{Display, wait_for};
use super::viewer::Viewer;

pub const TESTS: &[(&str, fn())] = &[
    ("keys_change_the_warp_and_bars_go_to_one_time", keys_change_the_warp_and_bars_go_to_one_time),
    ("a_warp_stays_when_the_file_is_saved_anew", a_warp_stays_when_the_file_is_saved_anew),
];

const DANCE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/dance.bvh");

fn wait_for_title(viewer: &Viewer, part: &str) {
    wait_for(part, || viewer.title().contains(part).then_some(()));
}

fn keys_change_the_warp_and_bars_go_to_one_time() {
    let display = Display::start();
    let viewer = Viewer::open(&display, &[DANCE, "--solution", "--warp", "282"]);
    wait_for_title(&viewer, "dance.bvh, 141 → 282 frames · frame 0 / 282");
    let green = color_of(Tint::Keyframe).channels();
    let posts = || display.picture().count(green);
    assert_eq!(posts(), 0);
    let before = display.picture();
    viewer.key("Up");
    wait_for_title(&viewer, "141 → 296 frames");
    let before = viewer.wait_for_change("the curve", &before, 0.0005);
    viewer.key("shift+Down");
    wait_for_title(&viewer, "141 → 295 frames");
    for _ in 0..4 {
        viewer.key("shift+Right");
    }
    viewer.wait_for_frame(40);
    viewer.key("bracketleft");
    wait_for_title(&viewer, "frames 40–140: 100 → 209");
    let before = viewer.wait_for_change("the figures", &before, 0.005);
    for _ in 0..4 {
        viewer.key("shift+Right");
    }
    viewer.wait_for_frame(80);
    viewer.key("bracketright");
    wait_for_title(&viewer, "frames 40–80: 40 → 84 · frame 80 / 185");
    viewer.wait_for_change("the stretch", &before, 0.005);
    // Two posts on each bar, and their feet in the plot.
    wait_for("posts on both bars", || (posts() > 4 * 12).then_some(()));
    let with_curve = display.picture();
    viewer.key("p");
    viewer.wait_for_change("no curve", &with_curve, 0.03);

    // The middle of the left bar, and the end of the right one.
    viewer.move_to(320, 693);
    viewer.mouse(&["mousedown", "1"]);
    viewer.wait_for_frame(70);
    viewer.mouse(&["mouseup", "1"]);
    // A key behind it tells that this was noticed: the next press is another one.
    viewer.key("w");
    viewer.wait_for_frame(71);
    viewer.move_to(1270, 693);
    viewer.mouse(&["mousedown", "1"]);
    viewer.wait_for_frame(184);
    viewer.mouse(&["mouseup", "1"]);
    viewer.key("comma");
    viewer.wait_for_frame(183);
    viewer.key("Home");
    viewer.wait_for_frame(0);
    viewer.key("space");
    wait_for("both to play", || (viewer.frame() > 10 && viewer.title().ends_with("playing")).then_some(()));
    viewer.key("space");
    wait_for("the pause", || (!viewer.title().ends_with("playing")).then_some(()));
    let printed = viewer.close();
    assert_eq!(printed.matches("frame time").count(), 1, "it is told once: {printed}");
}

fn a_warp_stays_when_the_file_is_saved_anew() {
    let folder = tempfile::Builder::new().prefix("with blank ").tempdir().unwrap();
    let path = folder.path().join("my dance.bvh");
    fs::copy(DANCE, &path).unwrap();
    let display = Display::start();
    let viewer = Viewer::open(&display, &[path.to_str().unwrap(), "--solution", "--warp", "1000000"]);
    wait_for_title(&viewer, "141 → 1000000 frames");
    viewer.key("Down");
    wait_for_title(&viewer, "141 → 999986 frames");
    let text = fs::read_to_string(&path).unwrap();
    let shorter = text.replace("Frames: 141", "Frames: 100");
    let kept = shorter.lines().count() - 41;
    let shorter: Vec<&str> = shorter.lines().take(kept).collect();
    fs::write(&path, shorter.join("\n") + "\n").unwrap();
    wait_for_title(&viewer, "100 → 999986 frames");
    viewer.forget_words();
    fs::write(&path, "nothing").unwrap();
    viewer.wait_for_words("my dance.bvh");
    fs::write(&path, &text).unwrap();
    wait_for_title(&viewer, "141 → 999986 frames");
    viewer.close();
}
