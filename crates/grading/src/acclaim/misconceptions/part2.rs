//! Misconceptions about where a bone starts and ends.

use super::{Ends, wrong_in_part2};
use crate::Misconception;
use crate::acclaim::variants::ends;

const ALL: &[&str] = &["start", "end", "translation"];
const START: &[&str] = &["start"];
const END: &[&str] = &["end"];
/// The root's place shows in both.
const START_AND_END: &[&str] = &["start", "end"];
/// Whatever is wrong with the end shows in both.
const ENDS: &[&str] = &["end", "translation"];
const TRANSLATION: &[&str] = &["translation"];
/// A translation that moves something else shows in both.
const MOVED: &[&str] = &["start", "translation"];

pub(super) fn misconceptions() -> Vec<Misconception> {
    [about_the_way(), about_turning(), about_the_parent(), about_the_translation(), about_the_start()]
        .into_iter()
        .flatten()
        .collect()
}

/// The way from the start to the end.
fn about_the_way() -> Vec<Misconception> {
    vec![
        Misconception {
            id: "length_left_out",
            title: "You do not apply the length.",
            explanation: "A direction has the length 1, so all your bones are equally long: 1 in the unit of the file.",
            hint: "Which field of the bone says how far it is from its start to its end?",
            seen_in: END,
            costs: ENDS,
            variants: vec![wrong_in_part2(ends::length_left_out)],
        },
        Misconception {
            id: "length_twice",
            title: "You apply the length twice.",
            explanation: "A direction has the length 1, and times the bone's length it is as long as the bone. Times the length once \
                          more, long bones become far too long.",
            hint: "In how many places of your function is the bone's length, and is one of them inside another?",
            seen_in: END,
            costs: ENDS,
            variants: vec![wrong_in_part2(ends::length_twice)],
        },
        Misconception {
            id: "bone_left_out",
            title: "You leave out the way from the bone's start to its end.",
            explanation: "Without it every bone ends where it starts, and the figure is a point.",
            hint: "Where do you use the bone's length and direction?",
            seen_in: ENDS,
            costs: ENDS,
            variants: vec![wrong_in_part2(ends::bone_left_out)],
        },
        Misconception {
            id: "along_an_axis",
            title: "You let every bone point along the same one of its axes.",
            explanation: "In other programs a bone lies along one of its own axes. Here the axes of a bone can be turned anyhow, and \
                          the file says in which direction it points.",
            hint: "Which field of the bone holds a direction?",
            seen_in: END,
            costs: ENDS,
            variants: [ends::along_an_axis::<0> as Ends, ends::along_an_axis::<1>, ends::along_an_axis::<2>]
                .map(wrong_in_part2)
                .into(),
        },
        Misconception {
            id: "backwards",
            title: "You go along the bone backwards.",
            explanation: "The direction leads from the bone's start to its end. Your bones end on the other side of where they start.",
            hint: "Look for a minus sign in front of the bone's length or direction.",
            seen_in: END,
            costs: ENDS,
            variants: vec![wrong_in_part2(ends::backwards)],
        },
    ]
}

fn about_turning() -> Vec<Misconception> {
    vec![
        Misconception {
            id: "world_direction",
            title: "You turn the direction that is already in the world's axes.",
            explanation: "The rotation from part 1 turns what is written in the bone's own axes. `direction` is written in the \
                          world's, as the bone lies at rest.",
            hint: "The bone has two fields for its direction. In whose axes is each?",
            seen_in: END,
            costs: ENDS,
            variants: vec![wrong_in_part2(ends::world_direction)],
        },
        Misconception {
            id: "rest_again",
            title: "You turn the direction by the bone's axes at rest once more.",
            explanation: "They are in the rotation that comes from part 1 already: it leads all the way from the bone's own axes into \
                          the world's.",
            hint: "From whose axes into whose does each of the rotations lead that you use here?",
            seen_in: END,
            costs: ENDS,
            variants: [ends::rest_again as Ends, ends::rest_in_front].map(wrong_in_part2).into(),
        },
        Misconception {
            id: "not_rotated",
            title: "You do not turn the direction.",
            explanation: "A direction in the bone's own axes says nothing yet about where the bone points in the world. And that at \
                          rest holds only as long as nothing has moved.",
            hint: "Part 1 gave you what turns the bone's own axes into the world's.",
            seen_in: END,
            costs: ENDS,
            variants: [ends::not_rotated as Ends, ends::as_at_rest].map(wrong_in_part2).into(),
        },
        Misconception {
            id: "inverse_rotation",
            title: "You turn the direction the wrong way round.",
            explanation: "The rotation leads from the bone's own axes into the world's. Its inverse leads back.",
            hint: "If you write q v q⁻¹ out, which of the two stands on the left?",
            seen_in: END,
            costs: ENDS,
            variants: vec![wrong_in_part2(ends::inverse)],
        },
        Misconception {
            id: "one_sided_product",
            title: "You multiply the direction by the quaternion from one side only.",
            explanation: "A quaternion turns a vector from both sides: q v q⁻¹. With one side only the result is no turned vector.",
            hint: "glam's `q * v` with a `Vec3` does both sides for you.",
            seen_in: END,
            costs: ENDS,
            variants: [ends::from_the_left_only as Ends, ends::from_the_right_only]
                .map(wrong_in_part2)
                .into(),
        },
    ]
}

fn about_the_parent() -> Vec<Misconception> {
    vec![
        Misconception {
            id: "parent_end_not_added",
            title: "You do not add the parent's end to the bone's.",
            explanation: "The turned direction, times the length, is the way from the bone's start to its end. It begins where the \
                          parent ends, and not at the origin.",
            hint: "What is the way from the origin of the world to the end of the bone made of?",
            seen_in: ENDS,
            costs: ENDS,
            variants: vec![wrong_in_part2(ends::parent_end_not_added)],
        },
        Misconception {
            id: "parent_end_rotated",
            title: "You turn the parent's end too.",
            explanation: "The parent's end is already in the world. Only the direction is turned.",
            hint: "Look at the parentheses: what does the quaternion work on?",
            seen_in: END,
            costs: ENDS,
            variants: [ends::parent_end_rotated as Ends, ends::all_rotated].map(wrong_in_part2).into(),
        },
    ]
}

fn about_the_translation() -> Vec<Misconception> {
    vec![
        Misconception {
            id: "translation_left_out",
            title: "You do not add the translation.",
            explanation: "It is zero for nearly all bones, but where a file has one, it moves the bone's end.",
            hint: "Where do you use `translation`?",
            seen_in: MOVED,
            costs: TRANSLATION,
            variants: vec![wrong_in_part2(ends::translation_left_out)],
        },
        Misconception {
            id: "translation_rotated",
            title: "You turn the translation too.",
            explanation: "It moves the bone's end along the world's axes, so there is nothing to turn.",
            hint: "Look at the parentheses: what does the quaternion work on?",
            seen_in: TRANSLATION,
            costs: TRANSLATION,
            variants: vec![wrong_in_part2(ends::translation_rotated)],
        },
        Misconception {
            id: "translation_subtracted",
            title: "You take the translation away instead of adding it.",
            explanation: "A translation of (1, 0, 0) moves the bone's end by 1 along the world's X axis, and not the other way.",
            hint: "Look at the sign in front of it.",
            seen_in: TRANSLATION,
            costs: TRANSLATION,
            variants: vec![wrong_in_part2(ends::translation_subtracted)],
        },
        Misconception {
            id: "start_moved",
            title: "You let the translation move the bone's start too.",
            explanation: "It moves the end. The start stays at the parent's end, whatever the translation is.",
            hint: "To which of your two results do you add it?",
            seen_in: MOVED,
            costs: START,
            variants: vec![wrong_in_part2(ends::start_moved)],
        },
        Misconception {
            id: "start_moved_instead",
            title: "You let the translation move the bone's start instead of its end.",
            explanation: "The start stays at the parent's end, whatever the translation is. It is the end that moves.",
            hint: "To which of your two results do you add it?",
            seen_in: MOVED,
            costs: MOVED,
            variants: vec![wrong_in_part2(ends::start_moved_instead)],
        },
    ]
}

fn about_the_start() -> Vec<Misconception> {
    vec![
        Misconception {
            id: "start_at_origin",
            title: "You let the bone start at the origin.",
            explanation: "A bone starts where its parent ends. Otherwise the figure falls apart.",
            hint: "Which of your inputs says where the parent ends?",
            seen_in: START,
            costs: START,
            variants: vec![wrong_in_part2(ends::start_at_origin)],
        },
        Misconception {
            id: "start_at_translation",
            title: "You let the bone start at its translation.",
            explanation: "The translation is no place. It says how far the bone's end is moved, which is not at all for nearly all \
                          bones. A bone starts where its parent ends.",
            hint: "Which of your inputs says where the parent ends?",
            seen_in: START,
            costs: START,
            variants: vec![wrong_in_part2(ends::start_at_translation)],
        },
        Misconception {
            id: "root_by_itself",
            title: "You treat the root in another way than the other bones.",
            explanation: "The root has no parent, but where the figure is comes in as `parent_end` all the same. The root's \
                          translation is zero: a root that is put there stays at the origin, and the figure with it.",
            hint: "What does your formula for the other bones give for the root? Is a special case needed?",
            seen_in: START_AND_END,
            costs: START_AND_END,
            variants: vec![wrong_in_part2(ends::root_at_translation)],
        },
        Misconception {
            id: "ends_exchanged",
            title: "You return the end in the place of the start.",
            explanation: "The two results are the start and the end, in this order. Your first one is the end.",
            hint: "Which of the two numbers in your tuple is the parent's end?",
            seen_in: ALL,
            costs: ALL,
            variants: vec![wrong_in_part2(ends::exchanged)],
        },
    ]
}
