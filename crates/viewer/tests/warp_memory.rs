//! A motion that is warped to millions of frames takes no more memory than one that is warped to a thousand.
#![allow(clippy::unwrap_used)] // Helpers of tests.

use std::path::Path;
use std::sync::Arc;

use exam::InProcess;
use viewer::draw::canvas::Canvas;
use viewer::live::mover::Mover;
use viewer::live::student::Student;
use viewer::live::version::Version;
use viewer::live::worker::Trouble;
use viewer::motion::source::Source;
use viewer::motion::stage::Stage;
use viewer::motion::time_map::TimeMap;
use viewer::view::app::{App, Shown};
use viewer::view::gallery::Gallery;
use viewer::view::screen::Screen;
use viewer::window::keys::Action;

const SIZE: (usize, usize) = (640, 360);

/// The most bytes that are in use at once while a pair is shown and played, and while its warp is changed.
fn most_bytes(original: &Arc<Stage>, new: usize) -> u64 {
    let show = || {
        let warped = Arc::new(original.warped(TimeMap::Whole { old: original.moving_frames(), new }));
        let app = |stage: Arc<Stage>| App::new(stage, "dance.bvh".into(), Vec::new(), (320, 360));
        let mut gallery = Gallery::new(vec![app(original.clone()), app(warped)]);
        let mut screen = Screen::new(SIZE);
        gallery.act(Action::Play);
        for action in
            [Action::Play, Action::Last, Action::Keyframes(10), Action::Keyframes(-10), Action::First]
        {
            gallery.act(action);
            gallery.advance(0.5);
            screen.update(&mut gallery, |_| Shown::Reference, SIZE);
        }
        assert_eq!(screen.canvas().size(), Canvas::clamped(SIZE));
    };
    // Letters that are new are kept: once everything has been there, all is equal.
    show();
    allocation_counter::measure(show).bytes_max
}

#[test]
fn a_million_frames_take_no_more_memory_than_a_thousand() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/dance.bvh");
    let original = Source::new(path).read().unwrap().stage;
    let (few, many) = (most_bytes(&original, 1000), most_bytes(&original, 1_000_000));
    // A byte for each frame would be a megabyte.
    assert!(many < few + 100_000, "{few} bytes for a thousand frames, {many} for a million");
}

/// The most bytes that are in use at once while the motion that a student's functions are asked about is warped otherwise.
fn most_bytes_of_a_student(original: &Arc<Stage>, new: usize) -> u64 {
    let old = original.moving_frames();
    // Nobody answers.
    let open = |_: &Version| -> Result<InProcess, Trouble> {
        Err(Trouble { headline: "no".into(), details: Vec::new() })
    };
    let stages = vec![Arc::new(original.warped(TimeMap::Whole { old, new: 2 * old }))];
    let mut student = Student::start(Mover::TimeWarp, stages, open, |_| {});
    let warped = Arc::new(original.warped(TimeMap::Whole { old, new }));
    let show = || {
        student.replace_stage(0, warped);
        student.update(&[new - 1]);
        student.rebuild();
    };
    allocation_counter::measure(show).bytes_max
}

#[test]
fn what_is_asked_about_a_hundred_million_frames_takes_no_more_memory_than_about_a_thousand() {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data");
    let source = Source { skeleton: Some(data.join("walk.asf")), ..Source::new(data.join("walk.amc")) };
    let original = source.read().unwrap().stage;
    let [few, many] = [1000, 100_000_000].map(|new| most_bytes_of_a_student(&original, new));
    assert!(many < few + 100_000, "{few} bytes for a thousand frames, {many} for a hundred million");
}
