//! Misconceptions about the global position, below the root and at it.

use super::{Position, wrong_in_part3};
use crate::Misconception;
use crate::fk::variants::position;

pub(super) fn misconceptions() -> Vec<Misconception> {
    [about_child_position(), about_root_position()].into_iter().flatten().collect()
}

fn about_child_position() -> Vec<Misconception> {
    const SEEN_IN: &[&str] = &["child", "branch", "moved"];
    vec![
        Misconception {
            id: "own_rotation",
            title: "You turn the local position by the joint's own rotation.",
            explanation: "A joint's own rotation turns what hangs on it, not the joint itself. The local position is \
                          measured along the parent's axes.",
            hint: "Whose rotation turns the bone that leads to this joint?",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: [position::own_rotation::<false> as Position, position::own_rotation::<true>]
                .map(wrong_in_part3)
                .into(),
        },
        Misconception {
            id: "own_transform",
            title: "You start from the joint's own position instead of the parent's.",
            explanation: "`pose[joint.id]` is this joint itself: its position is what you are about to compute, and its \
                          rotation turns what hangs on it.",
            hint: "`joint.parent` says which joint the bone starts at.",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: [position::own_transform::<false> as Position, position::own_transform::<true>]
                .map(wrong_in_part3)
                .into(),
        },
        Misconception {
            id: "offset_not_rotated",
            title: "You do not turn the local position.",
            explanation: "The local position is measured along the parent's axes. The sum needs it along the \
                          world's.",
            hint: "Part 2 gave you what turns the one into the other.",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: [position::not_rotated::<false> as Position, position::not_rotated::<true>]
                .map(wrong_in_part3)
                .into(),
        },
        Misconception {
            id: "parent_position_not_added",
            title: "You do not add the parent's position.",
            explanation: "The turned local position is the way from the parent to the joint. It begins where the \
                          parent is.",
            hint: "All your bones start at the origin. Where should each one start?",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: [position::parent_not_added::<false> as Position, position::parent_not_added::<true>]
                .map(wrong_in_part3)
                .into(),
        },
        Misconception {
            id: "parent_position_rotated",
            title: "You turn the parent's position too.",
            explanation: "The parent's position is already in the world's axes. Only the local position is turned.",
            hint: "Look at the parentheses: what does the quaternion work on?",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: [
                position::parent_rotated_too::<false> as Position,
                position::parent_rotated_too::<true>,
            ]
            .map(wrong_in_part3)
            .into(),
        },
        Misconception {
            id: "inverse_rotation",
            title: "You turn the local position the wrong way round.",
            explanation: "The parent's global rotation leads from its axes into the world's. Its inverse leads back.",
            hint: "If you write q v q⁻¹ out, which of the two stands on the left?",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: [position::inverse::<false> as Position, position::inverse::<true>]
                .map(wrong_in_part3)
                .into(),
        },
        Misconception {
            id: "one_sided_product",
            title: "You multiply the local position by the quaternion from one side only.",
            explanation: "A quaternion turns a vector from both sides: q v q⁻¹. With one side only the result is no \
                          rotated vector.",
            hint: "glam's `q * v` with a `Vec3` does both sides for you.",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: [
                position::from_the_left_only::<false> as Position,
                position::from_the_left_only::<true>,
                position::from_the_right_only::<false>,
                position::from_the_right_only::<true>,
            ]
            .map(wrong_in_part3)
            .into(),
        },
        Misconception {
            id: "previous_position",
            title: "You hang the joint on the one that comes before it instead of on its parent.",
            explanation: "In a chain they are the same. Where the skeleton branches, the joint before is the end of \
                          another branch.",
            hint: "`joint.parent` says which joint is the parent.",
            seen_in: SEEN_IN,
            costs: &["branch"],
            variants: vec![wrong_in_part3(position::previous)],
        },
        Misconception {
            id: "always_the_offset",
            title: "You use `joint.offset` instead of `local_position`.",
            explanation: "Most joints are always at their offset. Some have position channels, which move them.",
            hint: "The function is given `local_position`.",
            seen_in: SEEN_IN,
            costs: &["moved"],
            variants: vec![wrong_in_part3(position::always_offset)],
        },
    ]
}

fn about_root_position() -> Vec<Misconception> {
    const ROOT: &[&str] = &["root"];
    vec![Misconception {
        id: "root_stays",
        title: "Your root does not move with the frame.",
        explanation: "The frame says where the root is. Its offset, or the origin, is only where it would be without \
                      the frame.",
        hint: "What is `local_position` for a root?",
        seen_in: ROOT,
        costs: ROOT,
        variants: [position::root_at_offset as Position, position::root_at_origin].map(wrong_in_part3).into(),
    }]
}
