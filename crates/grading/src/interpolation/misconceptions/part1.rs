//! Misconceptions about interpolating angles.

use crate::Misconception;
use crate::interpolation::variants::{angles, functions};

const ALL: &[&str] = &["near", "across", "turns", "ends"];

/// Where the way between the two shows. What is wrong at the ends can be another mistake.
const WAY: &[&str] = &["near", "across", "turns"];

pub(super) fn misconceptions() -> Vec<Misconception> {
    [about_the_way(), about_t()].into_iter().flatten().collect()
}

fn about_the_way() -> Vec<Misconception> {
    vec![
        Misconception {
            id: "angles_straight",
            title: "You take the difference of the two angles as it is.",
            explanation: "170 and −170 are close together, although their numbers are not: there are 20 degrees to go. \
                          A straight line between the numbers goes the other 340.",
            hint: "How far apart can two directions be at most, in degrees?",
            seen_in: WAY,
            costs: &["across", "turns"],
            variants: vec![functions::<angles::Straight>()],
        },
        Misconception {
            id: "one_turn_only",
            title: "You correct the difference by one full turn only.",
            explanation: "The angles of a motion can go on counting: 10 and 730 are the same direction, with two full \
                          turns between their numbers.",
            hint: "Go from 10 to 750 by hand. How many turns does your function take off?",
            seen_in: WAY,
            costs: &["turns"],
            variants: vec![functions::<angles::CorrectedOnce>()],
        },
        Misconception {
            id: "one_side_only",
            title: "You correct the difference on one side only.",
            explanation: "Whether the difference comes out too large or too small depends on which of the two angles \
                          is larger. Both can happen.",
            hint: "Exchange the two angles of your example: does your function still go the shorter way?",
            seen_in: WAY,
            costs: &["across", "turns"],
            variants: vec![
                functions::<angles::OnlyDown>(),
                functions::<angles::OnlyDownRemainder>(),
                functions::<angles::OnlyUp>(),
                functions::<angles::OnlyUpRemainder>(),
            ],
        },
        Misconception {
            id: "full_turns_only",
            title: "You take off full turns, but do not look for the shorter way.",
            explanation: "What is left when full turns are off can still be more than half a turn. Bringing both \
                          angles into one range does not help: it has an end, and there the numbers jump.",
            hint: "Which is the largest difference that should be left, and on which side of zero can it be?",
            seen_in: WAY,
            costs: &["across", "turns"],
            variants: vec![
                functions::<angles::DifferenceWrapped>(),
                functions::<angles::BothWrapped>(),
                functions::<angles::BothWithinHalfTurns>(),
            ],
        },
        Misconception {
            id: "counted_from_zero",
            title: "You bring both angles to between 0 and 360 degrees, and then go straight.",
            explanation: "That only moves the place where the numbers jump. From −10 to 10 you now go from 350 down to \
                          10.",
            hint: "What counts is the difference of the two angles. In which range should that be?",
            seen_in: WAY,
            costs: &["near", "turns"],
            variants: vec![functions::<angles::BothPositive>()],
        },
        Misconception {
            id: "always_up",
            title: "You always go upwards.",
            explanation: "Your difference is never negative: 20 degrees down become 340 degrees up, which leads to the \
                          same direction the longer way round.",
            hint: "`rem_euclid` never gives a negative number. Which of its results are more than half a turn?",
            seen_in: WAY,
            costs: WAY,
            variants: vec![functions::<angles::AlwaysUp>()],
        },
        Misconception {
            id: "degrees_and_radians",
            title: "You mix up degrees and radians.",
            explanation: "The angles that come in are in degrees, and so are those that should come out. A half turn is \
                          180, and not π.",
            hint: "Part 1 needs no sine and no cosine. What could it need radians for?",
            seen_in: WAY,
            costs: ALL,
            variants: vec![
                functions::<angles::ComparedWithPi>(),
                functions::<angles::ComparedWithPiRemainder>(),
                functions::<angles::InRadians>(),
            ],
        },
    ]
}

fn about_t() -> Vec<Misconception> {
    vec![
        Misconception {
            id: "angles_go_on",
            title: "You go on before the first angles and beyond the second.",
            explanation: "A `t` below 0 counts as 0, and one above 1 as 1: between two frames there is nothing else.",
            hint: "`f32` has a function that keeps a number between two others.",
            seen_in: &["ends"],
            costs: &["ends"],
            variants: vec![functions::<angles::GoesOn>()],
        },
        Misconception {
            id: "angles_backwards",
            title: "You count `t` from the wrong end.",
            explanation: "When `t` is 0, the result should be the first angles, and when it is 1, the second.",
            hint: "Put 0 in for `t` by hand. Whose angles are left?",
            seen_in: WAY,
            costs: ALL,
            variants: vec![functions::<angles::Backwards>()],
        },
    ]
}
