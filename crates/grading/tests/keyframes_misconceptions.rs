//! Every misconception about keyframes costs what it should, is named, and is taken for no other: on the public seed and on
//! 20 more.

use std::time::Duration;

use exam::keyframes::Triples;
use exam::{Answer, Functions, InProcess, Question};
use grading::{
    CheckState, Exam, Misconception, PUBLIC_SEED, PartReport, PartRubric, PartState, Solutions, grade_part,
    grade_whole_motion, keyframes,
};
use skeleton::{FrameErrors, KeyframesFunctions, RemovalCosts};

const NO_LIMIT: Duration = Duration::from_secs(3600);
const PARTS: [&str; 3] = ["part1", "part2", "part3"];

fn exams() -> impl Iterator<Item = (u64, Exam)> {
    let seeds = (0..20).map(|n| n * 7919 + 1).chain([PUBLIC_SEED]);
    seeds.map(|seed| (seed, keyframes::exam(seed, &Solutions)))
}

fn reports(exam: &Exam, functions: Functions) -> Vec<PartReport> {
    exam.parts.iter().map(|part| grade_part(&mut InProcess(functions), part, NO_LIMIT)).collect()
}

fn lost_checks(report: &PartReport) -> Vec<&'static str> {
    let lost = report.checks.iter().filter(|check| !matches!(check.state, CheckState::Right));
    lost.map(|check| check.rubric.id).collect()
}

fn full_points() -> Vec<u32> {
    keyframes::RUBRIC.parts.iter().map(PartRubric::points).collect()
}

fn points(reports: &[PartReport]) -> Vec<u32> {
    reports.iter().map(PartReport::points).collect()
}

fn named(report: &PartReport) -> Vec<&'static str> {
    report.named.iter().map(|named| named.id).collect()
}

fn solution() -> Functions {
    Functions::keyframes(solutions::KEYFRAMES)
}

#[test]
fn the_solution_gets_all_points_and_no_remark() {
    for (seed, exam) in exams() {
        let reports = reports(&exam, solution());
        assert_eq!(points(&reports), full_points(), "seed {seed}");
        for report in reports {
            assert_eq!(
                (report.state, report.remark, report.named.len()),
                (PartState::Right, None, 0),
                "seed {seed}"
            );
        }
        let whole = grade_whole_motion(&mut InProcess(solution()), &exam.whole_motion, NO_LIMIT);
        assert!(whole.trouble.is_none(), "seed {seed}: {whole:?}");
    }
}

#[test]
fn the_template_is_not_started() {
    for (seed, exam) in exams() {
        let reports = reports(&exam, Functions::keyframes(keyframes::TEMPLATE));
        assert_eq!(points(&reports), [0, 0, 0], "seed {seed}");
        assert!(reports.iter().all(|report| report.state == PartState::NotStarted), "seed {seed}");
    }
}

#[test]
fn each_misconception_costs_its_checks_and_is_the_only_one_named() {
    for (seed, exam) in exams() {
        for (part, id) in PARTS.into_iter().enumerate() {
            for misconception in keyframes::misconceptions(id) {
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
    assert_eq!(named(&reports[part]), [misconception.id], "{what}");
    for (other, report) in reports.iter().enumerate().filter(|(other, _)| *other != part) {
        assert_eq!(report.state, PartState::Right, "{what}: part {}", other + 1);
    }
}

/// These are found with every question about many keyframes, and not only with one of them.
#[test]
fn every_case_with_many_removals_shows_costs_that_are_not_refreshed() {
    let traps = ["never_refreshed", "one_neighbour_refreshed", "outdated_costs_count"];
    for (seed, exam) in exams() {
        for case in &exam.parts[2].checks[1].cases {
            for misconception in keyframes::misconceptions("part3") {
                for variant in misconception.variants.iter().filter(|_| traps.contains(&misconception.id)) {
                    let answer = case.question.ask(variant);
                    assert_ne!(answer, case.expected, "seed {seed}, {}: {:?}", misconception.id, case.inputs);
                }
            }
        }
    }
}

/// Why the questions are chosen and not just any: on a motion of straight stretches all frames but the corners cost nothing
/// for as long as the corners stay, and whoever never looks at costs again does just as well.
#[test]
fn on_an_easy_motion_costs_that_are_never_refreshed_do_no_harm() {
    let corners = [(0, 0.0), (5, 10.0), (9, 2.0), (14, 12.0), (19, 2.0)];
    let position = |frame: usize| {
        let stretch = corners.windows(2).find(|pair| frame <= pair[1].0).unwrap();
        let ((from, low), (to, high)) = (stretch[0], stretch[1]);
        low + (high - low) * (frame - from) as f64 / (to - from) as f64
    };
    let error = |start, frame, end| {
        let t = (frame - start) as f64 / (end - start) as f64;
        (position(start) + t * (position(end) - position(start)) - position(frame)).powi(2)
    };
    let gap = |start, end| (start + 1..end).map(|frame| error(start, frame, end)).sum::<f64>();
    let costs =
        Triples::new(20, |before, frame, after| gap(before, after) - gap(before, frame) - gap(frame, after));
    let question =
        Question::Keyframes(exam::keyframes::Question::Reduce { frame_count: 20, count: 5, costs });
    let right = question.ask(&solution());
    assert_eq!(right, Answer::Keyframes(exam::keyframes::Answer::Reduce(vec![0, 5, 9, 14, 19])));
    let all = keyframes::misconceptions("part3");
    for id in ["never_refreshed", "one_neighbour_refreshed", "outdated_costs_count"] {
        let variants = &all.iter().find(|misconception| misconception.id == id).unwrap().variants;
        assert!(variants.iter().all(|variant| question.ask(variant) == right), "{id}");
    }
}

#[test]
fn two_misconceptions_in_one_function_are_both_named_when_they_show_in_different_checks() {
    fn one_round_and_later_of_equals(frame_count: usize, count: usize, costs: &RemovalCosts) -> Vec<usize> {
        let inner = 1..frame_count.saturating_sub(1);
        let mut by_cost: Vec<(f64, usize)> =
            inner.map(|frame| (costs.of(frame - 1, frame, frame + 1), frame)).collect();
        by_cost.sort_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)));
        let surplus = frame_count.saturating_sub(count.max(2));
        let removed: Vec<usize> = by_cost.iter().take(surplus).map(|(_, frame)| *frame).collect();
        (0..frame_count).filter(|frame| !removed.contains(frame)).collect()
    }
    let functions = KeyframesFunctions { reduce: one_round_and_later_of_equals, ..solutions::KEYFRAMES };
    for (seed, exam) in exams() {
        let report = &reports(&exam, Functions::keyframes(functions))[2];
        assert_eq!(named(report), ["never_refreshed", "later_of_equals"], "seed {seed}");
        assert_eq!(report.points(), 2, "seed {seed}");
    }
}

#[test]
fn a_mistake_that_nobody_knows_is_not_given_a_name() {
    fn halved(before: usize, frame: usize, after: usize, errors: &FrameErrors) -> f64 {
        solutions::keyframes::removal_cost(before, frame, after, errors) / 2.0
    }
    let functions = KeyframesFunctions { removal_cost: halved, ..solutions::KEYFRAMES };
    let report = &reports(&keyframes::exam(PUBLIC_SEED, &Solutions), Functions::keyframes(functions))[1];
    assert_eq!((report.state, report.named.len(), report.points()), (PartState::Wrong, 0, 0));
    let CheckState::Wrong(first) = &report.checks[1].state else { panic!("{:?}", report.checks[1]) };
    assert!(first.difference.between.ends_with("(yours is 0.500 times the right one)"), "{first:?}");
}

#[test]
fn every_misconception_says_what_and_why_and_what_next() {
    let mut ids = Vec::new();
    for misconception in PARTS.into_iter().flat_map(keyframes::misconceptions) {
        let Misconception { id, title, explanation, hint, costs, seen_in, variants } = misconception;
        let begins = ["You ", "Your ", "Of several that cost the same, you "];
        assert!(begins.iter().any(|begin| title.starts_with(begin)) && title.ends_with('.'), "{id}: {title}");
        assert!(explanation.len() > 60 && explanation.ends_with('.'), "{id}: {explanation}");
        assert!(hint.len() > 20, "{id}: {hint}");
        assert!(!costs.is_empty() && costs.iter().all(|check| seen_in.contains(check)), "{id}");
        assert!(!variants.is_empty(), "{id}");
        let known = |check: &&str| {
            keyframes::RUBRIC.parts.iter().flat_map(|part| part.checks).any(|known| known.id == *check)
        };
        assert!(seen_in.iter().all(known), "{id} is seen in a check that does not exist");
        assert!(!ids.contains(&id), "{id} is there twice");
        ids.push(id);
    }
    assert!(ids.len() >= 25, "{} misconceptions", ids.len());
}
