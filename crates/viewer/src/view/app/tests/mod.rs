//! What is shown in which state.

mod bones;
mod camera;
mod changes;
mod editing;
mod sister;
mod texts;
mod warped;
mod warped_blame;

use skeleton::{FkFunctions, PositionChannels};

use super::*;
use crate::live::board::{Board, BoardRow};
use crate::live::mover::Mover;
use crate::live::student::Status;
use crate::live::worker::Trouble;
use crate::samples;
use crate::scene::{Line, Look, Off, Scene};
use crate::view::answers::Recorded;

const SIZE: (usize, usize) = (800, 500);

fn app(frames: usize) -> App {
    let stage = Arc::new(Stage::new(samples::chain(frames, 1.0), PositionChannels::Replace));
    App::new(stage, "walk.bvh".into(), Vec::new(), SIZE)
}

const STUB: FkFunctions = FkFunctions {
    local_quaternion: |_, _| glam::Quat::IDENTITY,
    global_quaternion: |_, local, _| local,
    global_position: |_, position, _| position,
};

/// What the functions answer for the shown frame.
fn answers(app: &App, functions: FkFunctions) -> Recorded {
    Recorded::of(&functions, &app.stage, [app.frame()])
}

fn words(scene: &Scene) -> String {
    let lines = scene.panels.iter().flat_map(|panel| panel.lines()).map(|(line, text)| match line {
        Line::Key(key) => format!("{key} {text}"),
        _ => text.to_owned(),
    });
    lines.collect::<Vec<_>>().join("\n")
}

fn looks(scene: &Scene) -> Vec<Look> {
    scene.figures.iter().map(|figure| figure.look).collect()
}

#[test]
fn the_solution_has_no_ghost_and_the_students_figure_has_one() {
    let mut app = app(5);
    assert_eq!(looks(&app.scene(Shown::Reference, SIZE)), [Look::Solid]);
    let mut stub = answers(&app, STUB);
    assert_eq!(looks(&app.scene(Shown::Student(&stub), SIZE)), [Look::Ghost, Look::Solid]);
    stub.standing.current = false;
    let scene = app.scene(Shown::Student(&stub), SIZE);
    assert_eq!(looks(&scene), [Look::Ghost, Look::Dimmed]);
    assert!(words(&scene).contains("your last version that worked"));
    app.act(Action::Ghost);
    assert_eq!(looks(&app.scene(Shown::Student(&stub), SIZE)), [Look::Dimmed]);
}

#[test]
fn with_the_stubs_the_roots_square_moves_with_the_ghost_and_the_rest_stays() {
    let mut app = app(50);
    let mut seen = Vec::new();
    for frame in [0, 40] {
        app.go_to(frame);
        let stub = answers(&app, STUB);
        let scene = app.scene(Shown::Student(&stub), SIZE);
        assert_eq!(scene.figures[0].joints[0].place, scene.figures[1].joints[0].place);
        seen.push(scene.figures[1].clone());
    }
    let places =
        |figure: &crate::scene::Figure| figure.joints.iter().map(|dot| dot.place).collect::<Vec<_>>();
    assert_ne!(seen[0].joints[0].place, seen[1].joints[0].place);
    assert_eq!(places(&seen[0])[1..], places(&seen[1])[1..]);
    assert!(seen[1].axes.iter().all(|axes| axes.rotation == glam::Quat::IDENTITY));
}

#[test]
fn joints_that_are_left_behind_are_told_and_f_brings_them_back() {
    let mut app = app(900);
    let first = answers(&app, STUB);
    app.scene(Shown::Student(&first), SIZE);
    app.go_to(899);
    let stub = answers(&app, STUB);
    let scene = app.scene(Shown::Student(&stub), SIZE);
    assert!(words(&scene).contains("4 of your 5 joints are outside"));
    app.act(Action::Frame);
    assert!(!words(&app.scene(Shown::Student(&stub), SIZE)).contains("outside"));
}

#[test]
fn joints_that_are_not_drawn_are_told_for_the_reference_too() {
    let chain = samples::chain(2, 1.0);
    let mut values = chain.values().to_vec();
    // The last angles of the first frame, and the first position of the second.
    let channels = chain.skeleton().channel_count();
    (values[channels - 1], values[channels]) = (f32::NAN, 1e9);
    let motion = skeleton::Motion::new(chain.skeleton().clone(), 2, 0.1, values).unwrap();
    let stage = Arc::new(Stage::new(motion, PositionChannels::Replace));
    let mut app = App::new(stage, "odd.bvh".into(), Vec::new(), SIZE);
    let first = words(&app.scene(Shown::Reference, SIZE));
    assert!(first.contains("NaN or infinity as the place of 1 of the 5 joints"), "{first}");
    assert!(first.contains("too large for single precision"), "{first}");
    app.offset.x += 1e6;
    let first = words(&app.scene(Shown::Reference, SIZE));
    assert!(first.contains("4 of the 5 joints are outside"), "{first}");

    let ordinary = words(&self::app(5).scene(Shown::Reference, SIZE));
    assert!(!ordinary.contains("joints") && !ordinary.contains("precision"), "{ordinary}");
}

mod traces {
    use super::*;

    #[test]
    fn they_follow_the_tips_up_to_the_present_frame() {
        let mut app = app(50);
        app.go_to(12);
        let scene = app.scene(Shown::Reference, SIZE);
        assert_eq!(scene.trails.len(), 2);
        for (trail, tip) in scene.trails.iter().zip([2, 4]) {
            assert_eq!(trail.points.len(), 13);
            assert_eq!(trail.points.last(), Some(&scene.figures[0].joints[tip].place));
            let before = app.stage.reference(5).transforms()[tip].position;
            assert_eq!(trail.points[5], before);
        }
        app.act(Action::Traces);
        assert!(app.scene(Shown::Reference, SIZE).trails.is_empty());
    }

    #[test]
    fn the_students_are_made_of_what_has_been_answered() {
        let mut app = app(50);
        app.go_to(12);
        let some = Recorded::of(&solutions::FK, &app.stage, [3, 4, 12]);
        assert_eq!(app.scene(Shown::Student(&some), SIZE).trails[0].points.len(), 3);
    }
}

mod selected_joint {
    use super::*;

    #[test]
    fn tab_goes_through_all_joints_and_back() {
        let mut app = app(5);
        let mut seen = Vec::new();
        for _ in 0..6 {
            app.act(Action::NextJoint);
            seen.push(app.selected().unwrap());
        }
        assert_eq!(seen, [0, 1, 2, 3, 4, 0]);
        app.act(Action::PreviousJoint);
        assert_eq!(app.selected(), Some(4));
        app.act(Action::NoJoint);
        assert_eq!(app.selected(), None);
        let empty = Arc::new(Stage::new(
            skeleton::Motion::new(skeleton::Skeleton::new(), 0, 0.1, Vec::new()).unwrap(),
            PositionChannels::Replace,
        ));
        app.act(Action::NextJoint);
        app.replace(empty, Vec::new());
        assert_eq!(app.selected(), None);
        app.act(Action::NextJoint);
        app.scene(Shown::Reference, SIZE);
    }

    #[test]
    fn everything_about_it_is_told_and_who_is_to_blame() {
        let mut app = app(5);
        app.go_to(1);
        app.select(Some(1));
        let alone = words(&app.scene(Shown::Reference, SIZE));
        for part in ["LeftLeg", "parent Hips", "order ZYX", "angles Z 11.68°, Y 0.00°, X 10.00°", "position "]
        {
            assert!(alone.contains(part), "{part} is missing in {alone}");
        }
        let told = |app: &mut App, functions| {
            let recorded = answers(app, functions);
            words(&app.scene(Shown::Student(&recorded), SIZE))
        };
        let right = told(&mut app, solutions::FK);
        assert!(
            right.contains("yours ") && right.contains("expected ") && right.contains("\nright"),
            "{right}"
        );
        let wrong = FkFunctions { global_quaternion: |_, local, _| local, ..solutions::FK };
        assert!(told(&mut app, wrong).contains("part 2 is to blame"));
        app.select(Some(2));
        let end_site = told(&mut app, wrong);
        assert!(end_site.contains("End Site of LeftLeg") && end_site.contains("off by "), "{end_site}");
        assert!(end_site.contains("NONE: takes no angles"), "{end_site}");
    }
}

/// What the board says about the three parts, and nothing else that matters here.
fn board(states: [grading::PartState; 3]) -> Option<Arc<Board>> {
    let row = |state| BoardRow { id: "part", title: "title", points: 0, of: 5, state, named: Vec::new() };
    let (title, text, summary) = (String::new(), String::new(), String::new());
    Some(Arc::new(Board { title, rows: states.map(row).into(), points: 0, of: 15, text, summary }))
}

#[test]
fn joints_are_judged_as_soon_as_part_3_is_begun_and_stay_so_while_points_are_counted_again() {
    use grading::PartState::{NotStarted, Right, Wrong};
    let mut app = app(50);
    app.go_to(40);
    let mut stub = answers(&app, STUB);
    let off = |app: &mut App, stub: &Recorded| {
        let scene = app.scene(Shown::Student(stub), SIZE);
        scene.figures[1].joints[2].off
    };
    stub.standing.board = board([Right, Right, NotStarted]);
    assert_eq!(off(&mut app, &stub), Off::Right, "nothing is wrong yet");
    stub.standing.board = board([NotStarted, NotStarted, Wrong]);
    assert_eq!(off(&mut app, &stub), Off::Much);
    stub.standing.former = stub.standing.board.take();
    assert_eq!(off(&mut app, &stub), Off::Much);
}
