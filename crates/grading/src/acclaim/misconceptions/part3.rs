//! Misconceptions about which bones are visited, and when.

use super::{Visits, wrong_in_part3};
use crate::Misconception;
use crate::acclaim::variants::visits;

const ALL: &[&str] = &["chain", "siblings", "subtree", "all"];
/// Where a bone has several others on it.
const BRANCHES: &[&str] = &["siblings", "subtree", "all"];
/// Where siblings have bones of their own.
const DEEP: &[&str] = &["subtree", "all"];
const SUBTREE: &[&str] = &["subtree"];

pub(super) fn misconceptions() -> Vec<Misconception> {
    [about_what_is_missing(), about_when(), about_what_is_too_many()].into_iter().flatten().collect()
}

fn about_what_is_missing() -> Vec<Misconception> {
    vec![
        Misconception {
            id: "siblings_left_out",
            title: "You visit only the first of the bones that hang on one.",
            explanation: "`bone.child` is only the first of them. Each of the others is the `sibling` of the one before it.",
            hint: "When you are done with the first child, how do you get to the second? And from there?",
            seen_in: ALL,
            costs: BRANCHES,
            variants: vec![wrong_in_part3(visits::first_child_only)],
        },
        Misconception {
            id: "child_or_sibling",
            title: "You go on from a bone to its child or to its sibling, but not to both.",
            explanation: "Most bones of a figure have a child, and many of these have a sibling too. Whichever of the two you pass \
                          by, with all that hangs on it, is never visited.",
            hint: "Draw a bone with a child and a sibling. Which of your lines does each of the two need?",
            seen_in: ALL,
            costs: BRANCHES,
            variants: [visits::sibling_where_no_child as Visits, visits::child_where_no_sibling]
                .map(wrong_in_part3)
                .into(),
        },
        Misconception {
            id: "siblings_not_entered",
            title: "You visit the siblings, but not what hangs on them.",
            explanation: "A sibling can have bones on it just as the first child can. You go down from the first child only.",
            hint: "What do you do with the first child that you do not do with its siblings?",
            seen_in: ALL,
            costs: DEEP,
            variants: [visits::siblings_not_entered as Visits, visits::own_siblings_not_entered]
                .map(wrong_in_part3)
                .into(),
        },
        Misconception {
            id: "children_only",
            title: "You visit the bones that hang on the bone directly, and nothing below them.",
            explanation: "What hangs on a child has to be visited too, and what hangs on that, however far down.",
            hint: "Visiting a child is the same task as visiting the bone, one step further down. Which function does that?",
            seen_in: ALL,
            costs: ALL,
            variants: vec![wrong_in_part3(visits::children_only)],
        },
        Misconception {
            id: "one_child_short",
            title: "Of the bones that hang on one, you leave out the first or the last.",
            explanation: "The first is the bone's `child`, and the last is the one whose `sibling` is `None`. Both have to be \
                          visited, also where they are the same.",
            hint: "Go through your loop by hand for a bone with one child. How often does it turn?",
            seen_in: ALL,
            costs: ALL,
            variants: [visits::one_child_short::<true> as Visits, visits::one_child_short::<false>]
                .map(wrong_in_part3)
                .into(),
        },
        Misconception {
            id: "leaves_left_out",
            title: "You leave out the bones that nothing hangs on.",
            explanation: "A bone without a child is a bone: a hand, a foot, the head. Only below it there is nothing to do.",
            hint: "Where do you ask whether there is a child, and what depends on it?",
            seen_in: ALL,
            costs: ALL,
            variants: vec![wrong_in_part3(visits::leaves_left_out)],
        },
        Misconception {
            id: "start_left_out",
            title: "You do not visit the bone that you begin with.",
            explanation: "You visit each child before you go down from it, but nobody has visited the very first bone: all others \
                          hang on it, and they need it.",
            hint: "Which bone is visited when nothing hangs on the one that the function is given?",
            seen_in: ALL,
            costs: ALL,
            variants: vec![wrong_in_part3(visits::start_left_out)],
        },
        Misconception {
            id: "only_a_root_begins",
            title: "You visit the bone that you begin with only if it is the root.",
            explanation: "The function can be called with any bone. Each child is visited by the bone that it hangs on, but nobody \
                          does that for the bone that you begin with, unless it is the root.",
            hint: "Begin with a bone that nothing hangs on. Which line visits it?",
            seen_in: ALL,
            costs: SUBTREE,
            variants: vec![wrong_in_part3(visits::only_a_root_begins)],
        },
    ]
}

fn about_when() -> Vec<Misconception> {
    vec![Misconception {
        id: "children_first",
        title: "You visit what hangs on a bone before the bone itself.",
        explanation: "A bone starts where its parent ends, and turns with it. So its parent has to be visited before.",
        hint: "In which line do you visit the bone, and what has been done by then?",
        seen_in: ALL,
        costs: ALL,
        variants: [visits::children_first as Visits, visits::child_first].map(wrong_in_part3).into(),
    }]
}

fn about_what_is_too_many() -> Vec<Misconception> {
    vec![
        Misconception {
            id: "visited_again",
            title: "You visit bones more than once.",
            explanation: "When a function visits its bone, whoever calls it for a bone must not visit that bone too. Each is visited \
                          once.",
            hint: "For a child of the root, write down every line that visits it.",
            seen_in: ALL,
            costs: ALL,
            variants: [visits::children_twice as Visits, visits::parent_again, visits::before_and_after]
                .map(wrong_in_part3)
                .into(),
        },
        Misconception {
            id: "own_siblings",
            title: "You visit the siblings of the bone that you begin with.",
            explanation: "Your function goes on to the sibling of the bone that it is given. For the root that does no harm, because \
                          it has none. But the siblings of another bone do not hang on it.",
            hint: "Which bone should go from sibling to sibling: each child by itself, or the one that they hang on?",
            seen_in: ALL,
            costs: SUBTREE,
            variants: vec![wrong_in_part3(visits::own_siblings)],
        },
        Misconception {
            id: "other_bones",
            title: "You visit bones that do not hang on the one that you begin with.",
            explanation: "The list of all bones is right for the root, on which everything hangs. For another bone only a part of \
                          it is asked for, and that need not stand in one piece.",
            hint: "How do you get from a bone to those that hang on it, without looking at the others?",
            seen_in: ALL,
            costs: SUBTREE,
            variants: [visits::all_bones as Visits, visits::all_from_here].map(wrong_in_part3).into(),
        },
    ]
}
