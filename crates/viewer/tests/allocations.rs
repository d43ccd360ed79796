//! Drawing the next picture takes no new memory.
#![allow(clippy::unwrap_used)]

mod support;

use std::sync::Arc;

use exam::{Functions, InProcess};
use skeleton::Representation;
use skeleton::acclaim::{AcclaimFunctions, Bone, Skeleton, Visitor};
use viewer::draw::Painter;
use viewer::draw::canvas::Canvas;
use viewer::edit::ReferenceHand;
use viewer::live::board::Board;
use viewer::live::mover::Mover;
use viewer::live::package::Package;
use viewer::live::student::{Standing, Status};
use viewer::motion::source::Source;
use viewer::motion::stage::Stage;
use viewer::motion::time_map::TimeMap;
use viewer::scene::{Look, Scene, Style};
use viewer::view::answers::Recorded;
use viewer::view::app::{App, Shown, Sister};

const SIZE: (usize, usize) = (960, 540);

#[test]
fn drawing_the_next_frame_allocates_nothing() {
    let stage = support::stage();
    let frames = [300, 301, 330, 40, 600];
    for style in [Style::Lit, Style::Lines] {
        let mut scenes = frames.map(|frame| support::everything(&stage, frame, style, SIZE));
        // The same words in all of them: a letter that is new has to be drawn once. All else may change.
        let first = scenes[0].panels.clone();
        scenes.iter_mut().for_each(|scene| scene.panels = first.clone());
        let (mut painter, mut canvas) = (Painter::new(), Canvas::new(SIZE.0, SIZE.1));
        scenes[1].camera.azimuth += 2.0;
        scenes[2].camera.distance *= 0.3;
        painter.draw(&scenes[0], &mut canvas);
        for (frame, scene) in frames.iter().zip(&scenes) {
            let counted = allocation_counter::measure(|| painter.draw(scene, &mut canvas));
            assert_eq!(counted.count_total, 0, "{style:?}, frame {frame}: {counted:?}");
        }
    }
}

#[test]
fn the_second_picture_of_a_frame_and_a_paler_one_allocate_nothing() {
    let stage = support::stage();
    let mut scene = support::everything(&stage, 300, Style::Lit, SIZE);
    let (mut painter, mut canvas) = (Painter::new(), Canvas::new(SIZE.0, SIZE.1));
    painter.draw(&scene, &mut canvas);
    let again = allocation_counter::measure(|| painter.draw(&scene, &mut canvas));
    assert_eq!(again.count_total, 0, "{again:?}");
    scene.figures.items_mut()[1].look = Look::Dimmed;
    let paler = allocation_counter::measure(|| painter.draw(&scene, &mut canvas));
    assert_eq!(paler.count_total, 0, "{paler:?}");
}

/// How many frames there are to go through.
const FRAMES: usize = 60;

/// Shows frames of `app` and counts what that takes, after every letter and every trace has been there once. `look` sees each
/// frame's scene.
fn assert_nothing_is_allocated(app: &mut App, shown: Shown, look: impl Fn(usize, &Scene)) {
    assert_little_is_allocated(app, shown, look, |_| 0);
}

/// The same where a frame takes new memory so many times at most, and gives as much back.
fn assert_little_is_allocated(
    app: &mut App,
    shown: Shown,
    look: impl Fn(usize, &Scene),
    most: impl Fn(usize) -> u64,
) {
    let (mut painter, mut canvas, mut scene) =
        (Painter::new(), Canvas::new(SIZE.0, SIZE.1), Scene::default());
    let mut show = |frame: usize| {
        app.go_to(frame);
        app.fill(&mut scene, shown, SIZE);
        painter.draw(&scene, &mut canvas);
        look(frame, &scene);
    };
    (0..FRAMES).for_each(&mut show);
    for frame in [0, 1, 2, 30, 31, 59, 4] {
        let counted = allocation_counter::measure(|| show(frame));
        assert!(counted.count_total <= most(frame), "frame {frame}: {counted:?}");
        assert_eq!((counted.count_current, counted.bytes_current), (0, 0), "frame {frame}: {counted:?}");
    }
}

/// As the window does it for the reference and for a student, with a joint chosen.
#[test]
fn from_the_frames_angles_to_pixels_nothing_is_allocated() {
    let stage = Arc::new(support::stage());
    let answers = Recorded::of(&solutions::FK, &stage, 0..FRAMES);
    for shown in [Shown::Reference, Shown::Student(&answers)] {
        let mut app = App::new(stage.clone(), "running.bvh".into(), Vec::new(), SIZE);
        app.select(Some(3));
        assert_nothing_is_allocated(&mut app, shown, |_, _| {});
    }
}

/// As the window does it for the exercise on bones, with a bone chosen, and one that is not visited.
#[test]
fn from_the_angles_of_bones_to_pixels_nothing_is_allocated() {
    let stage = walk();
    let visit_bones = |skeleton: &Skeleton, _: &Bone, visitor: &mut Visitor| {
        skeleton.bones().iter().take(29).for_each(|bone| visitor.visit(bone));
    };
    let mut subject = InProcess(Functions::Acclaim(AcclaimFunctions { visit_bones, ..solutions::ACCLAIM }));
    let mut answers = Recorded::ask(Mover::Acclaim, &mut subject, &stage, 0..FRAMES);
    (0..FRAMES).for_each(|frame| answers.ask_details(&mut subject, &stage, frame));
    answers.standing.board = Some(Arc::new(Board::of(&mut subject, Package::Acclaim)));
    for shown in [Shown::Reference, Shown::Student(&answers)] {
        let mut app = App::new(stage.clone(), "walk.amc".into(), Vec::new(), SIZE);
        app.settings.bones = true;
        app.select(Some(3));
        assert_nothing_is_allocated(&mut app, shown, |_, _| {});
    }
}

/// A walk of bones.
fn walk() -> Arc<Stage> {
    let data = |name: &str| format!("{}/../../data/{name}", env!("CARGO_MANIFEST_DIR"));
    let walk = Source { skeleton: Some(data("walk.asf").into()), ..Source::new(data("walk.amc")) };
    walk.read().unwrap().stage
}

/// The same motion with nearly twice as many frames: all but the first lie between two others.
fn slower(stage: &Stage) -> Arc<Stage> {
    let old = stage.moving_frames();
    Arc::new(stage.warped(TimeMap::Whole { old, new: 2 * old - 1 }))
}

/// As the window does it for a motion of joints that is warped, for the reference and for a student.
#[test]
fn a_warped_motion_of_joints_allocates_nothing_either() {
    let stage = slower(&support::stage());
    let answers = Recorded::of(&solutions::FK, &stage, 0..FRAMES);
    for shown in [Shown::Reference, Shown::Student(&answers)] {
        let mut app = App::new(stage.clone(), "running.bvh".into(), Vec::new(), SIZE);
        app.select(Some(3));
        assert_nothing_is_allocated(&mut app, shown, |_, scene| assert!(scene.plot.is_some()));
    }
}

/// As the window does it for the exercises on bones and on time warping.
#[test]
fn a_warped_motion_of_bones_takes_what_the_solution_blends_and_gives_it_back() {
    let stage = slower(&walk());
    let mut subject = InProcess(Functions::TimeWarp(solutions::TIME_WARP));
    let mut answers = Recorded::ask(Mover::TimeWarp, &mut subject, &stage, 0..FRAMES);
    (0..FRAMES).for_each(|frame| answers.ask_details(&mut subject, &stage, frame));
    answers.standing.board = Some(Arc::new(Board::of(&mut subject, Package::TimeWarp)));
    for shown in [Shown::Reference, Shown::Student(&answers)] {
        let mut app = App::new(stage.clone(), "walk.amc".into(), Vec::new(), SIZE);
        app.settings.bones = true;
        app.select(Some(3));
        // A list of angles and one of translations, for the frame and for each that has left its traces.
        let most = |frame: usize| match shown {
            Shown::Reference => 2 * (2 + frame as u64),
            Shown::Student(_) => 2,
        };
        assert_little_is_allocated(&mut app, shown, |_, scene| assert!(scene.plot.is_some()), most);
    }
}

/// As the window does it while a motion is edited, with all that can be shown of that, by the reference and by a student.
#[test]
fn an_edited_motion_allocates_nothing_either() {
    let stage = Arc::new(support::stage());
    for (automatic, beside, package) in
        [(true, false, None), (false, true, None), (true, true, Some(Package::Keyframes))]
    {
        let mut app = App::new(stage.clone(), "running.bvh".into(), Vec::new(), SIZE);
        app.select(Some(3));
        app.show_sister(package.map(|package| Sister { package, standing: answered(package) }));
        let edit = &mut app.settings.edit;
        (edit.automatic, edit.beside) = (automatic, beside);
        (edit.errors, edit.plot, edit.stretch) = (true, true, Some(Representation::Quaternion));
        app.edit(&mut ReferenceHand::default());
        assert_nothing_is_allocated(&mut app, Shown::Reference, |frame, scene| {
            assert!(scene.plot.is_some() && (scene.marks.len() > 5 || frame == 0));
        });
    }
}

/// How things stand with functions that have answered, and have their points.
fn answered(package: Package) -> Standing {
    let mut subject = InProcess(Functions::keyframes(solutions::KEYFRAMES));
    let board = Some(Arc::new(Board::of(&mut subject, package)));
    Standing { status: Status::Answered, current: true, board, former: None, grading: false }
}

#[test]
fn the_counter_sees_what_the_first_picture_takes() {
    let stage = support::stage();
    let scene = support::everything(&stage, 300, Style::Lit, SIZE);
    let (mut painter, mut canvas) = (Painter::new(), Canvas::new(SIZE.0, SIZE.1));
    let first = allocation_counter::measure(|| painter.draw(&scene, &mut canvas));
    assert!(first.count_total > 10, "{first:?}");
}
