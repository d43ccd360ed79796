//! Every misconception about time warping costs what it should, is named, and is taken for no other: on the public seed and
//! on 20 more.
//!
//! In each variant part 3 calls the variant's own parts 1 and 2. So this shows as well that a mistake in them does not
//! cost points in part 3 again.
#![allow(clippy::unwrap_used)] // Helpers of tests.

use std::time::Duration;

use exam::{Functions, InProcess};
use grading::time_warp::{RUBRIC, TEMPLATE, exam, misconceptions};
use grading::{
    CheckState, Exam, Misconception, PUBLIC_SEED, PartReport, PartRubric, PartState, Solutions, grade_part,
    grade_whole_motion,
};

const NO_LIMIT: Duration = Duration::from_secs(3600);
const RIGHT: Functions = Functions::TimeWarp(solutions::TIME_WARP);

fn exams() -> impl Iterator<Item = (u64, Exam)> {
    let seeds = (0..20).map(|n| n * 7919 + 1).chain([PUBLIC_SEED]);
    seeds.map(|seed| (seed, exam(seed, &Solutions)))
}

fn reports(exam: &Exam, functions: Functions) -> Vec<PartReport> {
    exam.parts.iter().map(|part| grade_part(&mut InProcess(functions), part, NO_LIMIT)).collect()
}

fn lost_checks(report: &PartReport) -> Vec<&'static str> {
    let lost = report.checks.iter().filter(|check| !matches!(check.state, CheckState::Right));
    lost.map(|check| check.rubric.id).collect()
}

fn names(report: &PartReport) -> Vec<&'static str> {
    report.named.iter().map(|named| named.id).collect()
}

fn points(reports: &[PartReport]) -> Vec<u32> {
    reports.iter().map(PartReport::points).collect()
}

fn full_points() -> Vec<u32> {
    RUBRIC.parts.iter().map(PartRubric::points).collect()
}

#[test]
fn the_solution_gets_all_points_and_no_remark() {
    for (seed, exam) in exams() {
        let reports = reports(&exam, RIGHT);
        assert_eq!(points(&reports), full_points(), "seed {seed}");
        for report in reports {
            let PartReport { state, remark, named, .. } = report;
            assert_eq!((state, remark, named.len()), (PartState::Right, None, 0), "seed {seed}");
        }
        let whole = grade_whole_motion(&mut InProcess(RIGHT), &exam.whole_motion, NO_LIMIT);
        assert!(whole.trouble.is_none(), "seed {seed}: {whole:?}");
    }
}

#[test]
fn the_template_is_not_started() {
    for (seed, exam) in exams() {
        let reports = reports(&exam, Functions::TimeWarp(TEMPLATE));
        assert_eq!(points(&reports), [0, 0, 0], "seed {seed}");
        assert!(reports.iter().all(|report| report.state == PartState::NotStarted), "seed {seed}");
    }
}

#[test]
fn each_misconception_costs_its_checks_and_is_the_only_one_named() {
    let mut troubles = Vec::new();
    for (seed, exam) in exams() {
        for (part, rubric) in RUBRIC.parts.iter().enumerate() {
            for misconception in misconceptions(rubric.id) {
                for (index, variant) in misconception.variants.iter().enumerate() {
                    let what = format!("seed {seed}, {}, {}, variant {index}", rubric.id, misconception.id);
                    troubles.extend(check_variant(&exam, part, &misconception, *variant, &what));
                }
            }
        }
    }
    assert!(troubles.is_empty(), "{} troubles\n{}", troubles.len(), troubles.join("\n"));
}

/// What is not as it should be with one variant.
fn check_variant(
    exam: &Exam,
    part: usize,
    misconception: &Misconception,
    variant: Functions,
    what: &str,
) -> Vec<String> {
    let reports = reports(exam, variant);
    let mut troubles = Vec::new();
    let lost = lost_checks(&reports[part]);
    if lost != misconception.costs {
        troubles.push(format!("{what}: costs {lost:?} and not {:?}", misconception.costs));
    }
    let names = names(&reports[part]);
    if names != [misconception.id] {
        troubles.push(format!("{what}: is called {names:?}"));
    }
    for (other, report) in reports.iter().enumerate().filter(|(other, _)| *other != part) {
        if report.state != PartState::Right {
            troubles.push(format!("{what}: part {} is {:?}", other + 1, lost_checks(report)));
        }
    }
    troubles
}

#[test]
fn every_misconception_says_what_and_why_and_what_next() {
    let mut ids = Vec::new();
    for part in RUBRIC.parts {
        for misconception in misconceptions(part.id) {
            let Misconception { id, title, explanation, hint, costs, seen_in, variants } = misconception;
            let begins = ["You ", "Your ", "Behind the last frame you "];
            assert!(
                begins.iter().any(|begin| title.starts_with(begin)) && title.ends_with('.'),
                "{id}: {title}"
            );
            assert!(explanation.len() > 60 && explanation.ends_with('.'), "{id}: {explanation}");
            assert!(hint.len() > 20, "{id}: {hint}");
            assert!(!costs.is_empty() && !variants.is_empty(), "{id}");
            assert!(seen_in.iter().any(|check| costs.contains(check)), "{id}");
            let known = |check: &&str| part.checks.iter().any(|known| known.id == *check);
            assert!(seen_in.iter().chain(costs).all(known), "{id}: no such check in {}", part.id);
            assert!(!ids.contains(&id), "{id} is there twice");
            ids.push(id);
        }
    }
    assert!(ids.len() >= 30, "{} misconceptions", ids.len());
}
