//! Misconceptions about which keyframes stay.

use super::{Reduce, wrong_in_part3};
use crate::Misconception;
use crate::keyframes::variants::reduction;

/// Where something is chosen.
const CHOICE: &[&str] = &["one", "many", "ties"];
/// Where costs change.
const MANY: &[&str] = &["many"];
const ALL: &[&str] = &["one", "many", "ties", "few"];
const FEW: &[&str] = &["few"];
const TIES: &[&str] = &["ties"];

/// What shows only where a cost is below 0.
pub(in crate::keyframes) const BELOW_ZERO: &str = "below_zero";

pub(super) fn misconceptions() -> Vec<Misconception> {
    [about_new_costs(), about_the_choice(), about_how_many()].into_iter().flatten().collect()
}

fn about_new_costs() -> Vec<Misconception> {
    vec![
        Misconception {
            id: "never_refreshed",
            title: "You go on with the costs that there were at first.",
            explanation: "What a removal costs depends on the keyframes next to it. Once one of these is gone, the next removal \
                          leaves a wider gap, and mostly costs more.",
            hint: "In the example, which frame would go second if the costs were still 4, 1 and 2?",
            seen_in: MANY,
            costs: MANY,
            variants: vec![wrong_in_part3(reduction::never_refreshed)],
        },
        Misconception {
            id: "one_neighbour_refreshed",
            title: "You find new costs for only one of the two neighbours.",
            explanation: "A removed keyframe had a neighbour before it and one after it. For both of them, one of the keyframes \
                          next to them is now another.",
            hint: "After each removal, write down which keyframes have other neighbours than before.",
            seen_in: MANY,
            costs: MANY,
            variants: [
                reduction::one_side_refreshed::<true> as Reduce,
                reduction::one_side_refreshed::<false>,
            ]
            .map(wrong_in_part3)
            .into(),
        },
        Misconception {
            id: "outdated_costs_count",
            title: "You let old costs count beside the new ones.",
            explanation: "When a keyframe gets a new cost, its old one does not hold any more. In a list or heap that keeps both, \
                          the old one, if it is less, is found first.",
            hint: "When you take the least cost out of your collection, how can you tell whether it still holds?",
            seen_in: MANY,
            costs: MANY,
            variants: vec![wrong_in_part3(reduction::outdated_costs_count)],
        },
    ]
}

fn about_the_choice() -> Vec<Misconception> {
    vec![
        Misconception {
            id: "most_expensive_removed",
            title: "You remove the keyframes that cost most, and keep those that cost least.",
            explanation: "A cost says how much worse the motion gets when the keyframe goes. Those that cost much are those that \
                          the motion needs.",
            hint: "Which comparison decides, and which way round does it sort?",
            seen_in: CHOICE,
            costs: CHOICE,
            variants: [
                reduction::most_expensive as Reduce,
                reduction::most_expensive_later,
                reduction::cheapest_kept,
                reduction::later_cheapest_kept,
            ]
            .map(wrong_in_part3)
            .into(),
        },
        Misconception {
            id: BELOW_ZERO,
            title: "You do not take a cost below 0 for the least.",
            explanation: "A removal can make the accumulated error smaller. Its cost is then below 0 and less than any other, so \
                          that this keyframe goes first.",
            hint: "Which of 2, −3 and 0.5 is least, and which one would your function find? Look for an absolute value, or for \
                   something that keeps costs at 0 or above.",
            seen_in: CHOICE,
            costs: MANY,
            variants: [reduction::sizes_compared as Reduce, reduction::below_zero_is_zero]
                .map(wrong_in_part3)
                .into(),
        },
        Misconception {
            id: "neighbour_removed",
            title: "You remove the keyframe next to the one that costs least.",
            explanation: "You find the right cost and then remove another keyframe. Of three keyframes that stand side by side it \
                          is the middle one that goes.",
            hint: "Does your index count all keyframes, or only those that have a neighbour on both sides?",
            seen_in: ALL,
            costs: ALL,
            variants: [reduction::neighbour_removed::<true> as Reduce, reduction::neighbour_removed::<false>]
                .map(wrong_in_part3)
                .into(),
        },
        Misconception {
            id: "ends_removed",
            title: "You let the first or the last frame go.",
            explanation: "A frame is interpolated between a keyframe before it and one after it. In front of the first keyframe \
                          and after the last one nothing can be interpolated, so these two stay.",
            hint: "Which cost do the two ends have in your function, and can it ever be the least?",
            seen_in: ALL,
            costs: ALL,
            variants: [
                reduction::first_removed::<false> as Reduce,
                reduction::first_removed::<true>,
                reduction::last_removed::<false>,
                reduction::last_removed::<true>,
            ]
            .map(wrong_in_part3)
            .into(),
        },
        Misconception {
            id: "evenly_spaced",
            title: "Your keyframes are evenly spaced.",
            explanation: "Evenly spaced keyframes waste some where hardly anything moves, and miss what is sudden. The costs tell \
                          which frames matter.",
            hint: "Your function does not look at the costs. Where should it?",
            seen_in: CHOICE,
            costs: CHOICE,
            variants: [
                reduction::evenly_spaced::<0> as Reduce,
                reduction::evenly_spaced::<1>,
                reduction::evenly_spaced::<2>,
            ]
            .map(wrong_in_part3)
            .into(),
        },
        Misconception {
            id: "later_of_equals",
            title: "Of several that cost the same, you remove the last one.",
            explanation: "Where a motion stands still many removals cost the same, namely nothing. So that everyone gets the same \
                          keyframes, a rule decides: the earliest goes.",
            hint: "What does your comparison do when the two costs are equal? Think of `<` and `<=`.",
            seen_in: TIES,
            costs: TIES,
            variants: vec![wrong_in_part3(reduction::later_of_equals)],
        },
    ]
}

fn about_how_many() -> Vec<Misconception> {
    vec![
        Misconception {
            id: "removed_returned",
            title: "You return the frames that you removed.",
            explanation: "The right frames are removed, but the answer is the list of the keyframes that stay, in ascending order.",
            hint: "How long is your list when 10 of 12 frames are to stay?",
            seen_in: ALL,
            costs: ALL,
            variants: [reduction::removed_returned as Reduce, reduction::removed_returned_as_they_go]
                .map(wrong_in_part3)
                .into(),
        },
        Misconception {
            id: "one_off",
            title: "Your number of keyframes is off by one.",
            explanation: "Exactly `count` keyframes stay, the first and the last frame among them. You stop one removal too early \
                          or too late.",
            hint: "How many removals does it take from 5 keyframes to 3? Which condition ends your loop?",
            seen_in: ALL,
            costs: ALL,
            variants: [reduction::one_more as Reduce, reduction::one_more_than_two, reduction::one_less]
                .map(wrong_in_part3)
                .into(),
        },
        Misconception {
            id: "so_many_removed",
            title: "You remove `count` keyframes instead of keeping that many.",
            explanation: "`count` says how many keyframes are wanted at the end. How many must go for that depends on how many \
                          frames there are.",
            hint: "How many removals does it take from 12 keyframes to 10?",
            seen_in: ALL,
            costs: ALL,
            variants: vec![wrong_in_part3(reduction::so_many_removed)],
        },
        Misconception {
            id: "below_two",
            title: "You do not keep just the first and the last frame when fewer than two keyframes are wanted.",
            explanation: "Without keyframes on both sides nothing can be interpolated, so the first and the last frame always \
                          stay. A count of 0 or 1 gives what 2 gives.",
            hint: "What is the smallest number of keyframes that a motion can have?",
            seen_in: FEW,
            costs: FEW,
            variants: [
                reduction::below_two_the_first as Reduce,
                reduction::below_two_the_last,
                reduction::below_two_nothing,
                reduction::below_two_everything,
            ]
            .map(wrong_in_part3)
            .into(),
        },
    ]
}
