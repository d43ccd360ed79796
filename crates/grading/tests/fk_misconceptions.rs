//! Every misconception costs what it should, is named, and is taken for no other: on the public seed and on 20 more.

use std::time::Duration;

use exam::{Functions, InProcess};
use grading::{
    CheckState, Exam, Misconception, PUBLIC_SEED, PartReport, PartRubric, PartState, Solutions, fk,
    grade_part, grade_whole_motion,
};
use skeleton::FkFunctions;

const NO_LIMIT: Duration = Duration::from_secs(3600);

fn exams() -> impl Iterator<Item = (u64, Exam)> {
    let seeds = (0..20).map(|n| n * 7919 + 1).chain([PUBLIC_SEED]);
    seeds.map(|seed| (seed, fk::exam(seed, &Solutions)))
}

fn reports(exam: &Exam, functions: Functions) -> Vec<PartReport> {
    exam.parts.iter().map(|part| grade_part(&mut InProcess(functions), part, NO_LIMIT)).collect()
}

fn lost_checks(report: &PartReport) -> Vec<&'static str> {
    let lost = report.checks.iter().filter(|check| !matches!(check.state, CheckState::Right));
    lost.map(|check| check.rubric.id).collect()
}

fn full_points() -> Vec<u32> {
    fk::RUBRIC.parts.iter().map(PartRubric::points).collect()
}

fn points(reports: &[PartReport]) -> Vec<u32> {
    reports.iter().map(PartReport::points).collect()
}

#[test]
fn the_solution_gets_all_points_and_no_remark() {
    for (seed, exam) in exams() {
        let reports = reports(&exam, Functions::Fk(solutions::FK));
        assert_eq!(points(&reports), full_points(), "seed {seed}");
        for report in reports {
            assert_eq!(
                (report.state, report.remark, report.named.len()),
                (PartState::Right, None, 0),
                "seed {seed}"
            );
        }
    }
}

#[test]
fn the_template_is_not_started() {
    for (seed, exam) in exams() {
        let reports = reports(&exam, Functions::Fk(fk::TEMPLATE));
        assert_eq!(points(&reports), [0, 0, 0], "seed {seed}");
        assert!(reports.iter().all(|report| report.state == PartState::NotStarted), "seed {seed}");
    }
}

#[test]
fn a_short_pi_gets_all_points_and_a_remark() {
    for (seed, exam) in exams() {
        for accepted in fk::accepted("part1") {
            let reports = reports(&exam, accepted.functions);
            assert_eq!(points(&reports), full_points(), "seed {seed}");
            assert_eq!(reports[0].remark, Some(accepted.remark), "seed {seed}");
            let whole = grade_whole_motion(&mut InProcess(accepted.functions), &exam.whole_motion, NO_LIMIT);
            assert!(whole.trouble.is_none(), "seed {seed}");
        }
    }
}

#[test]
fn each_misconception_costs_its_checks_and_is_the_only_one_named() {
    for (seed, exam) in exams() {
        for (part, id) in ["part1", "part2", "part3"].into_iter().enumerate() {
            for misconception in fk::misconceptions(id) {
                for (index, variant) in misconception.variants.iter().enumerate() {
                    let what = format!("seed {seed}, {id}, {}, variant {index}", misconception.id);
                    check_variant(&exam, part, &misconception, *variant, &what);
                }
            }
        }
    }
}

fn check_variant(exam: &Exam, part: usize, misconception: &Misconception, variant: Functions, what: &str) {
    let reports = reports(exam, variant);
    assert_eq!(lost_checks(&reports[part]), misconception.costs, "{what}");
    let named: Vec<_> = reports[part].named.iter().map(|named| named.id).collect();
    assert_eq!(named, [misconception.id], "{what}");
    for (other, report) in reports.iter().enumerate().filter(|(other, _)| *other != part) {
        assert_eq!(report.state, PartState::Right, "{what}: part {}", other + 1);
    }
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
    let report = &reports(&exam, Functions::Fk(functions))[1];
    let named: Vec<_> = report.named.iter().map(|named| named.id).collect();
    assert_eq!(named, ["local_times_parent", "root_forgotten"]);
    assert_eq!(report.points(), 0);
}

#[test]
fn a_mistake_that_nobody_knows_is_not_given_a_name() {
    fn halfway(joint: &skeleton::Joint, local: glam::Vec3, pose: &skeleton::Pose) -> glam::Vec3 {
        solutions::fk::global_position(joint, local * 0.5, pose)
    }
    let functions = FkFunctions { global_position: halfway, ..solutions::FK };
    let report = &reports(&fk::exam(PUBLIC_SEED, &Solutions), Functions::Fk(functions))[2];
    assert_eq!((report.state, report.named.len(), report.points()), (PartState::Wrong, 0, 0));
    let CheckState::Wrong(first) = &report.checks[1].state else { panic!("{:?}", report.checks[1]) };
    assert!(!first.inputs.is_empty() && first.difference.got != first.difference.expected);
}

#[test]
fn every_misconception_says_what_and_why_and_what_next() {
    let mut ids = Vec::new();
    for misconception in ["part1", "part2", "part3"].into_iter().flat_map(fk::misconceptions) {
        let Misconception { id, title, explanation, hint, costs, seen_in, variants } = misconception;
        assert!(title.starts_with("You") && title.ends_with('.'), "{id}: {title}");
        assert!(explanation.len() > 60 && explanation.ends_with('.'), "{id}: {explanation}");
        assert!(hint.len() > 20, "{id}: {hint}");
        assert!(!costs.is_empty() && costs.iter().all(|check| seen_in.contains(check)), "{id}");
        assert!(!variants.is_empty(), "{id}");
        let known = |check: &&str| {
            fk::RUBRIC.parts.iter().flat_map(|part| part.checks).any(|known| known.id == *check)
        };
        assert!(seen_in.iter().all(known), "{id} is seen in a check that does not exist");
        assert!(!ids.contains(&id), "{id} is there twice");
        ids.push(id);
    }
    assert!(ids.len() >= 25, "{} misconceptions", ids.len());
}

#[test]
fn every_check_asks_something() {
    for (seed, exam) in exams() {
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
    for (seed, exam) in exams() {
        let report = &reports(&exam, Functions::Fk(functions))[0];
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
    let report = &reports(&fk::exam(PUBLIC_SEED, &Solutions), Functions::Fk(functions))[0];
    let CheckState::Wrong(first) = &report.checks[1].state else { panic!("{:?}", report.checks[1]) };
    assert_eq!(first.groups, ["ZXY"]);
}
