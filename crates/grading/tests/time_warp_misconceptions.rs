//! Every misconception about time warping costs what it should, is named, and is taken for no other: on the public seed and
//! on 20 more.
//!
//! In each variant part 3 calls the variant's own parts 1 and 2. So this shows as well that a mistake in them does not
//! cost points in part 3 again.

#[path = "support/marks.rs"]
mod marks;

use exam::Functions;
use grading::time_warp::{TEMPLATE, accepted};
use grading::{Accepted, Exercise, PartState};

const RIGHT: Functions = Functions::TimeWarp(solutions::TIME_WARP);

#[test]
fn the_solution_gets_all_points_and_no_remark() {
    marks::all_points_and_no_remark(RIGHT);
}

#[test]
fn the_template_is_not_started() {
    marks::not_started(Functions::TimeWarp(TEMPLATE));
}

/// With four decimals, the fourth of each five, hardly any angle comes back wrong by more than is tolerated.
#[test]
fn a_short_pi_gets_all_points_and_a_remark_where_it_makes_a_difference() {
    let (four_decimals, others): (Vec<_>, Vec<_>) =
        accepted("part2").into_iter().enumerate().partition(|(index, _)| index % 5 == 3);
    assert_eq!((four_decimals.len(), others.len()), (3, 12));
    let others: Vec<Accepted> = others.into_iter().map(|(_, accepted)| accepted).collect();
    marks::accepted_with_a_remark(1, &others);
    for (seed, exam) in marks::exams(Exercise::of(&RIGHT)) {
        for (_, accepted) in &four_decimals {
            let reports = marks::reports(&exam, accepted.functions);
            assert!(
                reports.iter().all(|report| report.state == PartState::Right),
                "seed {seed}: {reports:?}"
            );
            assert!(marks::whole(&exam, accepted.functions).trouble.is_none(), "seed {seed}");
        }
    }
}

#[test]
fn each_misconception_costs_its_checks_and_is_the_only_one_named() {
    marks::each_costs_its_checks_and_is_the_only_one_named(Exercise::of(&RIGHT));
}

#[test]
fn every_misconception_says_what_and_why_and_what_next() {
    marks::each_says_what_and_why_and_what_next(
        Exercise::of(&RIGHT),
        &["You ", "Your ", "After the last frame you "],
        30,
    );
}
