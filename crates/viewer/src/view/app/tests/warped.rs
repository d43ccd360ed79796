//! The exercise on time warping.

use exam::{Functions, InProcess};
use grading::PartState::{NotStarted, Right, Wrong};
use grading::time_warp::TEMPLATE;
use skeleton::acclaim::TimeWarpFunctions;

use super::*;
use crate::motion::time_map::TimeMap;

/// The walk with twice as many frames.
fn walk(frame: usize) -> App {
    warped(TimeMap::Whole { old: 480, new: 960 }, frame)
}

fn warped(map: TimeMap, frame: usize) -> App {
    let mut app = App::new(Arc::new(samples::walk().warped(map)), "walk.amc".into(), Vec::new(), SIZE);
    app.go_to(frame);
    app
}

fn scene(app: &mut App, functions: TimeWarpFunctions, states: [grading::PartState; 3]) -> Scene {
    let mut subject = InProcess(Functions::TimeWarp(functions));
    let mut recorded = Recorded::ask(Mover::TimeWarp, &mut subject, &app.stage, [app.frame()]);
    recorded.ask_details(&mut subject, &app.stage, app.frame());
    recorded.standing.board = board(states);
    app.scene(Shown::Student(&recorded), SIZE)
}

fn lines_of_trouble(scene: &Scene) -> usize {
    let lines = scene.panels.iter().flat_map(|panel| panel.lines());
    lines.filter(|(line, _)| *line == Line::Trouble).count()
}

#[test]
fn frames_that_part_3_does_not_give_are_not_told_as_numbers_that_are_none() {
    let missing = "your part 3 gives no such frame: not drawn";
    for frame in [480, 959] {
        let mut app = walk(frame);
        app.select(Some(1));
        let template = scene(&mut app, TEMPLATE, [NotStarted; 3]);
        let said = words(&template);
        assert!(said.contains(missing) && said.contains("part 3 gives 480 frames"), "{said}");
        assert!(said.contains("yours none: no such frame") && !said.contains("NaN"), "{said}");
        assert_eq!(lines_of_trouble(&template), 0, "nothing is wrong with what is not begun: {said}");
        let begun = scene(&mut app, TEMPLATE, [Right, Right, Wrong]);
        assert!(words(&begun).contains(missing) && lines_of_trouble(&begun) > 0, "{}", words(&begun));
    }
    let given = scene(&mut walk(479), TEMPLATE, [NotStarted; 3]);
    assert!(!words(&given).contains(missing), "{}", words(&given));
}

#[test]
fn a_posture_of_too_few_bones_is_told() {
    let few = TimeWarpFunctions {
        warp: |postures, new_count| {
            let mut warped = (solutions::TIME_WARP.warp)(postures, new_count);
            warped.iter_mut().for_each(|posture| posture.translations.truncate(1));
            warped
        },
        ..solutions::TIME_WARP
    };
    let told = "the posture has angles or translations of 1 bone, and there are 31";
    let said = words(&scene(&mut walk(7), few, [Right, Right, Wrong]));
    assert!(said.contains(told), "{said}");
    let said = words(&scene(&mut walk(7), solutions::TIME_WARP, [Right; 3]));
    assert!(!said.contains("the posture has"), "{said}");
}

#[test]
fn numbers_that_are_none_are_told() {
    let nan = TimeWarpFunctions {
        blend: |from, _, _| {
            let mut posture = from.clone();
            posture.translations[0].x = f32::NAN;
            posture
        },
        warp: |postures, new_count| {
            let mut posture = postures[0].clone();
            posture.translations[0].x = f32::NAN;
            vec![posture; new_count]
        },
        ..solutions::TIME_WARP
    };
    let said = words(&scene(&mut walk(900), nan, [Right, Wrong, Right]));
    assert!(said.contains("NaN or infinity as the place of 38 of your 38 joints"), "{said}");
}

#[test]
fn before_there_is_an_answer_a_bone_is_told_as_it_should_be() {
    let mut app = walk(0);
    app.select(Some(1));
    let said = words(&app.scene(Shown::Student(&Recorded::new(Mover::TimeWarp, Status::Compiling)), SIZE));
    assert!(said.contains("lhipjoint") && said.contains("expected ") && !said.contains("yours"), "{said}");
}

#[test]
fn joints_are_judged_by_the_part_that_is_at_work() {
    let aside = TimeWarpFunctions {
        blend: |from, _, _| {
            let mut posture = from.clone();
            posture.translations[0].x += 100.0;
            posture
        },
        ..TEMPLATE
    };
    let stretch = TimeMap::stretch(480, (100, 160), 200).unwrap();
    let whole = |new| TimeMap::Whole { old: 480, new };
    for (map, at_work) in [(stretch, 1), (whole(100_000), 1), (whole(960), 2)] {
        for begun in 0..3 {
            let mut app = warped(map, 300);
            let states = [0, 1, 2].map(|part| if part == begun { Wrong } else { NotStarted });
            let scene = scene(&mut app, aside, states);
            let is_off = scene.figures[1].joints.iter().any(|dot| dot.off != Off::Right);
            assert_eq!(is_off, begun == at_work, "{map:?}: part {begun}");
        }
    }
}
