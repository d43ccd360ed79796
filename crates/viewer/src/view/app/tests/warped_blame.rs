//! Whom a student's warped motion is told to blame.

use exam::{Functions, InProcess};
use skeleton::acclaim::{Between, Posture, TimeWarpFunctions};

use super::*;
use crate::motion::time_map::TimeMap;

const RIGHT: TimeWarpFunctions = solutions::TIME_WARP;

/// What is said of the upper arm in frame `frame` of the walk, warped by `map`.
fn said(functions: TimeWarpFunctions, map: TimeMap, frame: usize) -> String {
    words(&scene(functions, map, frame))
}

fn scene(functions: TimeWarpFunctions, map: TimeMap, frame: usize) -> Scene {
    let mut app = App::new(Arc::new(samples::walk().warped(map)), "walk.amc".into(), Vec::new(), SIZE);
    app.go_to(frame);
    let joints = app.stage.motion().skeleton().joints();
    app.selected = joints.iter().position(|joint| joint.name == "lhumerus");
    let mut subject = InProcess(Functions::TimeWarp(functions));
    let all = 0..app.stage.frame_count().min(2000);
    let mut recorded = Recorded::ask(Mover::TimeWarp, &mut subject, &app.stage, all);
    recorded.ask_details(&mut subject, &app.stage, frame);
    app.scene(Shown::Student(&recorded), SIZE)
}

/// Three frames late.
fn late(new_frame: usize, old_count: usize, new_count: usize) -> Between {
    (RIGHT.old_position)(new_frame.saturating_sub(3), old_count, new_count)
}

fn warp_late(old: &[Posture], new: usize) -> Vec<Posture> {
    let frame = |index| {
        let Between { before, after, t } = late(index, old.len(), new);
        (RIGHT.blend)(&old[before], &old[after], t)
    };
    (0..new).map(frame).collect()
}

#[test]
fn a_late_part_1_is_to_blame_in_every_frame_of_a_long_motion() {
    let functions = TimeWarpFunctions { old_position: late, warp: warp_late, ..RIGHT };
    for frame in [600, 601, 602] {
        let said = said(functions, TimeMap::Whole { old: 480, new: 1200 }, frame);
        assert!(said.contains("part 1 is to blame"), "{frame}: {said}");
        assert!(!said.contains("part 3 is to blame"), "{frame}: {said}");
    }
}

#[test]
fn where_part_1_puts_a_frame_is_told_in_every_frame_of_a_long_motion() {
    let functions = TimeWarpFunctions { old_position: late, warp: warp_late, ..RIGHT };
    for (frame, told) in [(600, "it at 238.80"), (601, "frame 600 at 238.80"), (602, "it at 239.60")] {
        let said = said(functions, TimeMap::Whole { old: 480, new: 1200 }, frame);
        assert!(said.contains(&format!("part 1 puts {told}")), "{frame}: {said}");
    }
    let said = said(RIGHT, TimeMap::Whole { old: 480, new: 1200 }, 601);
    assert!(!said.contains("part 1 puts"), "{said}");
}

#[test]
fn the_mark_stays_on_the_curve_of_part_1_in_every_frame_of_a_long_motion() {
    let functions = TimeWarpFunctions { old_position: late, warp: warp_late, ..RIGHT };
    for frame in [600, 601, 602] {
        let scene = scene(functions, TimeMap::Whole { old: 480, new: 1200 }, frame);
        let (_, height) = scene.plot.unwrap().mark.unwrap();
        let own = (frame - 3) as f32 * 0.4 / 479.0;
        assert!((height - own).abs() < 1e-3, "{frame}: {height} instead of {own}");
    }
}

#[test]
fn where_only_part_2_is_at_work_no_other_is_to_blame() {
    let still = |from: &Posture, _: &Posture, _: f32| from.clone();
    let functions = TimeWarpFunctions { blend: still, old_position: late, ..RIGHT };
    for map in [TimeMap::stretch(480, (100, 160), 200).unwrap(), TimeMap::Whole { old: 480, new: 100_000 }] {
        let said = said(functions, map, 199);
        assert!(said.contains("part 2 is to blame"), "{map:?}: {said}");
        assert!(!said.contains("part 1 is") && !said.contains("part 3 is"), "{map:?}: {said}");
    }
}
