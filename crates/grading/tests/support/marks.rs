//! Exams of many seeds, what functions get in them, and what must hold for every exercise's misconceptions.
#![allow(dead_code)] // No test uses all of it.
#![allow(clippy::unwrap_used)] // Helpers of tests.

use std::time::Duration;

use exam::{Functions, InProcess};
use grading::{
    CheckState, Exam, Exercise, FirstCase, Misconception, PUBLIC_SEED, PartReport, PartRubric, PartState,
    Solutions, WholeReport, grade_part, grade_whole_motion,
};

/// For functions that are known to come back.
pub const NO_LIMIT: Duration = Duration::from_secs(3600);

/// The exams of the public seed and of 20 more, each with its seed.
pub fn exams(exercise: &Exercise) -> impl Iterator<Item = (u64, Exam)> {
    let seeds = (0..20).map(|n| n * 7919 + 1).chain([PUBLIC_SEED]);
    seeds.map(|seed| (seed, (exercise.exam)(seed, &Solutions)))
}

/// The report on one part.
pub fn report(exam: &Exam, part: usize, functions: Functions) -> PartReport {
    grade_part(&mut InProcess(functions), &exam.parts[part], NO_LIMIT)
}

/// The reports on all parts.
pub fn reports(exam: &Exam, functions: Functions) -> Vec<PartReport> {
    (0..exam.parts.len()).map(|part| report(exam, part, functions)).collect()
}

/// The report on all parts together.
pub fn whole(exam: &Exam, functions: Functions) -> WholeReport {
    grade_whole_motion(&mut InProcess(functions), &exam.whole_motion, NO_LIMIT)
}

/// The checks that are not right.
pub fn lost_checks(report: &PartReport) -> Vec<&'static str> {
    let lost = report.checks.iter().filter(|check| !matches!(check.state, CheckState::Right));
    lost.map(|check| check.rubric.id).collect()
}

/// The misconceptions that are named.
pub fn names(report: &PartReport) -> Vec<&'static str> {
    report.named.iter().map(|named| named.id).collect()
}

/// The first wrong case of a check that is wrong.
pub fn first_case<'a>(report: &'a PartReport, check: &str) -> &'a FirstCase {
    let check = report.checks.iter().find(|known| known.rubric.id == check).unwrap();
    let CheckState::Wrong(first) = &check.state else { panic!("{check:?}") };
    first
}

fn points(reports: &[PartReport]) -> Vec<u32> {
    reports.iter().map(PartReport::points).collect()
}

/// Every part has 5 points.
fn full_points(exercise: &Exercise) -> Vec<u32> {
    let full: Vec<u32> = exercise.rubric.parts.iter().map(PartRubric::points).collect();
    assert_eq!(full, [5, 5, 5]);
    full
}

/// The right functions get all points and no remark, and the whole motion is right.
pub fn all_points_and_no_remark(right: Functions) {
    let exercise = Exercise::of(&right);
    for (seed, exam) in exams(exercise) {
        let reports = reports(&exam, right);
        assert_eq!(points(&reports), full_points(exercise), "seed {seed}");
        for report in reports {
            let PartReport { state, remark, named, .. } = report;
            assert_eq!((state, remark, named.len()), (PartState::Right, None, 0), "seed {seed}");
        }
        let whole = whole(&exam, right);
        assert!(whole.trouble.is_none(), "seed {seed}: {whole:?}");
    }
}

/// These functions have not been started.
pub fn not_started(template: Functions) {
    for (seed, exam) in exams(Exercise::of(&template)) {
        let reports = reports(&exam, template);
        assert_eq!(points(&reports), [0, 0, 0], "seed {seed}");
        assert!(reports.iter().all(|report| report.state == PartState::NotStarted), "seed {seed}");
    }
}

/// What is accepted in this part (0, 1, 2) gets all points and a remark there, and the whole motion is right.
pub fn accepted_with_a_remark(part: usize, accepted: &[grading::Accepted]) {
    assert!(!accepted.is_empty());
    let exercise = Exercise::of(&accepted[0].functions);
    for (seed, exam) in exams(exercise) {
        for accepted in accepted {
            let reports = reports(&exam, accepted.functions);
            assert_eq!(points(&reports), full_points(exercise), "seed {seed}");
            assert_eq!(reports[part].remark, Some(accepted.remark), "seed {seed}");
            assert!(whole(&exam, accepted.functions).trouble.is_none(), "seed {seed}");
        }
    }
}

/// Every variant of every misconception costs its checks and no other, is named, and is taken for no other.
pub fn each_costs_its_checks_and_is_the_only_one_named(exercise: &Exercise) {
    let mut troubles = Vec::new();
    for (seed, exam) in exams(exercise) {
        for (part, rubric) in exercise.rubric.parts.iter().enumerate() {
            for misconception in (exercise.misconceptions)(rubric.id) {
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

/// There are so many misconceptions, each with a name of its own and with words that begin with one of `begins`, and each
/// speaks of checks that its part has.
pub fn each_says_what_and_why_and_what_next(exercise: &Exercise, begins: &[&str], at_least: usize) {
    let mut ids = Vec::new();
    for part in exercise.rubric.parts {
        for misconception in (exercise.misconceptions)(part.id) {
            let Misconception { id, title, explanation, hint, costs, seen_in, variants } = misconception;
            let begins_well = begins.iter().any(|begin| title.starts_with(begin));
            assert!(begins_well && title.ends_with('.'), "{id}: {title}");
            assert!(explanation.len() > 60 && explanation.ends_with('.'), "{id}: {explanation}");
            assert!(hint.len() > 20, "{id}: {hint}");
            assert!(!costs.is_empty() && !seen_in.is_empty() && !variants.is_empty(), "{id}");
            assert!(
                seen_in.iter().any(|check| costs.contains(check)),
                "{id} is seen only where it costs nothing"
            );
            let known = |check: &&str| part.checks.iter().any(|known| known.id == *check);
            assert!(seen_in.iter().chain(costs).all(known), "{id}: no such check in {}", part.id);
            assert!(!ids.contains(&id), "{id} is there twice");
            ids.push(id);
        }
    }
    assert!(ids.len() >= at_least, "{} misconceptions", ids.len());
}

/// What a misconception costs is where it is seen.
pub fn each_is_seen_wherever_it_costs(exercise: &Exercise) {
    for misconception in exercise.rubric.parts.iter().flat_map(|part| (exercise.misconceptions)(part.id)) {
        let Misconception { id, costs, seen_in, .. } = misconception;
        assert!(costs.iter().all(|check| seen_in.contains(check)), "{id}");
    }
}
