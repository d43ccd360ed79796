//! From a saved edit to the new picture, as a ratio to `cargo build` for the same edit.
//!
//! `cargo bench -p viewer --bench save_to_picture`
#![allow(clippy::unwrap_used)]

#[path = "../../grading/tests/support/mod.rs"]
mod support;

use std::process::{Command, Stdio};
use std::sync::Arc;
use std::thread;
use std::time::{Duration, Instant};

use skeleton::PositionChannels;
use support::{Course, cargo};
use viewer::draw::Painter;
use viewer::draw::canvas::Canvas;
use viewer::live::Live;
use viewer::live::mover::Mover;
use viewer::live::package::Package;
use viewer::live::student::Status;
use viewer::live::worker;
use viewer::motion::stage::Stage;
use viewer::view::app::{App, Shown};

const ROUNDS: usize = 15;
const SIZE: (usize, usize) = (1280, 720);
const FRAME: usize = 300;
const TARGET: f64 = 1.3;

/// The pause between two pictures: the window makes 60 per second.
const PICTURE: Duration = Duration::from_micros(16_667);

fn main() {
    let course = Course::open("bench save to picture");
    let motion = parser::bvh::read_file(format!("{}/data/running.bvh", support::WORKSPACE)).unwrap().motion;
    let stage = Arc::new(Stage::new(motion, PositionChannels::Replace));
    course.save(&edit(0));
    build(&course);

    // The first round warms up.
    let (mut builds, mut pictures) = (Vec::new(), Vec::new());
    for round in 0..=ROUNDS {
        let start = Instant::now();
        course.save(&edit(2 * round + 1));
        build(&course);
        let built = start.elapsed();
        let shown = picture(&course, &stage, 2 * round + 2);
        if round > 0 {
            builds.push(built);
            pictures.push(shown);
        }
    }
    let (built, shown) = (median(builds), median(pictures));
    let ratio = shown.as_secs_f64() / built.as_secs_f64();
    println!("saved edit to the end of cargo build: {} ms (median of {ROUNDS})", built.as_millis());
    println!("saved edit to the new picture: {} ms", shown.as_millis());
    println!("ratio: {ratio:.2} (target: at most {TARGET})");
    assert!(ratio <= TARGET, "the new picture comes too late");
}

/// The solution, with everything moved along X by a constant that is another one for every edit.
fn edit(number: usize) -> String {
    let solution = include_str!("../../../solutions/src/fk.rs");
    let moved = solution
        .replace("None => local_position,", &format!("None => local_position + {number}.0 * Vec3::X,"));
    assert_ne!(moved, solution);
    moved
}

fn build(course: &Course) {
    let mut command: Command = cargo(&course.folder);
    command.args(["build", "--quiet", "--package", "fk", "--bin", "fk-worker"]);
    let status = command.stdin(Stdio::null()).status().unwrap();
    assert!(status.success());
}

/// The time from saving edit `number` until its picture is drawn, as the window does it.
fn picture(course: &Course, stage: &Arc<Stage>, number: usize) -> Duration {
    let mut live = open(course, stage);
    let mut app = App::new(Arc::clone(stage), "running.bvh".into(), Vec::new(), SIZE);
    app.go_to(FRAME);
    let mut painter = Painter::new();
    let mut canvas = Canvas::new(SIZE.0, SIZE.1);
    let mut drawn = None;
    // As the window does: what looks like the picture before is not drawn again.
    let mut draw = |live: &mut Live| {
        live.update(&[FRAME]);
        let standing = live.student().standing(0, FRAME);
        let answers = live.of(0);
        let scene = app.scene(Shown::Student(&answers), SIZE);
        if drawn.as_ref() != Some(&scene) {
            painter.draw(&scene, &mut canvas);
            drawn = Some(scene);
        }
        assert!(!matches!(standing.status, Status::Failed(_)), "{standing:?}");
        standing
    };
    while draw(&mut live).board.is_none() {
        thread::sleep(PICTURE);
    }
    let place = |live: &Live| live.student().pose(0, FRAME).unwrap().pose.transforms()[0].position.x;
    let before = place(&live);

    let start = Instant::now();
    course.save(&edit(number));
    loop {
        let next = Instant::now() + PICTURE;
        let standing = draw(&mut live);
        if standing.current && place(&live) != before {
            return start.elapsed();
        }
        thread::sleep(next.saturating_duration_since(Instant::now()));
    }
}

/// Watches the copy, and builds it where cargo does so by itself.
fn open(course: &Course, stage: &Arc<Stage>) -> Live {
    let folder = course.folder.clone();
    let build = move |version: &_| {
        let target = folder.join("target");
        worker::compile_into(&target, Package::Fk, &folder, version).map(|program| program.worker())
    };
    Live::open_with(Mover::Fk, &course.folder, vec![Arc::clone(stage)], Vec::new(), build)
}

fn median(mut times: Vec<Duration>) -> Duration {
    times.sort();
    times[times.len() / 2]
}
