//! Mistakes in Acclaim forward kinematics as students write them, and the names they are given.
#![allow(clippy::unwrap_used)] // Helpers of tests.

#[path = "support/marks.rs"]
mod marks;

use exam::Functions;
use glam::{EulerRot, Quat, Vec3};
use grading::acclaim::exam;
use grading::{PUBLIC_SEED, Solutions};
use skeleton::acclaim::{AcclaimFunctions, Bone, Skeleton, Visitor};
use solutions::ACCLAIM;

use marks::{lost_checks, names};

/// What the part (0, 1, 2) loses, and which name it is given, on the public seed and some others.
fn assert_named(part: usize, functions: AcclaimFunctions, lost: &[&str], name: &str) {
    for seed in [PUBLIC_SEED, 0, 1, 2, 77, u64::MAX] {
        let report = marks::report(&exam(seed, &Solutions), part, Functions::Acclaim(functions));
        assert_eq!((lost_checks(&report).as_slice(), names(&report)), (lost, vec![name]), "seed {seed}");
    }
}

#[test]
fn a_child_that_is_visited_by_its_parent_and_a_root_by_itself() {
    fn visit_bones(skeleton: &Skeleton, bone: &Bone, visitor: &mut Visitor) {
        if bone.is_root() {
            visitor.visit(bone);
        }
        let mut next = bone.child;
        while let Some(id) = next {
            let child = &skeleton[id];
            visitor.visit(child);
            visit_bones(skeleton, child, visitor);
            next = child.sibling;
        }
    }
    assert_named(2, AcclaimFunctions { visit_bones, ..ACCLAIM }, &["subtree"], "only_a_root_begins");
}

#[test]
fn a_sibling_only_where_there_is_no_child() {
    fn by_calls(skeleton: &Skeleton, bone: &Bone, visitor: &mut Visitor) {
        visitor.visit(bone);
        if let Some(id) = bone.child {
            by_calls(skeleton, &skeleton[id], visitor);
        } else if let Some(id) = bone.sibling {
            by_calls(skeleton, &skeleton[id], visitor);
        }
    }
    fn by_a_loop(skeleton: &Skeleton, bone: &Bone, visitor: &mut Visitor) {
        let mut next = Some(bone.id);
        while let Some(id) = next {
            let bone = &skeleton[id];
            visitor.visit(bone);
            next = bone.child.or(bone.sibling);
        }
    }
    for visit_bones in [by_calls, by_a_loop] {
        let functions = AcclaimFunctions { visit_bones, ..ACCLAIM };
        assert_named(2, functions, &["siblings", "subtree", "all"], "child_or_sibling");
    }
}

#[test]
fn a_root_at_its_translation() {
    let bone_ends = |bone: &Bone, rotation: Quat, parent_end: Vec3, translation: Vec3| {
        if bone.is_root() {
            return (translation, translation);
        }
        (ACCLAIM.bone_ends)(bone, rotation, parent_end, translation)
    };
    assert_named(1, AcclaimFunctions { bone_ends, ..ACCLAIM }, &["start", "end"], "root_by_itself");
}

#[test]
fn euler_angles_as_they_come() {
    const ALL: &[&str] = &["root", "angles", "rest"];
    type Rotation = fn(&Bone, [f32; 3], Quat) -> Quat;
    let xyz: Rotation =
        |bone, [x, y, z], parent| parent * bone.rot_parent_current * Quat::from_euler(EulerRot::XYZ, x, y, z);
    let zyx: Rotation =
        |bone, [x, y, z], parent| parent * bone.rot_parent_current * Quat::from_euler(EulerRot::ZYX, x, y, z);
    for bone_rotation in [xyz, zyx] {
        assert_named(0, AcclaimFunctions { bone_rotation, ..ACCLAIM }, ALL, "degrees_and_order");
    }
}

#[test]
fn three_angles_as_one_axis() {
    let bone_rotation = |bone: &Bone, angles: [f32; 3], parent: Quat| {
        let [x, y, z] = angles.map(f32::to_radians);
        parent * bone.rot_parent_current * Quat::from_scaled_axis(Vec3::new(x, y, z))
    };
    let functions = AcclaimFunctions { bone_rotation, ..ACCLAIM };
    assert_named(0, functions, &["root", "angles"], "rotation_vector");
}

#[test]
fn axes_at_rest_in_part_2_and_a_start_at_the_translation() {
    let rest_again = |bone: &Bone, rotation: Quat, parent_end: Vec3, translation: Vec3| {
        let way = rotation * bone.rot_parent_current * bone.local_direction * bone.length;
        (parent_end, parent_end + way + translation)
    };
    let functions = AcclaimFunctions { bone_ends: rest_again, ..ACCLAIM };
    assert_named(1, functions, &["end", "translation"], "rest_again");
    let start_at_translation = |bone: &Bone, rotation: Quat, parent_end: Vec3, translation: Vec3| {
        (translation, parent_end + rotation * bone.local_direction * bone.length + translation)
    };
    let functions = AcclaimFunctions { bone_ends: start_at_translation, ..ACCLAIM };
    assert_named(1, functions, &["start"], "start_at_translation");
}
