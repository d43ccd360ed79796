//! Every misconception costs what it should, is named, and is taken for no other: on the public seed and on 20 more.

#[path = "support/marks.rs"]
mod marks;

use exam::Functions;
use grading::{CheckState, Exercise, PUBLIC_SEED, PartState, Solutions, fk};
use skeleton::FkFunctions;

use marks::{exams, names, report};

const RIGHT: Functions = Functions::Fk(solutions::FK);

#[test]
fn the_solution_gets_all_points_and_no_remark() {
    marks::all_points_and_no_remark(RIGHT);
}

#[test]
fn the_template_is_not_started() {
    marks::not_started(Functions::Fk(fk::TEMPLATE));
}

#[test]
fn a_short_pi_gets_all_points_and_a_remark() {
    marks::accepted_with_a_remark(0, &fk::accepted("part1"));
}

#[test]
fn each_misconception_costs_its_checks_and_is_the_only_one_named() {
    marks::each_costs_its_checks_and_is_the_only_one_named(Exercise::of(&RIGHT));
}

#[test]
fn every_misconception_says_what_and_why_and_what_next() {
    marks::each_says_what_and_why_and_what_next(Exercise::of(&RIGHT), &["You"], 25);
    marks::each_is_seen_wherever_it_costs(Exercise::of(&RIGHT));
}

#[test]
fn two_misconceptions_in_one_function_are_both_named_when_they_show_in_different_checks() {
    fn swapped_and_root_unturned(
        joint: &skeleton::Joint,
        local: glam::Quat,
        pose: &skeleton::Pose,
    ) -> glam::Quat {
        joint.parent.map_or(glam::Quat::IDENTITY, |parent| local * pose[parent].rotation)
    }
    let functions = FkFunctions { global_quaternion: swapped_and_root_unturned, ..solutions::FK };
    let exam = fk::exam(PUBLIC_SEED, &Solutions);
    let report = &report(&exam, 1, Functions::Fk(functions));
    assert_eq!(names(report), ["local_times_parent", "root_forgotten"]);
    assert_eq!(report.points(), 0);
}

#[test]
fn a_mistake_that_nobody_knows_is_not_given_a_name() {
    fn halfway(joint: &skeleton::Joint, local: glam::Vec3, pose: &skeleton::Pose) -> glam::Vec3 {
        solutions::fk::global_position(joint, local * 0.5, pose)
    }
    let functions = FkFunctions { global_position: halfway, ..solutions::FK };
    let report = &report(&fk::exam(PUBLIC_SEED, &Solutions), 2, Functions::Fk(functions));
    assert_eq!((report.state, report.named.len(), report.points()), (PartState::Wrong, 0, 0));
    let CheckState::Wrong(first) = &report.checks[1].state else { panic!("{:?}", report.checks[1]) };
    assert!(!first.inputs.is_empty() && first.difference.got != first.difference.expected);
}

#[test]
fn every_check_asks_something() {
    for (seed, exam) in exams(Exercise::of(&RIGHT)) {
        for check in exam.parts.iter().flat_map(|part| &part.checks) {
            assert!(!check.cases.is_empty(), "seed {seed}: {} has no cases", check.rubric.id);
        }
    }
}

/// The channels say the same as the order: who works with them is right too.
#[test]
fn a_solution_by_channels_is_right() {
    fn by_channels(joint: &skeleton::Joint, frame: &mut skeleton::FrameCursor) -> glam::Quat {
        let turn = |channel: &skeleton::Channel| match *channel {
            skeleton::Channel::Position(_) => glam::Quat::IDENTITY,
            skeleton::Channel::Rotation(axis) => {
                glam::Quat::from_axis_angle(axis.unit(), frame.take().to_radians())
            }
        };
        joint.channels.iter().map(turn).product()
    }
    let functions = FkFunctions { local_quaternion: by_channels, ..solutions::FK };
    for (seed, exam) in exams(Exercise::of(&RIGHT)) {
        let report = &report(&exam, 0, Functions::Fk(functions));
        assert_eq!(report.state, PartState::Right, "seed {seed}");
    }
}

#[test]
fn one_wrong_order_of_six_is_pointed_out() {
    fn wrong_for_zxy(joint: &skeleton::Joint, frame: &mut skeleton::FrameCursor) -> glam::Quat {
        let right = solutions::fk::local_quaternion(joint, frame);
        if joint.rotation_order == skeleton::RotationOrder::Zxy { right.inverse() } else { right }
    }
    let functions = FkFunctions { local_quaternion: wrong_for_zxy, ..solutions::FK };
    let report = &report(&fk::exam(PUBLIC_SEED, &Solutions), 0, Functions::Fk(functions));
    let CheckState::Wrong(first) = &report.checks[1].state else { panic!("{:?}", report.checks[1]) };
    assert_eq!(first.groups, ["ZXY"]);
}
