//! Every misconception costs what it should, is named, and is taken for no other: on the public seed and on 20 more.
//!
//! In each variant part 3 calls the variant's own parts 1 and 2. So this shows as well that a mistake in them does not
//! cost points in part 3 again.

#[path = "support/marks.rs"]
mod marks;

use exam::Functions;
use grading::Exercise;
use grading::interpolation::{TEMPLATE, accepted};

const RIGHT: Functions = Functions::Interpolation(solutions::INTERPOLATION);

#[test]
fn the_solution_gets_all_points_and_no_remark() {
    marks::all_points_and_no_remark(RIGHT);
}

#[test]
fn the_template_is_not_started() {
    marks::not_started(Functions::Interpolation(TEMPLATE));
}

#[test]
fn a_short_pi_gets_all_points_and_a_remark() {
    marks::accepted_with_a_remark(2, &accepted("part3"));
}

#[test]
fn each_misconception_costs_its_checks_and_is_the_only_one_named() {
    marks::each_costs_its_checks_and_is_the_only_one_named(Exercise::of(&RIGHT));
}
