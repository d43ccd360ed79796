//! Every misconception about bones costs what it should, is named, and is taken for no other: on the public seed and on 20
//! more.

#[path = "support/marks.rs"]
mod marks;

use exam::Functions;
use grading::acclaim::{RUBRIC, TEMPLATE, accepted, misconceptions};
use grading::{Exercise, Trouble};

const RIGHT: Functions = Functions::Acclaim(solutions::ACCLAIM);

#[test]
fn the_solution_gets_all_points_and_no_remark() {
    marks::all_points_and_no_remark(RIGHT);
}

#[test]
fn the_template_is_not_started() {
    marks::not_started(Functions::Acclaim(TEMPLATE));
}

#[test]
fn a_short_pi_gets_all_points_and_a_remark() {
    marks::accepted_with_a_remark(0, &accepted("part1"));
}

#[test]
fn each_misconception_costs_its_checks_and_is_the_only_one_named() {
    marks::each_costs_its_checks_and_is_the_only_one_named(Exercise::of(&RIGHT));
}

#[test]
fn every_misconception_says_what_and_why_and_what_next() {
    marks::each_says_what_and_why_and_what_next(
        Exercise::of(&RIGHT),
        &["You ", "Of the bones that hang on one, you "],
        45,
    );
}

/// All of them but those that visit too much, or that only show when one begins in the middle.
#[test]
fn nearly_every_misconception_shows_in_the_whole_motion() {
    const UNSEEN: [&str; 4] = ["visited_again", "only_a_root_begins", "own_siblings", "other_bones"];
    for (seed, exam) in marks::exams(Exercise::of(&RIGHT)) {
        for misconception in RUBRIC.parts.iter().flat_map(|part| misconceptions(part.id)) {
            for variant in &misconception.variants {
                let whole = marks::whole(&exam, *variant);
                let is_seen = matches!(whole.trouble, Some(Trouble::Different { .. }));
                assert_eq!(
                    is_seen,
                    !UNSEEN.contains(&misconception.id),
                    "seed {seed}, {}: {whole:?}",
                    misconception.id
                );
            }
        }
    }
}
