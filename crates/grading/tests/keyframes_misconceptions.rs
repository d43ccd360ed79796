//! Every misconception about keyframes costs what it should, is named, and is taken for no other: on the public seed and on
//! 20 more.

#[path = "support/marks.rs"]
mod marks;

use exam::keyframes::Triples;
use exam::{Answer, Functions, Question};
use grading::{CheckState, Exercise, PUBLIC_SEED, PartState, Solutions, keyframes};
use skeleton::{FrameErrors, KeyframesFunctions, RemovalCosts};

use marks::names;

fn solution() -> Functions {
    Functions::keyframes(solutions::KEYFRAMES)
}

#[test]
fn the_solution_gets_all_points_and_no_remark() {
    marks::all_points_and_no_remark(solution());
}

#[test]
fn the_template_is_not_started() {
    marks::not_started(Functions::keyframes(keyframes::TEMPLATE));
}

#[test]
fn each_misconception_costs_its_checks_and_is_the_only_one_named() {
    marks::each_costs_its_checks_and_is_the_only_one_named(Exercise::of(&solution()));
}

#[test]
fn every_misconception_says_what_and_why_and_what_next() {
    marks::each_says_what_and_why_and_what_next(
        Exercise::of(&solution()),
        &["You ", "Your ", "Of several that cost the same, you "],
        25,
    );
    marks::each_is_seen_wherever_it_costs(Exercise::of(&solution()));
}

/// These are found with every question about many keyframes, and not only with one of them.
#[test]
fn every_case_with_many_removals_shows_costs_that_are_not_refreshed() {
    let traps = ["never_refreshed", "one_neighbour_refreshed", "outdated_costs_count"];
    for (seed, exam) in marks::exams(Exercise::of(&solution())) {
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
    for (seed, exam) in marks::exams(Exercise::of(&solution())) {
        let report = &marks::report(&exam, 2, Functions::keyframes(functions));
        assert_eq!(names(report), ["never_refreshed", "later_of_equals"], "seed {seed}");
        assert_eq!(report.points(), 2, "seed {seed}");
    }
}

#[test]
fn a_mistake_that_nobody_knows_is_not_given_a_name() {
    fn halved(before: usize, frame: usize, after: usize, errors: &FrameErrors) -> f64 {
        solutions::keyframes::removal_cost(before, frame, after, errors) / 2.0
    }
    let functions = KeyframesFunctions { removal_cost: halved, ..solutions::KEYFRAMES };
    let report =
        &marks::report(&keyframes::exam(PUBLIC_SEED, &Solutions), 1, Functions::keyframes(functions));
    assert_eq!((report.state, report.named.len(), report.points()), (PartState::Wrong, 0, 0));
    let CheckState::Wrong(first) = &report.checks[1].state else { panic!("{:?}", report.checks[1]) };
    assert!(first.difference.between.ends_with("(yours is 0.500 times the right one)"), "{first:?}");
}
