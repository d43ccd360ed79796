//! Misconceptions about the local quaternion: its rotation, and the cursor.

use super::{Local, wrong_in_part1};
use crate::Misconception;
use crate::fk::variants::{Exact, FourDecimals, Fraction, ThreeDecimals, ThreeRounded, TwoDecimals, local};

pub(super) fn misconceptions() -> Vec<Misconception> {
    [about_rotation(), about_cursor()].into_iter().flatten().collect()
}

/// The same mistake with each π.
macro_rules! with_each_pi {
    ($($function:ident $(::<_ $(, $rest:tt)*>)?),* $(,)?) => {
        [$(
            local::$function::<Exact $($(, $rest)*)?> as Local,
            local::$function::<TwoDecimals $($(, $rest)*)?>,
            local::$function::<ThreeDecimals $($(, $rest)*)?>,
            local::$function::<ThreeRounded $($(, $rest)*)?>,
            local::$function::<FourDecimals $($(, $rest)*)?>,
            local::$function::<Fraction $($(, $rest)*)?>,
        )*]
        .map(wrong_in_part1)
        .into()
    };
}

fn about_rotation() -> Vec<Misconception> {
    const SEEN_IN: &[&str] = &["single_axis", "rotation_orders", "big_angles"];
    const ORDERS: &[&str] = &["rotation_orders", "big_angles"];
    vec![
        Misconception {
            id: "degrees_as_radians",
            title: "You use degrees as if they were radians.",
            explanation: "The frame's angles are in degrees. Sine and cosine, and all of glam's functions, want radians.",
            hint: "What is a half turn in degrees, and what is it in radians?",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: vec![wrong_in_part1(local::degrees_as_radians)],
        },
        Misconception {
            id: "angle_not_halved",
            title: "You do not halve the angle.",
            explanation: "A quaternion works on a vector from both sides, q v q⁻¹, and so turns it twice. It holds the \
                          sine and cosine of half the angle.",
            hint: "Your joints turn twice as far as they should. Look at the angle inside sine and cosine.",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: with_each_pi![not_halved],
        },
        Misconception {
            id: "angles_negated",
            title: "You turn the wrong way round.",
            explanation: "The axes are right-handed: with the thumb along the axis, the fingers curl the way of a \
                          positive angle.",
            hint: "Look for a minus sign, an inverse or a conjugate that should not be there.",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: with_each_pi![negated],
        },
        Misconception {
            id: "order_reversed",
            title: "Your order is reversed.",
            explanation: "A motion's angles are intrinsic: each rotation is about axes that those before it have \
                          turned. Fixed axes would need the opposite order.",
            hint: "The first angle's quaternion stands leftmost. (glam's orders that end in `Ex` are about fixed axes.)",
            seen_in: SEEN_IN,
            costs: ORDERS,
            variants: with_each_pi![reversed],
        },
        Misconception {
            id: "always_one_order",
            title: "You treat all joints as if they had the same rotation order.",
            explanation: "Each joint has an order of its own, which says about which axis its first, second and third \
                          angle turns.",
            hint: "Use `joint.rotation_order`. Does your code use it for every joint?",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: with_each_pi![
                always_taken_as::<_, 0>,
                always_taken_as::<_, 1>,
                always_taken_as::<_, 2>,
                always_taken_as::<_, 3>,
                always_taken_as::<_, 4>,
                always_taken_as::<_, 5>,
                always_reversed::<_, 0>,
                always_reversed::<_, 5>,
            ],
        },
        Misconception {
            id: "angles_taken_as_xyz",
            title: "You mix up which angle belongs to which axis.",
            explanation: "The angles arrive in the joint's own order: with ZYX the first is about Z. You multiply in \
                          the right order, but with the wrong angles.",
            hint: "With the order ZYX, about which axis is the first of the three angles?",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: with_each_pi![taken_as_xyz, sorted_by_axis],
        },
        Misconception {
            id: "always_multiplied_in_one_order",
            title: "You multiply the three rotations of all joints in the same order.",
            explanation: "Each angle goes to the right axis, but the order of a product matters: multiply in the \
                          joint's order.",
            hint: "If you use `match`, does every order have an arm with a product of its own?",
            seen_in: SEEN_IN,
            costs: ORDERS,
            variants: with_each_pi![
                always_multiplied::<_, 0>,
                always_multiplied::<_, 1>,
                always_multiplied::<_, 2>,
                always_multiplied::<_, 3>,
                always_multiplied::<_, 4>,
                always_multiplied::<_, 5>,
            ],
        },
        Misconception {
            id: "w_first",
            title: "You put w first.",
            explanation: "Quaternions are written (x, y, z, w) here, as in glam: `Quat::from_xyzw`. Many books write w \
                          first.",
            hint: "What does your function give for three zero angles? It should be (0, 0, 0, 1).",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: with_each_pi![w_first, w_first_in_factors],
        },
        Misconception {
            id: "angles_packed",
            title: "You put the three angles into a quaternion as they are.",
            explanation: "The numbers of a quaternion are not angles: they are the axis times the sine of half the \
                          angle, and its cosine.",
            hint: "Make one quaternion for each of the three angles, and multiply them.",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: [
                local::packed::<0, false, false> as Local,
                local::packed::<0, false, true>,
                local::packed::<0, true, false>,
                local::packed::<0, true, true>,
                local::packed::<1, false, false>,
                local::packed::<1, false, true>,
                local::packed::<1, true, false>,
                local::packed::<1, true, true>,
            ]
            .map(wrong_in_part1)
            .into(),
        },
        Misconception {
            id: "half_angle_in_one",
            title: "You halve the angle for only one of sine and cosine.",
            explanation: "Both need the same half angle. Otherwise the quaternion's length is not 1, and it is no \
                          rotation.",
            hint: "Compare the angle inside sine with the one inside cosine, for each of the three axes.",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: with_each_pi![
                half_in_one::<_, true, 0>,
                half_in_one::<_, true, 1>,
                half_in_one::<_, true, 2>,
                half_in_one::<_, true, 3>,
                half_in_one::<_, false, 0>,
                half_in_one::<_, false, 1>,
                half_in_one::<_, false, 2>,
                half_in_one::<_, false, 3>,
            ],
        },
    ]
}

fn about_cursor() -> Vec<Misconception> {
    const CURSOR: &[&str] = &["cursor"];
    vec![
        Misconception {
            id: "cursor_moved_on_none",
            title: "You take angles for a joint that has none.",
            explanation: "With the order NONE (an End Site, for one) the frame holds no angles for the joint. What you \
                          take belongs to the next joint.",
            hint: "Ask for `joint.rotation_order` before you take anything.",
            seen_in: CURSOR,
            costs: CURSOR,
            variants: [
                local::moves_on_none as Local,
                local::turns_on_none,
                local::moves_on_none_but_not_on_end_sites,
            ]
            .map(wrong_in_part1)
            .into(),
        },
        Misconception {
            id: "cursor_not_moved",
            title: "You read the angles but do not move past them.",
            explanation: "There is one cursor for the whole frame. What a joint leaves, the next joint gets: all \
                          joints turn like the root.",
            hint: "`peek3` leaves the cursor where it is. What moves it?",
            seen_in: CURSOR,
            costs: CURSOR,
            variants: vec![wrong_in_part1(local::never_moves)],
        },
        Misconception {
            id: "cursor_one_short",
            title: "You take one angle too few.",
            explanation: "Every joint that rotates has three angles. The one that you leave becomes the next joint's \
                          first.",
            hint: "Count how often you take an angle for one joint.",
            seen_in: CURSOR,
            costs: CURSOR,
            variants: vec![wrong_in_part1(local::takes_two)],
        },
    ]
}
