//! Misconceptions about how a bone is turned.
//!
//! In the check `angles` the bones have the axes of their parents, and in the check `rest` they turn about at most one
//! of their own. So what is wrong with the one shows in one check, and what is wrong with the other in the other, even if
//! both are wrong.

use super::{Rotation, wrong_in_part1};
use crate::Misconception;
use crate::acclaim::variants::rotation;

const ALL: &[&str] = &["root", "angles", "rest"];
const ROOT: &[&str] = &["root"];
const ANGLES: &[&str] = &["angles"];
const REST: &[&str] = &["rest"];
const ROOT_AND_ANGLES: &[&str] = &["root", "angles"];
/// Where there is a parent.
const PARENT: &[&str] = &["angles", "rest"];

pub(super) fn misconceptions() -> Vec<Misconception> {
    let all = [about_rest(), about_axes_of_the_world(), about_the_parent(), about_order(), about_angles()];
    all.into_iter().flatten().chain(about_the_root()).collect()
}

/// The axes at rest.
fn about_rest() -> Vec<Misconception> {
    const ROOT_AND_REST: &[&str] = &["root", "rest"];
    vec![
        Misconception {
            id: "rest_left_out",
            title: "You leave out how the bone's axes are turned at rest.",
            explanation: "A bone's own axes are turned against its parent's even if no angle turns it. The angles are \
                          about these axes, and not about the parent's.",
            hint: "With three zero angles your function returns the parent's rotation. Whose axes are these?",
            seen_in: REST,
            costs: ROOT_AND_REST,
            variants: vec![wrong_in_part1(rotation::rest_left_out)],
        },
        Misconception {
            id: "rest_after_angles",
            title: "You put the bone's axes at rest and its angles in the wrong order.",
            explanation: "The angles are about the bone's own axes. First these have to be where they are at rest, \
                          and only then can the bone turn about them. Your product turns about the parent's axes.",
            hint: "Read the product from the left: at whose axes are you after each factor?",
            seen_in: REST,
            costs: ROOT_AND_REST,
            variants: vec![wrong_in_part1(rotation::rest_after_angles)],
        },
        Misconception {
            id: "rest_before_parent",
            title: "You put the bone's axes at rest in front of the parent's rotation.",
            explanation: "They are turned against the parent's axes. So the parent's come first on the way from the \
                          world to the bone. Your product turns the bone about the world's axes.",
            hint: "Read the product from the left: the world, then whose axes?",
            seen_in: REST,
            costs: REST,
            variants: vec![wrong_in_part1(rotation::rest_before_parent)],
        },
        Misconception {
            id: "rest_inverted",
            title: "You use the axes at rest the wrong way round.",
            explanation: "`rot_parent_current` leads from the parent's axes to the bone's. Its inverse leads back.",
            hint: "Leave the inverse (or the conjugate) out.",
            seen_in: REST,
            costs: ROOT_AND_REST,
            variants: vec![wrong_in_part1(rotation::rest_inverted)],
        },
        Misconception {
            id: "rest_taken_back",
            title: "You turn back from the bone's axes at rest at the end.",
            explanation: "Your product ends at the parent's axes again. What is asked for is the rotation that turns the \
                          bone's own axes into the world's.",
            hint: "With three zero angles your function returns the parent's rotation. Whose axes are these?",
            seen_in: REST,
            costs: ROOT_AND_REST,
            variants: vec![wrong_in_part1(rotation::rest_taken_back)],
        },
        Misconception {
            id: "fixed_bones",
            title: "You treat bones without degrees of freedom in another way than the others.",
            explanation: "A bone that does not turn against its parent has axes of its own all the same, and turns with its \
                          parent. Its three angles are zero.",
            hint: "What does your formula give for three zero angles? Is a special case needed?",
            seen_in: REST,
            costs: REST,
            variants: [rotation::fixed_is_its_parent as Rotation, rotation::fixed_is_not_turned]
                .map(wrong_in_part1)
                .into(),
        },
    ]
}

/// Axes against the world's, where those against the parent's are wanted.
fn about_axes_of_the_world() -> Vec<Misconception> {
    vec![
        Misconception {
            id: "axis_rotation",
            title: "You use `axis_rotation` in the place of `rot_parent_current`.",
            explanation: "`axis_rotation` leads from the world's axes to the bone's, in the rest pose. The parent's \
                          rotation has already led away from the world's axes, so that the way goes on from the parent's.",
            hint: "For a root the two are the same. Which bones show the difference?",
            seen_in: REST,
            costs: PARENT,
            variants: vec![wrong_in_part1(rotation::world_axes)],
        },
        Misconception {
            id: "against_rest_pose",
            title: "You return how the bone is turned against its rest pose.",
            explanation: "With the inverse of `axis_rotation` at the end, your rotation turns what is written in the world's \
                          axes. That is a way to do it, but not the one asked for here: the result should turn the bone's own \
                          axes into the world's, and the parent's rotation that you are given does that too.",
            hint: "Part 2 turns `local_direction`, which is written in the bone's own axes.",
            seen_in: PARENT,
            costs: ALL,
            variants: [rotation::against_rest_pose as Rotation, rotation::conjugated]
                .map(wrong_in_part1)
                .into(),
        },
    ]
}

fn about_the_parent() -> Vec<Misconception> {
    vec![
        Misconception {
            id: "parent_left_out",
            title: "You leave out the parent's rotation.",
            explanation: "A bone turns with its parent. Its own rotation begins at the parent's axes, wherever these have been \
                          turned to.",
            hint: "Where do you use `parent`?",
            seen_in: PARENT,
            costs: PARENT,
            variants: [rotation::parent_left_out as Rotation, rotation::world_axes_alone]
                .map(wrong_in_part1)
                .into(),
        },
        Misconception {
            id: "angles_only",
            title: "You use nothing but the angles.",
            explanation: "The angles turn the bone about its own axes. Where these are depends on the parent, which is turned in \
                          the world, and on how the bone's axes are turned against the parent's at rest.",
            hint: "Starting from the world's axes: which two steps come before the angles?",
            seen_in: ALL,
            costs: ALL,
            variants: vec![wrong_in_part1(rotation::angles_alone)],
        },
        Misconception {
            id: "own_times_parent",
            title: "You multiply in the wrong order: own times parent.",
            explanation: "In a product the right factor happens first. The bone turns about axes that its parent has turned, so \
                          its own rotation comes first, and the parent's after it.",
            hint: "Which of the two should stand on the left?",
            seen_in: PARENT,
            costs: PARENT,
            variants: vec![wrong_in_part1(rotation::own_times_parent)],
        },
        Misconception {
            id: "angles_times_parent",
            title: "You multiply the angles by the parent's rotation in the wrong order, and leave out the axes at rest.",
            explanation: "These are two mistakes. In a product the right factor happens first, and the bone's own angles come before \
                          what its parent does. And a bone's axes are turned against its parent's even if no angle turns it.",
            hint: "There are three rotations to be multiplied. Which one is missing, and which happens first?",
            seen_in: PARENT,
            costs: ALL,
            variants: vec![wrong_in_part1(rotation::angles_times_parent)],
        },
        Misconception {
            id: "reversed",
            title: "You multiply in the reverse order.",
            explanation: "In a product the right factor happens first. Of the parent's rotation, the axes at rest and the angles, \
                          the angles happen first.",
            hint: "Try it with a bone of which only one of the three is turned, and then with two of them.",
            seen_in: ALL,
            costs: ALL,
            variants: [rotation::reversed as Rotation, rotation::angles_in_front].map(wrong_in_part1).into(),
        },
        Misconception {
            id: "parent_inverted",
            title: "You use the inverse of the parent's rotation.",
            explanation: "The inverse leads from the world's axes into the parent's. You want to go the other way.",
            hint: "Leave the inverse (or the conjugate) out, and ask again which factor stands on the left.",
            seen_in: ANGLES,
            costs: PARENT,
            variants: vec![wrong_in_part1(rotation::parent_inverted)],
        },
        Misconception {
            id: "inverse",
            title: "You return the inverse of the right rotation.",
            explanation: "It leads from the world's axes into the bone's own. What is asked for turns the bone's own axes into \
                          the world's.",
            hint: "Try the example in the comment: where does your rotation take the X axis?",
            seen_in: ANGLES,
            costs: ALL,
            variants: vec![wrong_in_part1(rotation::inverse)],
        },
    ]
}

/// In which order the three rotations are multiplied, and about which axes they are.
fn about_order() -> Vec<Misconception> {
    use rotation::ordered;
    /// Every order of multiplication, for one wrong order of taking the angles.
    macro_rules! taken {
        ($($taken:literal)*) => {
            [$(
                ordered::<0, $taken> as Rotation,
                ordered::<1, $taken>,
                ordered::<2, $taken>,
                ordered::<3, $taken>,
                ordered::<4, $taken>,
                ordered::<5, $taken>,
            )*]
        };
    }
    vec![
        Misconception {
            id: "xyz_order",
            title: "You multiply the three rotations in the order X, Y, Z.",
            explanation: "Then Z happens first. In Acclaim files X does, and in a product the right factor happens first. In BVH \
                          files it is the other way round: there the axis that is listed first is the factor on the left.",
            hint: "Which of the three factors should stand on the right?",
            seen_in: ANGLES,
            costs: ROOT_AND_ANGLES,
            variants: vec![wrong_in_part1(ordered::<0, 0>)],
        },
        Misconception {
            id: "other_order",
            title: "You multiply the three rotations in another order than Z, Y, X.",
            explanation: "Rotations do not commute: about the same three axes and by the same angles, another order is another \
                          rotation. In these files X happens first, and in a product the right factor does.",
            hint: "Write down which rotation happens first, second and third in your product.",
            seen_in: ANGLES,
            costs: ROOT_AND_ANGLES,
            variants: [ordered::<1, 0> as Rotation, ordered::<2, 0>, ordered::<3, 0>, ordered::<4, 0>]
                .map(wrong_in_part1)
                .into(),
        },
        Misconception {
            id: "wrong_axes",
            title: "You mix up which angle belongs to which axis.",
            explanation: "The three angles are about the bone's X, Y and Z axis, in this order. Only the rotations are multiplied in \
                          another one.",
            hint: "Which of the three numbers does each of your rotations get?",
            seen_in: ANGLES,
            costs: ALL,
            variants: taken![1 2 3 4 5].map(wrong_in_part1).into(),
        },
    ]
}

/// What is made of each angle.
fn about_angles() -> Vec<Misconception> {
    use rotation::ordered_radians;
    vec![
        Misconception {
            id: "angles_left_out",
            title: "You leave out the angles.",
            explanation: "Your bone stays as it is at rest. The posture's angles turn it on from there.",
            hint: "Where do you use `angles`?",
            seen_in: ANGLES,
            costs: ALL,
            variants: vec![wrong_in_part1(rotation::angles_left_out)],
        },
        Misconception {
            id: "degrees_and_radians",
            title: "You mix up degrees and radians.",
            explanation: "The file's angles are in degrees. Sine and cosine, and glam's functions, take radians.",
            hint: "How often is each angle converted before it is used, and in which direction?",
            seen_in: ANGLES,
            costs: ALL,
            variants: [
                rotation::degrees_as_radians as Rotation,
                rotation::to_degrees,
                rotation::to_radians_twice,
            ]
            .map(wrong_in_part1)
            .into(),
        },
        Misconception {
            id: "degrees_and_order",
            title: "You mix up degrees and radians, and the order of the three rotations too.",
            explanation: "These are two mistakes. The file's angles are in degrees, and glam's functions take radians. And in \
                          Acclaim files the rotation about X happens first: in a product the right factor does.",
            hint: "Begin with the unit. Then ask which of your three factors stands on the right, and which angle it gets.",
            seen_in: ANGLES,
            costs: ALL,
            variants: [
                ordered_radians::<0, 0> as Rotation,
                ordered_radians::<1, 0>,
                ordered_radians::<2, 0>,
                ordered_radians::<3, 0>,
                ordered_radians::<4, 0>,
                // The right order, and the angles in theirs.
                ordered_radians::<5, 5>,
            ]
            .map(wrong_in_part1)
            .into(),
        },
        Misconception {
            id: "angle_not_halved",
            title: "You do not halve the angle.",
            explanation: "The quaternion of a turn holds the sine and the cosine of half the angle. With the whole one, the bone \
                          turns twice as far.",
            hint: "Which quaternion stands for a turn by 180 degrees?",
            seen_in: ANGLES,
            costs: ALL,
            variants: vec![wrong_in_part1(rotation::not_halved)],
        },
        Misconception {
            id: "angles_negated",
            title: "You turn the wrong way round.",
            explanation: "Positive angles turn counter-clockwise when the axis points at you.",
            hint: "Look for a minus sign, an inverse or a conjugate.",
            seen_in: ANGLES,
            costs: ALL,
            variants: [rotation::angles_negated as Rotation, rotation::angles_inverted]
                .map(wrong_in_part1)
                .into(),
        },
        Misconception {
            id: "rotation_vector",
            title: "You take the three angles for the axis of one rotation.",
            explanation: "An axis times an angle are three numbers too, and for a turn about X, Y or Z alone they are the three \
                          angles. Where two angles are not zero, they mean another rotation.",
            hint: "The angles are three rotations, one after the other. How many does yours make of them?",
            seen_in: ANGLES,
            costs: ROOT_AND_ANGLES,
            variants: vec![wrong_in_part1(rotation::rotation_vector)],
        },
        Misconception {
            id: "angles_packed",
            title: "You put the three angles into a quaternion as they are.",
            explanation: "The numbers of a quaternion are not angles: they are the axis times the sine of half the angle, and its \
                          cosine.",
            hint: "Make one quaternion for each of the three angles, and multiply them.",
            seen_in: ANGLES,
            costs: ALL,
            variants: [
                rotation::packed::<0, false> as Rotation,
                rotation::packed::<0, true>,
                rotation::packed::<1, false>,
                rotation::packed::<1, true>,
                rotation::packed_normalized::<0, false>,
                rotation::packed_normalized::<1, false>,
                rotation::packed_normalized::<1, true>,
            ]
            .map(wrong_in_part1)
            .into(),
        },
    ]
}

fn about_the_root() -> Vec<Misconception> {
    vec![
        Misconception {
            id: "root_axes_left_out",
            title: "You leave out the root's own axes.",
            explanation: "The root can be turned at rest too: its file calls that the orientation. Its parent is the world, which is \
                          not turned.",
            hint: "What does the formula give for a root? Is a special case needed?",
            seen_in: ALL,
            costs: ROOT,
            variants: vec![wrong_in_part1(rotation::root_axes_left_out)],
        },
        Misconception {
            id: "root_not_turned",
            title: "You do not turn the root by its angles.",
            explanation: "The root has no length, but it turns, and all that hangs on it turns with it.",
            hint: "What does the formula give for a root? Is a special case needed?",
            seen_in: ALL,
            costs: ROOT,
            variants: [rotation::root_is_not_turned as Rotation, rotation::root_keeps_its_axes]
                .map(wrong_in_part1)
                .into(),
        },
    ]
}
