//! What counts as right in the exercise on Acclaim forward kinematics, and what is said when something is not.
#![allow(clippy::unwrap_used)] // Helpers of tests.

#[path = "support/marks.rs"]
mod marks;

use exam::Functions;
use glam::{Mat3, Quat, Vec3};
use grading::acclaim::exam;
use grading::{Exam, PUBLIC_SEED, PartReport, PartState, Solutions, Trouble, WholeReport};
use skeleton::Axis;
use skeleton::acclaim::{AcclaimFunctions, Bone, BoneId, Skeleton, Visitor};
use solutions::ACCLAIM;

use marks::{first_case, lost_checks, names};

fn report(exam: &Exam, part: usize, functions: AcclaimFunctions) -> PartReport {
    marks::report(exam, part, Functions::Acclaim(functions))
}

fn public_report(part: usize, functions: AcclaimFunctions) -> PartReport {
    report(&exam(PUBLIC_SEED, &Solutions), part, functions)
}

fn whole(functions: AcclaimFunctions) -> WholeReport {
    marks::whole(&exam(PUBLIC_SEED, &Solutions), Functions::Acclaim(functions))
}

mod right {
    use super::*;

    fn assert_right(functions: AcclaimFunctions) {
        for seed in (0..20).map(|n| n * 3001 + PUBLIC_SEED) {
            let exam = exam(seed, &Solutions);
            for part in 0..3 {
                let report = report(&exam, part, functions);
                assert_eq!(report.state, PartState::Right, "seed {seed}: {report:?}");
            }
            let whole = marks::whole(&exam, Functions::Acclaim(functions));
            assert!(whole.trouble.is_none(), "seed {seed}: {whole:?}");
        }
    }

    #[test]
    fn are_matrices_and_a_list_of_bones_to_be_visited() {
        fn rotation(bone: &Bone, [x, y, z]: [f32; 3], parent: Quat) -> Quat {
            let turn = Mat3::from_rotation_z(z.to_radians())
                * Mat3::from_rotation_y(y.to_radians())
                * Mat3::from_rotation_x(x.to_radians());
            -Quat::from_mat3(&(Mat3::from_quat(parent * bone.rot_parent_current) * turn))
        }
        fn ends(bone: &Bone, rotation: Quat, parent_end: Vec3, translation: Vec3) -> (Vec3, Vec3) {
            let world = Mat3::from_quat(rotation * bone.axis_rotation.inverse()) * bone.direction;
            (parent_end, translation + bone.length * world + parent_end)
        }
        /// Level by level.
        fn visits(skeleton: &Skeleton, bone: &Bone, visitor: &mut Visitor) {
            let mut level = vec![bone.id];
            while !level.is_empty() {
                level.iter().for_each(|id| visitor.visit(&skeleton[*id]));
                let next = level.iter().flat_map(|id| skeleton.children(*id).map(|child| child.id));
                level = next.collect();
            }
        }
        assert_right(AcclaimFunctions { bone_rotation: rotation, bone_ends: ends, visit_bones: visits });
    }

    /// In this exercise all bones have the usual order, or turn about so few axes that it makes no difference.
    #[test]
    fn is_the_order_that_the_bone_says() {
        fn rotation(bone: &Bone, angles: [f32; 3], parent: Quat) -> Quat {
            let turn = |axis: Axis| Quat::from_axis_angle(axis.unit(), angles[axis.index()].to_radians());
            let axes = bone.rotation_order.axes().into_iter().flatten();
            parent * bone.rot_parent_current * axes.map(turn).product::<Quat>()
        }
        assert_right(AcclaimFunctions { bone_rotation: rotation, ..ACCLAIM });
    }

    #[test]
    fn is_a_stack_from_which_the_last_sibling_comes_first() {
        fn visits(skeleton: &Skeleton, bone: &Bone, visitor: &mut Visitor) {
            let mut stack = vec![bone.id];
            while let Some(id) = stack.pop() {
                visitor.visit(&skeleton[id]);
                stack.extend(skeleton.children(id).map(|child| child.id));
            }
        }
        assert_right(AcclaimFunctions { visit_bones: visits, ..ACCLAIM });
    }

    /// A list in which a parent stands before its children needs no tree.
    #[test]
    fn is_the_list_of_bones_without_those_that_do_not_hang_on_the_first() {
        fn visits(skeleton: &Skeleton, bone: &Bone, visitor: &mut Visitor) {
            let mut hangs = vec![false; skeleton.len()];
            for other in skeleton.bones() {
                let on_another = other.parent.is_some_and(|parent| hangs[parent.0]);
                hangs[other.id.0] = other.id == bone.id || on_another;
                if hangs[other.id.0] {
                    visitor.visit(other);
                }
            }
        }
        assert_right(AcclaimFunctions { visit_bones: visits, ..ACCLAIM });
    }
}

mod wrong {
    use super::*;

    /// In its own part each way of counting rotations is checked by itself. Together the other one does as well.
    #[test]
    fn are_rotations_against_the_rest_pose_but_the_bones_are_in_their_places() {
        fn rotation(bone: &Bone, [x, y, z]: [f32; 3], parent: Quat) -> Quat {
            let turn = Quat::from_rotation_z(z.to_radians())
                * Quat::from_rotation_y(y.to_radians())
                * Quat::from_rotation_x(x.to_radians());
            parent * bone.axis_rotation * turn * bone.axis_rotation.inverse()
        }
        fn ends(bone: &Bone, rotation: Quat, parent_end: Vec3, translation: Vec3) -> (Vec3, Vec3) {
            (parent_end, parent_end + rotation * bone.rest_vector() + translation)
        }
        let functions = AcclaimFunctions { bone_rotation: rotation, bone_ends: ends, ..ACCLAIM };
        assert_eq!(names(&public_report(0, functions)), ["against_rest_pose"]);
        assert_eq!(names(&public_report(1, functions)), ["world_direction"]);
        assert!(whole(functions).trouble.is_none());
    }

    #[test]
    fn are_two_things_at_once_and_both_are_named() {
        fn rotation(_: &Bone, [x, y, z]: [f32; 3], parent: Quat) -> Quat {
            let turn = Quat::from_rotation_x(x.to_radians())
                * Quat::from_rotation_y(y.to_radians())
                * Quat::from_rotation_z(z.to_radians());
            parent * turn
        }
        fn ends(bone: &Bone, rotation: Quat, _: Vec3, translation: Vec3) -> (Vec3, Vec3) {
            (Vec3::ZERO, rotation * (bone.length * bone.local_direction) + translation)
        }
        let functions = AcclaimFunctions { bone_rotation: rotation, bone_ends: ends, ..ACCLAIM };
        let rotations = public_report(0, functions);
        assert_eq!(names(&rotations), ["rest_left_out", "xyz_order"]);
        assert_eq!(lost_checks(&rotations), ["root", "angles", "rest"]);
        let ends = public_report(1, functions);
        assert_eq!(names(&ends), ["parent_end_not_added", "start_at_origin"]);
        assert_eq!(lost_checks(&ends), ["start", "end", "translation"]);
    }

    #[test]
    fn is_what_nobody_knows_and_it_is_given_no_name() {
        let functions = AcclaimFunctions {
            bone_rotation: |bone, angles, parent| {
                (ACCLAIM.bone_rotation)(bone, angles.map(|angle| angle + 1.0), parent)
            },
            bone_ends: |bone, rotation, parent_end, translation| {
                let (start, end) = (ACCLAIM.bone_ends)(bone, rotation, parent_end, translation);
                (start, end + 0.1)
            },
            visit_bones: |skeleton, bone, visitor| {
                for other in skeleton.bones().iter().filter(|other| other.id.0 % 2 == bone.id.0 % 2) {
                    visitor.visit(other);
                }
            },
        };
        for part in 0..3 {
            let report = public_report(part, functions);
            assert!(report.named.is_empty() && report.points() < 5, "{report:?}");
            assert_ne!(report.state, PartState::NotStarted);
        }
    }

    #[test]
    fn is_what_is_not_a_number() {
        let functions = AcclaimFunctions {
            bone_rotation: |_, _, _| Quat::from_xyzw(f32::NAN, 0.0, 0.0, 1.0),
            bone_ends: |_, _, _, _| (Vec3::NAN, Vec3::splat(f32::INFINITY)),
            ..ACCLAIM
        };
        for part in 0..2 {
            let report = public_report(part, functions);
            assert_eq!((report.points(), names(&report).len()), (0, 0), "{report:?}");
            for check in &report.checks {
                let first = first_case(&report, check.rubric.id);
                assert_eq!(first.wrong, first.cases);
                assert!(first.difference.between.contains("not a number"), "{first:?}");
            }
        }
        let Some(Trouble::Different { summary, .. }) = whole(functions).trouble else { panic!() };
        assert!(summary.contains("root in frame 0: its end is not a number"), "{summary}");
    }

    #[test]
    fn is_a_rotation_of_another_length_than_1() {
        let bone_rotation =
            |bone: &Bone, angles, parent| (ACCLAIM.bone_rotation)(bone, angles, parent) * 1.01;
        let report = public_report(0, AcclaimFunctions { bone_rotation, ..ACCLAIM });
        assert_eq!(report.points(), 0);
        let between = &first_case(&report, "angles").difference.between;
        assert_eq!(between, "a rotation has the length 1, this one has 1.0100");
    }

    #[test]
    fn is_a_direction_that_is_normalised_where_there_is_none() {
        let bone_ends = |bone: &Bone, rotation: Quat, from: Vec3, moved: Vec3| {
            let unit = bone.local_direction / bone.local_direction.length();
            (from, from + rotation * (bone.length * unit) + moved)
        };
        let report = public_report(1, AcclaimFunctions { bone_ends, ..ACCLAIM });
        assert_eq!(lost_checks(&report), ["end"]);
        assert_eq!(first_case(&report, "end").groups, ["the root, which has no length"]);
    }
}

mod visits {
    use super::*;

    /// What is said about the first wrong case of a check.
    fn said(check: &str, visit_bones: fn(&Skeleton, &Bone, &mut Visitor)) -> [String; 3] {
        let report = public_report(2, AcclaimFunctions { visit_bones, ..ACCLAIM });
        let difference = &first_case(&report, check).difference;
        [&difference.got, &difference.expected, &difference.between].map(String::clone)
    }

    #[test]
    fn that_never_come_are_told() {
        let said = said("chain", |_, bone, visitor| {
            visitor.visit(bone);
            visitor.visit(bone);
        });
        assert_eq!(said, ["root, root", "for example root, a, b", "a is never visited (and 1 other)"]);
    }

    #[test]
    fn that_come_twice_are_told() {
        let said = said("all", |skeleton, bone, visitor| {
            visitor.visit(bone);
            (ACCLAIM.visit_bones)(skeleton, bone, visitor);
        });
        assert_eq!(said[2], "root is visited twice");
    }

    #[test]
    fn that_come_too_early_are_told() {
        let said = said("chain", |skeleton, _, visitor| {
            skeleton.bones().iter().rev().for_each(|bone| visitor.visit(bone));
        });
        assert_eq!(said[0], "b, a, root");
        assert_eq!(said[2], "a is visited before its parent root (and 1 other)");
    }

    #[test]
    fn of_bones_that_hang_elsewhere_are_told() {
        let said = said("subtree", |skeleton, _, visitor| {
            (ACCLAIM.visit_bones)(skeleton, skeleton.root(), visitor);
        });
        assert_eq!(said[2], "root does not hang on c, and is visited (and 4 others)");
    }

    #[test]
    fn of_bones_that_are_not_in_the_skeleton_are_told() {
        let said = said("chain", |skeleton, bone, visitor| {
            (ACCLAIM.visit_bones)(skeleton, bone, visitor);
            visitor.visit(&Bone { id: BoneId(usize::MAX), ..bone.clone() });
        });
        assert_eq!(said[0], "root, a, b, (not in the skeleton)");
        assert_eq!(said[2], "a bone is visited that is not in the skeleton");
    }
}

#[test]
fn every_check_asks_something_and_the_same_seed_asks_the_same() {
    let questions = |exam: &Exam| -> Vec<exam::Question> {
        let cases = exam.parts.iter().flat_map(|part| &part.checks).flat_map(|check| &check.cases);
        cases.map(|case| case.question.clone()).chain([exam.whole_motion.question.clone()]).collect()
    };
    let public = exam(PUBLIC_SEED, &Solutions);
    for check in public.parts.iter().flat_map(|part| &part.checks) {
        assert!(check.cases.len() >= 3, "{} has {} cases", check.rubric.id, check.cases.len());
        let lines = check.cases.iter().flat_map(|case| &case.inputs);
        let fits = |(name, value): &(String, String)| name.len() <= 32 && value.chars().count() <= 64;
        assert!(lines.clone().all(fits), "{:?}", lines.collect::<Vec<_>>());
    }
    assert_eq!(questions(&public), questions(&exam(PUBLIC_SEED, &Solutions)));
    assert_ne!(questions(&public), questions(&exam(PUBLIC_SEED + 1, &Solutions)));
}
