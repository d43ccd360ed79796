//! Misconceptions about the global quaternion, below the root and at it.

use super::{Rotation, wrong_in_part2};
use crate::Misconception;
use crate::fk::variants::rotation;

pub(super) fn misconceptions() -> Vec<Misconception> {
    [about_child_rotation(), about_root_rotation()].into_iter().flatten().collect()
}

fn about_child_rotation() -> Vec<Misconception> {
    const SEEN_IN: &[&str] = &["child", "branch", "deep"];
    vec![
        Misconception {
            id: "local_times_parent",
            title: "You multiply in the wrong order: local times parent.",
            explanation: "In a product the right factor happens first. The joint turns in axes that its parent has \
                          turned, so the local rotation comes first, and the parent's after it.",
            hint: "Which of the two should stand on the left?",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: vec![wrong_in_part2(rotation::swapped)],
        },
        Misconception {
            id: "parent_only",
            title: "You return the parent's rotation and leave out the joint's own.",
            explanation: "A joint turns with its parent, and against it by its own local rotation.",
            hint: "Where do you use `local`?",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: vec![wrong_in_part2(rotation::parent_only)],
        },
        Misconception {
            id: "parent_twice",
            title: "You use the parent's rotation twice.",
            explanation: "The parent's global rotation is already the product of all rotations down to it. Use it once.",
            hint: "You need not walk up the skeleton: one product is enough.",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: [
                rotation::parent_twice as Rotation,
                rotation::parent_on_both_sides,
                rotation::parent_squared,
            ]
            .map(wrong_in_part2)
            .into(),
        },
        Misconception {
            id: "sum_of_rotations",
            title: "You add or blend the two quaternions.",
            explanation: "One rotation after another is the product of their quaternions. Their sum, made a unit \
                          quaternion, lies halfway between them.",
            hint: "Which operation on quaternions puts one rotation after another?",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: [rotation::sum as Rotation, rotation::sum_normalized, rotation::blend]
                .map(wrong_in_part2)
                .into(),
        },
        Misconception {
            id: "parent_inverted",
            title: "You use the inverse of the parent's rotation.",
            explanation: "The inverse leads from the world's axes into the parent's. You want to go the other way.",
            hint: "Leave the inverse (or the conjugate) out, and ask again which factor stands on the left.",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: [rotation::inverse as Rotation, rotation::inverse_behind].map(wrong_in_part2).into(),
        },
        Misconception {
            id: "previous_rotation",
            title: "You use the joint that comes before this one as if it were its parent.",
            explanation: "In a chain they are the same. Where the skeleton branches, the joint before is the end of \
                          another branch.",
            hint: "`joint.parent` says which joint is the parent.",
            seen_in: SEEN_IN,
            costs: &["branch"],
            variants: vec![wrong_in_part2(rotation::previous)],
        },
    ]
}

fn about_root_rotation() -> Vec<Misconception> {
    const ROOT: &[&str] = &["root"];
    vec![
        Misconception {
            id: "root_forgotten",
            title: "You do not turn the root.",
            explanation: "A root has no parent, but it has a rotation of its own, and all other joints turn with it.",
            hint: "What is left of the product when there is no parent?",
            seen_in: ROOT,
            costs: ROOT,
            variants: vec![wrong_in_part2(rotation::root_forgotten)],
        },
        Misconception {
            id: "root_twice",
            title: "You use the root's rotation twice.",
            explanation: "A root has no parent, so there is nothing to multiply its rotation by.",
            hint: "What do you multiply by when there is no parent?",
            seen_in: ROOT,
            costs: ROOT,
            variants: vec![wrong_in_part2(rotation::root_twice)],
        },
    ]
}
