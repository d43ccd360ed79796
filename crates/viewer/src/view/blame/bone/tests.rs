use skeleton::acclaim::AcclaimFunctions;

use super::*;
use crate::motion::stage::Stage;
use crate::samples;

const FRAME: usize = 100;

/// Whom `functions` make to blame for the bone `name` in a frame of the walk.
fn judge(functions: AcclaimFunctions, name: &str) -> Blame {
    judge_on(&samples::walk(), functions, name, true)
}

fn judge_on(stage: &Stage, functions: AcclaimFunctions, name: &str, with_visits: bool) -> Blame {
    let (bones, posture) = (stage.bones().unwrap(), stage.posture(FRAME));
    let skeleton = bones.motion().skeleton();
    let mut visits = Vec::new();
    let mut see = |bone: &Bone| visits.push(bone.id);
    let mut visitor = skeleton::acclaim::Visitor::new(&mut see);
    (functions.visit_bones)(skeleton, skeleton.root(), &mut visitor);
    let case = Case {
        skeleton,
        posture: &posture,
        given: &exam::acclaim::places(skeleton, &posture, &functions),
        expected: &bones.reference(&posture),
        visits: with_visits.then_some(&visits[..]),
        size: stage.size(),
    };
    blame(&case, skeleton.find(name).unwrap().id)
}

fn id(name: &str) -> BoneId {
    samples::walk().bones().unwrap().motion().skeleton().find(name).unwrap().id
}

const RIGHT: AcclaimFunctions = solutions::ACCLAIM;
const PART_1: Blame = Blame::Own(Wrong { rotation: true, start: false, end: false });
const END: Blame = Blame::Own(Wrong { rotation: false, start: false, end: true });

#[test]
fn nobody_is_to_blame_where_all_is_right() {
    let stage = samples::walk();
    for bone in stage.bones().unwrap().motion().skeleton().bones() {
        assert_eq!(judge(RIGHT, &bone.name), Blame::Nobody);
        assert_eq!(judge_on(&stage, RIGHT, &bone.name, false), Blame::Nobody);
    }
}

#[test]
fn each_part_is_told_by_itself_with_what_of_it_is_wrong() {
    let turned_round = AcclaimFunctions {
        bone_rotation: |bone, [x, y, z], parent| {
            let [x, y, z] = [x, y, z].map(f32::to_radians);
            let turn = Quat::from_rotation_x(x) * Quat::from_rotation_y(y) * Quat::from_rotation_z(z);
            parent * bone.rot_parent_current * turn
        },
        ..RIGHT
    };
    assert_eq!(judge(turned_round, "lfemur"), PART_1);
    let world_direction = AcclaimFunctions {
        bone_ends: |bone, rotation, parent_end, _| {
            (parent_end, parent_end + rotation * (bone.length * bone.direction))
        },
        ..RIGHT
    };
    assert_eq!(judge(world_direction, "lfemur"), END);
    assert_eq!(judge(world_direction, "root"), Blame::Nobody, "it has no length");
    let on_origin = AcclaimFunctions {
        bone_ends: |bone, rotation, _, translation| {
            (RIGHT.bone_ends)(bone, rotation, Vec3::ZERO, translation)
        },
        ..RIGHT
    };
    let all = Blame::Own(Wrong { rotation: false, start: true, end: true });
    assert_eq!(judge(on_origin, "root"), all);
    let both = AcclaimFunctions { bone_ends: on_origin.bone_ends, ..turned_round };
    assert_eq!(judge(both, "lfemur"), Blame::Own(Wrong { rotation: true, start: true, end: true }));
    let start = AcclaimFunctions {
        bone_ends: |bone, rotation, parent_end, translation| {
            (Vec3::ZERO, (RIGHT.bone_ends)(bone, rotation, parent_end, translation).1)
        },
        ..RIGHT
    };
    let only_start = Blame::Own(Wrong { start: true, ..Wrong::default() });
    assert_eq!(judge(start, "lfemur"), only_start);
}

#[test]
fn what_comes_from_above_is_told_with_the_bone_that_it_comes_from() {
    let stiff = AcclaimFunctions {
        bone_rotation: |bone, angles, parent| {
            let angles = if bone.name == "lfemur" { [0.0; 3] } else { angles };
            (RIGHT.bone_rotation)(bone, angles, parent)
        },
        ..RIGHT
    };
    assert_eq!(judge(stiff, "lfemur"), PART_1);
    assert_eq!(judge(stiff, "ltoes"), Blame::Above(id("lfemur")));
    assert_eq!(judge(stiff, "rtoes"), Blame::Nobody);
}

#[test]
fn part_3_is_told_where_it_leaves_bones_out_or_comes_too_early() {
    assert_eq!(judge(grading::acclaim::TEMPLATE, "ltibia"), Blame::NotVisited);
    let without_femur = AcclaimFunctions {
        visit_bones: |skeleton, _, visitor| {
            let bones = skeleton.bones().iter();
            bones.filter(|bone| bone.name != "lfemur").for_each(|bone| visitor.visit(bone));
        },
        ..RIGHT
    };
    assert_eq!(judge(without_femur, "lfemur"), Blame::NotVisited);
    assert_eq!(judge(without_femur, "ltibia"), Blame::WithoutParent(id("lfemur")));
    assert_eq!(judge(without_femur, "ltoes"), Blame::Above(id("ltibia")));
    let backwards = AcclaimFunctions {
        visit_bones: |skeleton, _, visitor| {
            skeleton.bones().iter().rev().for_each(|bone| visitor.visit(bone));
        },
        ..RIGHT
    };
    assert_eq!(judge(backwards, "ltibia"), Blame::BeforeParent(id("lfemur")));
    assert_eq!(judge(backwards, "root"), Blame::Nobody);
    assert_eq!(judge_on(&samples::walk(), backwards, "ltibia", false), Blame::Unclear);
    let twice = AcclaimFunctions {
        visit_bones: |skeleton, bone, visitor| {
            skeleton.bones().iter().rev().for_each(|bone| visitor.visit(bone));
            (RIGHT.visit_bones)(skeleton, bone, visitor);
        },
        ..RIGHT
    };
    assert_eq!(judge(twice, "ltibia"), Blame::Nobody, "the second time they are put right");
}

const FROM_REST_TOO: AcclaimFunctions = AcclaimFunctions {
    bone_rotation: FROM_REST.rotation,
    bone_ends: FROM_REST.ends,
    visit_bones: RIGHT.visit_bones,
};

#[test]
fn who_counts_rotations_from_the_rest_pose_is_not_to_blame() {
    let stage = samples::walk();
    let skeleton = stage.bones().unwrap().motion().skeleton();
    let mut others = 0;
    for bone in skeleton.bones() {
        match judge(FROM_REST_TOO, &bone.name) {
            Blame::InPlace { from_rest: true } => others += 1,
            judged => assert_eq!(judged, Blame::Nobody),
        }
    }
    assert!(others > 10, "{others}");
    // Who does so and makes a mistake at one bone hears of that bone.
    let stiff = AcclaimFunctions {
        bone_rotation: |bone, angles, parent| {
            let angles = if bone.name == "lfemur" { [0.0; 3] } else { angles };
            (FROM_REST.rotation)(bone, angles, parent)
        },
        ..FROM_REST_TOO
    };
    assert_eq!(judge(stiff, "lfemur"), PART_1);
    assert_eq!(judge(stiff, "ltoes"), Blame::Above(id("lfemur")));
    // And who does so in one part only has made a mistake there.
    let mixed = AcclaimFunctions { bone_ends: RIGHT.bone_ends, ..FROM_REST_TOO };
    assert_eq!(judge(mixed, "lfemur"), PART_1);
}

#[test]
fn a_bone_that_is_in_its_place_is_not_blamed_for_being_turned_about_its_own_length() {
    let twisted = AcclaimFunctions {
        bone_rotation: |bone, angles, parent| {
            let twist = if bone.child.is_none() { 0.5 } else { 0.0 };
            let right = (RIGHT.bone_rotation)(bone, angles, parent);
            right * Quat::from_axis_angle(bone.local_direction.normalize_or(Vec3::X), twist)
        },
        ..RIGHT
    };
    assert_eq!(judge(twisted, "ltoes"), Blame::InPlace { from_rest: false });
    assert_eq!(judge(twisted, "lfoot"), Blame::Nobody);
}

#[test]
fn a_root_that_is_turned_wrongly_is_blamed_though_it_is_in_its_place() {
    let stiff_root = AcclaimFunctions {
        bone_rotation: |bone, angles, parent| {
            (RIGHT.bone_rotation)(bone, if bone.parent.is_none() { [0.0; 3] } else { angles }, parent)
        },
        ..RIGHT
    };
    assert_eq!(judge(stiff_root, "root"), PART_1);
    assert_eq!(judge(stiff_root, "lhipjoint"), Blame::Above(id("root")));
}

#[test]
fn what_is_no_number_is_the_fault_of_the_part_that_made_it() {
    let nan = AcclaimFunctions { bone_ends: |_, _, _, _| (Vec3::NAN, Vec3::NAN), ..RIGHT };
    assert_eq!(judge(nan, "root"), Blame::Own(Wrong { rotation: false, start: true, end: true }));
    let nan = AcclaimFunctions { bone_rotation: |_, _, _| Quat::NAN, ..RIGHT };
    assert_eq!(judge(nan, "root"), PART_1, "part 2 hands it on");
}

#[test]
fn a_file_that_lists_other_orders_is_right_by_its_own_order_and_by_the_exercises() {
    let stage = samples::walk_in_other_orders();
    assert_eq!(judge_on(&stage, RIGHT, "ltibia", true), Blame::Nobody);
    let any_order = AcclaimFunctions { bone_rotation: OTHER_ORDER.rotation, ..RIGHT };
    for name in ["lfemur", "ltibia", "ltoes"] {
        assert_eq!(judge_on(&stage, any_order, name, true), Blame::OtherOrder);
    }
    assert_eq!(judge_on(&stage, any_order, "lhipjoint", true), Blame::Nobody);
    assert_eq!(judge(any_order, "ltoes"), Blame::Nobody);
}
