//! What is said of the three parts of Acclaim forward kinematics together.
#![allow(clippy::unwrap_used)] // Helpers of tests.

#[path = "support/marks.rs"]
mod marks;

use exam::Functions;
use glam::{EulerRot, Quat, Vec3};
use grading::acclaim::exam;
use grading::{PUBLIC_SEED, Solutions, Trouble, WholeReport};
use skeleton::acclaim::{AcclaimFunctions, Bone, Skeleton, Visitor};
use solutions::ACCLAIM;

fn whole(functions: AcclaimFunctions) -> WholeReport {
    marks::whole(&exam(PUBLIC_SEED, &Solutions), Functions::Acclaim(functions))
}

#[test]
fn the_whole_motion_praises_what_is_right() {
    let whole = whole(ACCLAIM);
    assert!(whole.trouble.is_none() && whole.frames == 9, "{whole:?}");
    assert!(whole.praise.contains("all 9 frames"), "{}", whole.praise);
}

#[test]
fn the_whole_motion_says_which_bone_is_off_first_and_by_how_much() {
    let bone_ends = |bone: &Bone, rotation: Quat, from: Vec3, moved: Vec3| {
        let (start, end) = (ACCLAIM.bone_ends)(bone, rotation, from, moved);
        let off = if bone.name == "lclavicle" { Vec3::new(0.0, 3.0, 4.0) } else { Vec3::ZERO };
        (start, end + off)
    };
    let trouble = whole(AcclaimFunctions { bone_ends, ..ACCLAIM }).trouble;
    let Some(Trouble::Different { summary, details }) = trouble else { panic!("{trouble:?}") };
    assert!(
        summary.ends_with(
            "the first bone that is off is lclavicle in frame 0: its end is 5.000 (file's unit) from where it \
             should be."
        ),
        "{summary}"
    );
    assert_eq!(
        details,
        [
            "Its parent, thorax, is in its place: look at what becomes of lclavicle.",
            "In this frame 3 of 18 bones are off.",
            "Frame 0 is the rest pose, in which all angles are zero.",
        ]
    );
}

#[test]
fn the_whole_motion_notices_when_only_the_rest_pose_is_right_and_when_only_a_start_is_wrong() {
    let bone_rotation = |bone: &Bone, _, parent| (ACCLAIM.bone_rotation)(bone, [0.0; 3], parent);
    let trouble = whole(AcclaimFunctions { bone_rotation, ..ACCLAIM }).trouble;
    let Some(Trouble::Different { summary, details }) = trouble else { panic!("{trouble:?}") };
    assert!(summary.contains(" is lowerback in frame 1: its end is "), "{summary}");
    assert_eq!(details.last().unwrap(), "In frame 0, the rest pose, all bones are in their places.");

    let bone_ends = |bone: &Bone, rotation: Quat, from: Vec3, moved: Vec3| {
        (Vec3::ZERO, (ACCLAIM.bone_ends)(bone, rotation, from, moved).1)
    };
    let trouble = whole(AcclaimFunctions { bone_ends, ..ACCLAIM }).trouble;
    let Some(Trouble::Different { summary, .. }) = trouble else { panic!("{trouble:?}") };
    assert!(summary.contains(" is root in frame 0: its start is "), "{summary}");
    assert!(summary.ends_with("and its end in its place."), "{summary}");
}

/// What is said of the first bone's parent.
fn about_parent(functions: AcclaimFunctions) -> String {
    let trouble = whole(functions).trouble;
    let Some(Trouble::Different { details, .. }) = trouble else { panic!("{trouble:?}") };
    details[0].clone()
}

fn xyz(bone: &Bone, [x, y, z]: [f32; 3], parent: Quat) -> Quat {
    let [x, y, z] = [x, y, z].map(f32::to_radians);
    parent * bone.rot_parent_current * Quat::from_euler(EulerRot::XYZ, x, y, z)
}

/// A root that is turned otherwise is in its place, as it has no length.
#[test]
fn the_whole_motion_says_that_a_parent_in_its_place_is_turned_otherwise() {
    let root = "Its parent, root, is in its place, but turned otherwise than it should be: look at how root is turned.";
    assert_eq!(about_parent(AcclaimFunctions { bone_rotation: xyz, ..ACCLAIM }), root);
    let axes_left_out = |bone: &Bone, angles, parent| {
        let right = (ACCLAIM.bone_rotation)(bone, angles, parent);
        if bone.is_root() { bone.axis_rotation.inverse() * right } else { right }
    };
    assert_eq!(about_parent(AcclaimFunctions { bone_rotation: axes_left_out, ..ACCLAIM }), root);
    // About its own direction: its end is where it was.
    let about_itself = |bone: &Bone, angles, parent| {
        let turn = Quat::from_axis_angle(bone.local_direction.normalize_or(Vec3::X), 1.0);
        let right = (ACCLAIM.bone_rotation)(bone, angles, parent);
        if bone.name == "thorax" { right * turn } else { right }
    };
    let thorax = about_parent(AcclaimFunctions { bone_rotation: about_itself, ..ACCLAIM });
    assert!(thorax.ends_with("than it should be: look at how thorax is turned."), "{thorax}");
}

/// Nor is the parent's rotation what keeps a bone from being visited.
#[test]
fn the_whole_motion_does_not_speak_of_rotations_when_a_bone_is_not_visited() {
    let visit_bones = |_: &Skeleton, bone: &Bone, visitor: &mut Visitor| visitor.visit(bone);
    let bone_rotation = |bone: &Bone, angles, parent| (ACCLAIM.bone_rotation)(bone, angles, parent).inverse();
    let parent = about_parent(AcclaimFunctions { bone_rotation, visit_bones, ..ACCLAIM });
    assert_eq!(parent, "Its parent, root, is in its place: look at what becomes of lowerback.");
}

/// Who counts rotations from the rest pose turns no bone otherwise.
#[test]
fn the_whole_motion_does_not_blame_rotations_that_are_counted_from_the_rest_pose() {
    let from_rest = |bone: &Bone, angles, parent: Quat| {
        // The parent's own axes.
        let parent = parent * bone.axis_rotation * bone.rot_parent_current.inverse();
        let function = if bone.name == "neck" { xyz } else { ACCLAIM.bone_rotation };
        function(bone, angles, parent) * bone.axis_rotation.inverse()
    };
    let bone_ends = |bone: &Bone, rotation: Quat, from: Vec3, moved: Vec3| {
        (from, from + rotation * bone.rest_vector() + moved)
    };
    let neck = about_parent(AcclaimFunctions { bone_rotation: from_rest, bone_ends, ..ACCLAIM });
    assert_eq!(neck, "Its parent, thorax, is in its place: look at what becomes of neck.");
}

#[test]
fn the_whole_motion_says_which_bone_is_not_visited() {
    let visit_bones = |skeleton: &Skeleton, bone: &Bone, visitor: &mut Visitor| {
        let mut all = |bone: &Bone| {
            if bone.name != "rfemur" {
                visitor.visit(bone);
            }
        };
        (ACCLAIM.visit_bones)(skeleton, bone, &mut Visitor::new(&mut all));
    };
    let trouble = whole(AcclaimFunctions { visit_bones, ..ACCLAIM }).trouble;
    let Some(Trouble::Different { summary, details }) = trouble else { panic!("{trouble:?}") };
    assert!(summary.ends_with(" is rfemur in frame 0: it is not visited."), "{summary}");
    assert_eq!(details[1], "In this frame 2 of 18 bones are off.");
}
