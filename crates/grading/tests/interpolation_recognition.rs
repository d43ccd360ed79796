//! What is said about several mistakes at once, about one that nobody knows, and about what is not a number.
#![allow(clippy::unwrap_used)] // Helpers of tests.

#[path = "support/marks.rs"]
mod marks;

use exam::Functions;
use glam::{Quat, Vec3};
use grading::interpolation::{TEMPLATE, exam};
use grading::{CheckState, Exercise, PUBLIC_SEED, PartReport, PartState, Solutions, Trouble, WholeReport};
use skeleton::{Frame, InterpolationFunctions, LocalPose, Representation, RotationOrder, Skeleton};
use solutions::INTERPOLATION;

use marks::{first_case, lost_checks, names};

fn report(functions: InterpolationFunctions, part: usize) -> PartReport {
    let exam = exam(PUBLIC_SEED, &Solutions);
    marks::report(&exam, part, Functions::Interpolation(functions))
}

#[test]
fn a_straight_line_without_ends_is_two_misconceptions() {
    let straight =
        |from: [f32; 3], to: [f32; 3], t| std::array::from_fn(|axis| (1.0 - t) * from[axis] + t * to[axis]);
    let report = report(InterpolationFunctions { interpolate_angles: straight, ..INTERPOLATION }, 0);
    assert_eq!(names(&report), ["angles_straight", "angles_go_on"]);
    assert_eq!(report.points(), 1);
}

/// The formula, and none of what needs care.
fn textbook(from: Quat, to: Quat, t: f32) -> Quat {
    let angle = from.dot(to).acos();
    (from * ((1.0 - t) * angle).sin() + to * (t * angle).sin()) / angle.sin()
}

#[test]
fn the_bare_formula_is_told_of_the_shorter_way_first() {
    let report = report(InterpolationFunctions { slerp: textbook, ..INTERPOLATION }, 1);
    assert_eq!(names(&report), ["no_shorter_way", "rotation_goes_on"]);
    assert_eq!(lost_checks(&report), ["shorter_way", "close", "ends"]);
    assert!(report.named[0].seen_in.contains(&"close"), "that is what it costs");
}

#[test]
fn a_scaled_line_is_recognised_although_it_does_not_take_the_shorter_way() {
    let slerp = |from: Quat, to: Quat, t: f32| {
        let t = t.clamp(0.0, 1.0);
        (from * (1.0 - t) + to * t).normalize()
    };
    let report = report(InterpolationFunctions { slerp, ..INTERPOLATION }, 1);
    assert_eq!(names(&report), ["uneven_speed"]);
    assert_eq!(lost_checks(&report), ["near", "shorter_way", "close"]);
}

#[test]
fn another_mistake_with_equal_rotations_is_not_called_a_division_by_zero() {
    let with = |slerp| InterpolationFunctions { slerp, ..INTERPOLATION };
    let divides = with(|from, to, t| {
        let is_same = from.dot(to).abs() >= 1.0;
        (INTERPOLATION.slerp)(from, to, t) * if is_same { f32::NAN } else { 1.0 }
    });
    assert_eq!(names(&report(divides, 1)), ["division_by_zero"]);
    let adds = with(|from, to, t| {
        let is_same = from.dot(to).abs() >= 1.0;
        (INTERPOLATION.slerp)(from, to, t) * if is_same { 2.0 } else { 1.0 }
    });
    let report = report(adds, 1);
    assert_eq!((lost_checks(&report), names(&report)), (vec!["close"], vec![]));
}

#[test]
fn rotations_and_positions_of_a_frame_are_named_independently() {
    let functions = InterpolationFunctions {
        interpolate_frame: |skeleton, from, to, t, _| {
            let pose = (INTERPOLATION.interpolate_frame)(skeleton, from, to, t, Representation::Euler);
            LocalPose { positions: from.local_positions.clone(), ..pose }
        },
        ..INTERPOLATION
    };
    let report = report(functions, 2);
    assert_eq!(names(&report), ["always_euler", "positions_stay"]);
    assert_eq!(report.points(), 2);
}

#[test]
fn a_mistake_that_nobody_knows_is_not_given_a_name() {
    let functions = InterpolationFunctions {
        interpolate_angles: |from, to, t| {
            (INTERPOLATION.interpolate_angles)(from, to, t).map(|angle| angle + 1.0)
        },
        slerp: |from, to, t| (INTERPOLATION.slerp)(from, to, t * t),
        interpolate_frame: |skeleton, from, to, t, representation| {
            (INTERPOLATION.interpolate_frame)(skeleton, from, to, t * t, representation)
        },
    };
    for part in 0..3 {
        let report = report(functions, part);
        assert!(report.named.is_empty() && report.points() < 5, "{report:?}");
        assert_ne!(report.state, PartState::NotStarted);
    }
}

#[test]
fn a_part_that_nobody_touched_is_not_started_whatever_the_other_parts_do() {
    let begun = [INTERPOLATION, InterpolationFunctions { slerp: textbook, ..INTERPOLATION }];
    for functions in begun {
        let functions = InterpolationFunctions { interpolate_frame: TEMPLATE.interpolate_frame, ..functions };
        assert_eq!(report(functions, 2).state, PartState::NotStarted);
    }
}

#[test]
fn a_figure_without_its_end_sites_is_told_how_many_are_missing() {
    let functions = InterpolationFunctions {
        interpolate_frame: |skeleton, from, to, t, representation| {
            let mut pose = (INTERPOLATION.interpolate_frame)(skeleton, from, to, t, representation);
            let is_turned = |index: &usize| !skeleton.joints()[*index].is_end_site;
            pose.rotations =
                (0..skeleton.len()).filter(is_turned).map(|index| pose.rotations[index]).collect();
            pose
        },
        ..INTERPOLATION
    };
    let report = report(functions, 2);
    let first = &first_case(&report, "euler").difference;
    assert_eq!((&*first.got, &*first.between), ("1 rotation", "1 rotation missing"));
    let whole = whole(functions);
    let Some(Trouble::Different { summary, .. }) = &whole.trouble else { panic!("{whole:?}") };
    assert!(summary.contains("joints and End Sites, and each needs one of both"), "{summary}");
}

#[test]
fn what_is_not_a_number_is_never_right() {
    let functions = InterpolationFunctions {
        interpolate_angles: |_, _, _| [f32::NAN; 3],
        slerp: |_, _, _| Quat::from_xyzw(f32::NAN, 0.0, 0.0, 1.0),
        interpolate_frame: |skeleton, _, _, _, _| LocalPose {
            rotations: vec![Quat::from_xyzw(f32::NAN, 0.0, 0.0, 1.0); skeleton.len()],
            positions: vec![Vec3::NAN; skeleton.len()],
        },
    };
    for part in 0..3 {
        let report = report(functions, part);
        assert_eq!((report.points(), names(&report).len()), (0, 0), "{report:?}");
        for check in &report.checks {
            let CheckState::Wrong(first) = &check.state else { panic!("{check:?}") };
            assert_eq!(first.wrong, first.cases);
            assert!(first.difference.between.contains("not a number"), "{first:?}");
        }
    }
}

/// The right frame for so many joints, however many there are.
fn for_joints<const JOINTS: usize>(
    skeleton: &Skeleton,
    from: &Frame,
    to: &Frame,
    t: f32,
    representation: Representation,
) -> LocalPose {
    let mut pose = (INTERPOLATION.interpolate_frame)(skeleton, from, to, t, representation);
    pose.rotations.resize(JOINTS, Quat::IDENTITY);
    pose.positions.resize(JOINTS, Vec3::ZERO);
    pose
}

#[test]
fn lists_that_are_too_short_or_too_long_are_wrong() {
    for interpolate_frame in [for_joints::<0>, for_joints::<1>, for_joints::<1000>] {
        let functions = InterpolationFunctions { interpolate_frame, ..INTERPOLATION };
        let report = report(functions, 2);
        assert_eq!(report.points(), 0, "{report:?}");
        assert!(first_case(&report, "euler").difference.expected.contains("one for every joint"));
        let whole = whole(functions);
        assert!(matches!(whole.trouble, Some(Trouble::Different { .. })), "{whole:?}");
    }
}

#[test]
fn one_wrong_order_of_six_is_pointed_out() {
    let functions = InterpolationFunctions {
        interpolate_frame: |skeleton, from, to, t, representation| {
            let mut pose = (INTERPOLATION.interpolate_frame)(skeleton, from, to, t, representation);
            for (joint, rotation) in skeleton.joints().iter().zip(&mut pose.rotations) {
                if joint.rotation_order == RotationOrder::Zxy {
                    *rotation = rotation.inverse();
                }
            }
            pose
        },
        ..INTERPOLATION
    };
    let report = report(functions, 2);
    let first = first_case(&report, "quaternion");
    assert_eq!(first.groups, ["ZXY"]);
    assert!(first.difference.got.starts_with("Hips (ZXY): "), "{first:?}");
}

fn whole(functions: InterpolationFunctions) -> WholeReport {
    marks::whole(&exam(PUBLIC_SEED, &Solutions), Functions::Interpolation(functions))
}

#[test]
fn the_whole_motion_praises_what_is_right() {
    let whole = whole(INTERPOLATION);
    assert!(whole.trouble.is_none() && whole.frames == 9, "{whole:?}");
    assert!(whole.praise.contains("all 9 moments"), "{}", whole.praise);
}

#[test]
fn the_whole_motion_says_which_joint_is_farthest_off_and_when() {
    let functions = InterpolationFunctions {
        interpolate_frame: |skeleton, from, to, t, representation| {
            let mut pose = (INTERPOLATION.interpolate_frame)(skeleton, from, to, t, representation);
            let neck = skeleton.joints().iter().position(|joint| joint.name == "Neck").unwrap();
            // Farthest at 0.625, and first at 0.25.
            let off = if (0.2..0.9).contains(&t) { 10.0 - 8.0 * (t - 0.625).abs() } else { 0.0 };
            pose.rotations[neck] *= Quat::from_rotation_x(off.to_radians());
            pose.positions[neck].x += if t > 0.9 { 2.0 } else { 0.0 };
            pose
        },
        ..INTERPOLATION
    };
    let Some(Trouble::Different { summary, details }) = whole(functions).trouble else { panic!() };
    assert!(summary.ends_with("Neck is farthest off: 10.00° at t = 0.625."), "{summary}");
    assert!(details[0].starts_with("At t = 0.25 the first joint that is off is Neck"), "{details:?}");
    assert!(!details.iter().any(|line| line.contains("At t = 0 and t = 1 all joints are right")));
}

#[test]
fn every_misconception_says_what_and_why_and_what_next() {
    let exercise = Exercise::of(&Functions::Interpolation(INTERPOLATION));
    marks::each_says_what_and_why_and_what_next(exercise, &["You"], 35);
}
