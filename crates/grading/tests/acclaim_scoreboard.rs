//! The scoreboard of the exercise on Acclaim forward kinematics, word for word. After a change,
//! `FK_LAB_BLESS=1 cargo test -p grading --test acclaim_scoreboard` writes the expected texts again: look at them before
//! you keep them.

#[path = "support/golden.rs"]
mod golden;

use exam::Functions;
use glam::{Quat, Vec3};
use grading::acclaim;
use skeleton::acclaim::{AcclaimFunctions, Bone, BoneId, Skeleton, Visitor};
use solutions::ACCLAIM;

#[test]
fn not_started() {
    check("not_started", acclaim::TEMPLATE);
}

#[test]
fn all_right() {
    check("all_right", ACCLAIM);
}

/// Three mistakes that are made often, one in each part.
#[test]
fn reversed_order_world_direction_and_first_children_only() {
    fn rotation(bone: &Bone, [x, y, z]: [f32; 3], parent: Quat) -> Quat {
        let turns = [
            Quat::from_rotation_x(x.to_radians()),
            Quat::from_rotation_y(y.to_radians()),
            Quat::from_rotation_z(z.to_radians()),
        ];
        parent * bone.rot_parent_current * turns.into_iter().product::<Quat>()
    }
    fn ends(bone: &Bone, rotation: Quat, parent_end: Vec3, translation: Vec3) -> (Vec3, Vec3) {
        (parent_end, parent_end + rotation * (bone.length * bone.direction) + translation)
    }
    fn visits(skeleton: &Skeleton, bone: &Bone, visitor: &mut Visitor) {
        visitor.visit(bone);
        if let Some(id) = bone.child {
            visits(skeleton, &skeleton[id], visitor);
        }
    }
    check("often", AcclaimFunctions { bone_rotation: rotation, bone_ends: ends, visit_bones: visits });
}

/// A function that goes on to its bone's own sibling, a root that is treated by itself, and a start that moves.
#[test]
fn right_for_most_bones() {
    fn rotation(bone: &Bone, angles: [f32; 3], parent: Quat) -> Quat {
        let right = (ACCLAIM.bone_rotation)(bone, angles, parent);
        if bone.is_root() { bone.rot_parent_current.inverse() * right } else { right }
    }
    fn ends(bone: &Bone, rotation: Quat, parent_end: Vec3, translation: Vec3) -> (Vec3, Vec3) {
        let start = parent_end + translation;
        (start, start + rotation * (bone.length * bone.local_direction))
    }
    fn visits(skeleton: &Skeleton, bone: &Bone, visitor: &mut Visitor) {
        visitor.visit(bone);
        let mut follow = |link: Option<BoneId>| {
            if let Some(id) = link {
                visits(skeleton, &skeleton[id], visitor);
            }
        };
        follow(bone.child);
        follow(bone.sibling);
    }
    check("most", AcclaimFunctions { bone_rotation: rotation, bone_ends: ends, visit_bones: visits });
}

#[test]
fn a_mistake_without_a_name_and_a_panic() {
    fn farther(bone: &Bone, angles: [f32; 3], parent: Quat) -> Quat {
        (ACCLAIM.bone_rotation)(bone, angles.map(|angle| 1.1 * angle), parent)
    }
    #[allow(unconditional_recursion)] // That is what is wrong with it.
    fn panics(skeleton: &Skeleton, bone: &Bone, visitor: &mut Visitor) {
        visitor.visit(bone);
        let Some(child) = bone.child else { panic!("there is always another bone") };
        panics(skeleton, &skeleton[child], visitor);
    }
    check("no_name_and_panic", AcclaimFunctions { bone_rotation: farther, visit_bones: panics, ..ACCLAIM });
}

fn check(name: &str, functions: AcclaimFunctions) {
    golden::check(&format!("acclaim_{name}"), Functions::Acclaim(functions));
}
