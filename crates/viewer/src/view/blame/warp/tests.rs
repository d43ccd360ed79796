use glam::Quat;
use skeleton::acclaim::{Posture, TimeWarpFunctions};

use super::*;
use crate::motion::time_map::TimeMap;
use crate::samples;

const FRAME: usize = 301;
const MAP: TimeMap = TimeMap::Whole { old: 480, new: 960 };

/// Whom `functions` make to blame for the joint `name` in a frame between two of the walk.
fn judge(functions: &TimeWarpFunctions, name: &str) -> Blame {
    judge_with(functions, name, true)
}

fn judge_with(functions: &TimeWarpFunctions, name: &str, with_details: bool) -> Blame {
    let stage = samples::walk();
    let bones = stage.bones().unwrap();
    let pose = |posture: &Posture| {
        let mut pose = Pose::default();
        bones.pose(&bones.reference(posture), &mut pose);
        pose
    };
    let old: Vec<Posture> = (0..480).map(|index| bones.motion().posture(index)).collect();
    let blend = |place: Between| pose(&(functions.blend)(&old[place.before], &old[place.after], place.t));
    let (place, right_place) = ((functions.old_position)(FRAME, 480, 960), MAP.place(FRAME));
    let (right, own) = (blend(right_place), blend(place));
    let case = Case {
        skeleton: stage.motion().skeleton(),
        given: &pose(&(functions.warp)(&old, 960)[FRAME]),
        expected: &stage.warped(MAP).reference(FRAME),
        place,
        right_place,
        blended: with_details.then_some((&right, Some(&own))),
        size: stage.size(),
    };
    blame(&case, id(name))
}

fn id(name: &str) -> JointId {
    let stage = samples::walk();
    let joint = stage.motion().skeleton().joints().iter().find(|joint| joint.name == name).unwrap();
    joint.id
}

/// Part 3 as the solution has it, of other parts.
fn by_parts(
    old: &[Posture],
    new: usize,
    place: fn(usize, usize, usize) -> Between,
    blend: fn(&Posture, &Posture, f32) -> Posture,
) -> Vec<Posture> {
    let frame = |index| {
        let Between { before, after, t } = place(index, old.len(), new);
        blend(&old[before], &old[after], t)
    };
    (0..new).map(frame).collect()
}

const RIGHT: TimeWarpFunctions = solutions::TIME_WARP;

/// Both ends kept: another mapping.
fn both_ends(new_frame: usize, old: usize, new: usize) -> Between {
    let place = (new_frame * (old - 1)) as f64 / (new - 1) as f64;
    Between { before: place as usize, after: (place as usize + 1).min(old - 1), t: place.fract() as f32 }
}

/// The shin is not blended at all.
fn stiff_shin(from: &Posture, to: &Posture, t: f32) -> Posture {
    let mut posture = (RIGHT.blend)(from, to, t);
    let shin = samples::walk().bones().unwrap().motion().skeleton().find("ltibia").unwrap().id;
    posture.angles[shin.0] = [90.0, 0.0, 0.0];
    posture
}

#[test]
fn nobody_is_to_blame_where_all_is_right() {
    for name in ["root", "ltibia", "lhumerus", "head"] {
        assert_eq!(judge(&RIGHT, name), Blame::Nobody);
        assert_eq!(judge_with(&RIGHT, name, false), Blame::Nobody);
    }
}

#[test]
fn another_mapping_is_the_fault_of_part_1() {
    let functions = TimeWarpFunctions {
        old_position: both_ends,
        warp: |old, new| by_parts(old, new, both_ends, RIGHT.blend),
        ..RIGHT
    };
    assert_eq!(judge(&functions, "root"), Blame::Parts([true, false, false]));
    assert_eq!(judge_with(&functions, "root", false), Blame::Unclear);
}

#[test]
fn a_blend_that_is_wrong_for_one_bone_is_the_fault_of_part_2_and_of_that_bone() {
    let functions = TimeWarpFunctions {
        blend: stiff_shin,
        warp: |old, new| by_parts(old, new, RIGHT.old_position, stiff_shin),
        ..RIGHT
    };
    assert_eq!(judge(&functions, "ltibia"), Blame::Parts([false, true, false]));
    assert_eq!(judge(&functions, "lfoot"), Blame::Above(id("ltibia")));
    assert_eq!(judge(&functions, "lfemur"), Blame::Nobody);
}

#[test]
fn what_parts_1_and_2_have_no_part_in_is_the_fault_of_part_3() {
    // Every frame twice, instead of blended.
    let functions = TimeWarpFunctions {
        warp: |old, new| (0..new).map(|index| old[index * old.len() / new].clone()).collect(),
        ..RIGHT
    };
    assert_eq!(judge(&functions, "root"), Blame::Parts([false, false, true]));
}

#[test]
fn mistakes_in_two_parts_are_told_together() {
    let functions = TimeWarpFunctions {
        old_position: both_ends,
        blend: stiff_shin,
        warp: |old, new| by_parts(old, new, both_ends, stiff_shin),
    };
    assert_eq!(judge(&functions, "ltibia"), Blame::Parts([true, true, false]));
}

#[test]
fn a_place_can_be_said_in_several_ways() {
    let at = |before, after, t| Between { before, after, t };
    assert!(is_same_place(at(3, 3, 0.7), at(2, 3, 1.0)));
    assert!(is_same_place(at(4, 3, 0.5), at(3, 4, 0.5)));
    assert!(!is_same_place(at(3, 4, 0.5), at(3, 4, 0.501)));
    assert!(!is_same_place(at(3, 4, f32::NAN), at(3, 4, 0.5)));
    assert!(same(Quat::IDENTITY, -Quat::IDENTITY));
}
