//! Misconceptions about the error of a pose: how distances are put together, and which joints count.

use super::{PoseError, wrong_in_part1};
use crate::Misconception;
use crate::keyframes::variants::error::{
    self, All, ButEndSites, EndSites, Tips, WithoutRotation, mean, mean_distance, mean_over_all, not_squared,
    root_of_the_mean, root_of_the_sum,
};

pub(super) fn misconceptions() -> Vec<Misconception> {
    [about_the_sum(), about_the_joints()].into_iter().flatten().collect()
}

fn about_the_sum() -> Vec<Misconception> {
    /// Where tips are off.
    const SEEN_IN: &[&str] = &["one_tip", "all_tips", "leaves"];
    /// Where several are.
    const SEVERAL: &[&str] = &["all_tips"];
    vec![
        Misconception {
            id: "not_squared",
            title: "You do not square the distances.",
            explanation: "The error is a sum of squared distances: one tip that is far off then weighs more than several \
                          that are a little off.",
            hint: "In the example one tip is off by 3 along X and by 4 along Y. How far is it off, and what is the error?",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: [not_squared::<Tips> as PoseError, not_squared::<EndSites>].map(wrong_in_part1).into(),
        },
        Misconception {
            id: "root_of_the_sum",
            title: "You take the square root of the sum.",
            explanation: "The error is the sum of the squares itself. It is added up over many frames, and a sum of roots is \
                          another number than the root of a sum.",
            hint: "What do you do with the sum at the very end, and does the text ask for it?",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: [root_of_the_sum::<Tips> as PoseError, root_of_the_sum::<EndSites>]
                .map(wrong_in_part1)
                .into(),
        },
        Misconception {
            id: "mean",
            title: "You divide by the number of joints or tips.",
            explanation: "The error is the sum over all tips and not their mean. It is compared and added up for one skeleton, \
                          so there is nothing to divide by.",
            hint: "Look for a division, or for a mean, behind the sum.",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: [
                mean::<Tips> as PoseError,
                mean::<EndSites>,
                mean_distance::<Tips>,
                mean_distance::<EndSites>,
                root_of_the_mean::<Tips>,
                root_of_the_mean::<EndSites>,
                mean_over_all::<Tips>,
                mean_over_all::<EndSites>,
            ]
            .map(wrong_in_part1)
            .into(),
        },
        Misconception {
            id: "squared_after_adding",
            title: "You add before you square.",
            explanation: "Each tip's distance is squared by itself, and then the squares are added. The square of a sum is \
                          another number: in a sum of vectors, tips that are off in opposite directions even cancel.",
            hint: "Two tips are each off by 1. What is the error, and what does your function make of it?",
            seen_in: SEVERAL,
            costs: SEVERAL,
            variants: [error::squared_sum_of_distances as PoseError, error::squared_sum_of_vectors]
                .map(wrong_in_part1)
                .into(),
        },
        Misconception {
            id: "largest",
            title: "You take the largest of the squared distances instead of their sum.",
            explanation: "Every tip counts. With the largest alone, a pose with one tip off is as bad as a pose with all of \
                          them off.",
            hint: "Two tips are each off by 1. What is the error, and what does your function make of it?",
            // Those who count one tip only may happen to count the largest.
            seen_in: &["one_tip", "all_tips"],
            costs: SEVERAL,
            variants: vec![wrong_in_part1(error::largest)],
        },
        Misconception {
            id: "one_tip_only",
            title: "You count only one tip, the first or the last.",
            explanation: "Every tip counts. A loop that returns inside, or that sets the result anew in each round, ends up \
                          with one of them.",
            hint: "What does a round of your loop do with what the rounds before have found?",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: [error::first_tip as PoseError, error::last_tip].map(wrong_in_part1).into(),
        },
    ]
}

fn about_the_joints() -> Vec<Misconception> {
    vec![
        Misconception {
            id: "all_joints",
            title: "You count all joints and not only the tips.",
            explanation: "Whatever happens in the middle of a skeleton moves the tips too, so that they tell it all. With every \
                          joint counted, it is counted again and again.",
            hint: "Which joints are tips? The text of the function says it.",
            seen_in: &["all_tips", "only_tips"],
            costs: &["only_tips"],
            variants: vec![wrong_in_part1(error::sum::<All>)],
        },
        Misconception {
            id: "end_sites_left_out",
            title: "You count the joints and leave the End Sites out.",
            explanation: "An End Site is the tip of the last bone. It has no rotation, but it has a place, and it is how far \
                          that place is off that counts.",
            hint: "For which joints is your condition on `is_end_site` true?",
            seen_in: &["one_tip", "all_tips", "only_tips"],
            costs: &["one_tip", "all_tips", "only_tips"],
            variants: vec![wrong_in_part1(error::sum::<ButEndSites>)],
        },
        Misconception {
            id: "end_sites_only",
            title: "You count only the End Sites.",
            explanation: "Some files leave End Sites out. Then the last joint of a chain is its tip, for nothing hangs on it.",
            hint: "A joint knows its parent. From all the parents, how can you tell on which joints nothing hangs?",
            seen_in: &["one_tip", "only_tips", "leaves"],
            costs: &["leaves"],
            variants: vec![wrong_in_part1(error::sum::<EndSites>)],
        },
        Misconception {
            id: "without_rotation",
            title: "You take every joint without a rotation for a tip.",
            explanation: "A joint without a rotation of its own can carry others, as a shoulder does that only links two bones. \
                          And the last joint of a chain can have a rotation.",
            hint: "What makes a joint a tip is not how it turns. What else does a joint tell about itself and about others?",
            seen_in: &["one_tip", "only_tips", "leaves"],
            costs: &["only_tips", "leaves"],
            variants: vec![wrong_in_part1(error::sum::<WithoutRotation>)],
        },
    ]
}
