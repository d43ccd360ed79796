//! Misconceptions about what is between two postures.

use super::ways;
use crate::Misconception;
use crate::time_warp::variants::blend::{
    ArrowOfAngles, AsTheyCome, Backwards, ComponentsAsAngles, DegreesAndRadians, Exchanged, FirstAngles,
    NearerAngles, OnlyTheRootMoves, Ordered, OrderedDegrees, PackedAndUnpacked, PackedForSlerp,
    RotationVector, SecondAngles, ShorterAngles, StraightAngles, StraightLine, TranslationsOnAnArc,
    TranslationsStay,
};

const ALL: &[&str] = &["translations", "one_axis", "all_axes", "wrap"];
const ROTATIONS: &[&str] = &["one_axis", "all_axes", "wrap"];
const TRANSLATIONS: &[&str] = &["translations"];

pub(super) fn misconceptions() -> Vec<Misconception> {
    let all = [about_angles(), about_components(), about_conversion(), about_slerp(), about_the_ends()];
    all.into_iter().flatten().collect()
}

fn about_angles() -> Vec<Misconception> {
    vec![
        Misconception {
            id: "angles_number_by_number",
            title: "You interpolate the three angles number by number.",
            explanation: "About one axis that is the same. Where several angles change, it leads along another way and not at an \
                          even speed, and from 170 to −170 it goes round the long way.",
            hint: "The text of the function names three steps. Which of them does yours do?",
            seen_in: ROTATIONS,
            costs: &["all_axes", "wrap"],
            variants: ways![StraightAngles],
        },
        Misconception {
            id: "each_angle_the_shorter_way",
            title: "You interpolate the three angles one by one, each the shorter way round.",
            explanation: "You have thought of ±180. But three angles that change evenly do not turn a bone evenly, nor about one \
                          axis.",
            hint: "The text of the function names three steps. Which of them does yours do?",
            seen_in: ROTATIONS,
            costs: &["all_axes"],
            variants: ways![ShorterAngles],
        },
        Misconception {
            id: "angles_as_an_arrow",
            title: "You interpolate three angles as if they were an arrow.",
            explanation: "A `Vec3` has a `slerp` too: it turns an arrow from one direction into the other. Three angles are no arrow, \
                          and where the bone points has nothing to do with where that one does.",
            hint: "The text of the function names three steps. Which of them does yours do?",
            seen_in: ROTATIONS,
            costs: ROTATIONS,
            variants: ways![ArrowOfAngles],
        },
        Misconception {
            id: "angles_stay",
            title: "You do not blend the angles.",
            explanation: "Yours are those of one of the two postures, so that every bone jumps from one to the next.",
            hint: "From what do you make the angles that you return?",
            seen_in: ROTATIONS,
            costs: ROTATIONS,
            variants: ways![FirstAngles, SecondAngles, NearerAngles],
        },
    ]
}

fn about_components() -> Vec<Misconception> {
    vec![
        Misconception {
            id: "angles_in_a_quaternion",
            title: "You put three angles into a quaternion as they are.",
            explanation: "x, y and z of a quaternion are an axis times the sine of half the angle. Three angles in their place are \
                          no rotation. If you take them out again afterwards, what you see is nearly a straight line from \
                          number to number: it looks right for as long as the postures are close together.",
            hint: "Which function of glam makes a quaternion of three angles, and which one makes angles of a quaternion?",
            seen_in: ROTATIONS,
            costs: ROTATIONS,
            variants: ways![
                PackedAndUnpacked<0, false, false, false>, PackedAndUnpacked<0, false, false, true>,
                PackedAndUnpacked<0, false, true, false>,
                PackedAndUnpacked<0, true, false, false>, PackedAndUnpacked<0, true, false, true>,
                PackedAndUnpacked<0, true, true, false>,
                PackedAndUnpacked<1, false, false, false>, PackedAndUnpacked<1, false, false, true>,
                PackedAndUnpacked<1, false, true, false>,
                PackedAndUnpacked<1, true, false, false>, PackedAndUnpacked<1, true, false, true>,
                PackedAndUnpacked<1, true, true, false>,
                PackedForSlerp<0, false, false>, PackedForSlerp<0, false, true>,
                PackedForSlerp<0, true, false>, PackedForSlerp<0, true, true>,
                PackedForSlerp<1, false, false>, PackedForSlerp<1, false, true>,
                PackedForSlerp<1, true, false>, PackedForSlerp<1, true, true>,
            ],
        },
        Misconception {
            id: "components_as_angles",
            title: "You take the numbers of a quaternion for angles.",
            explanation: "You make quaternions of the angles and interpolate them, as you should. But x, y and z of the result lie \
                          between −1 and 1. Taken for degrees they hardly turn the bone.",
            hint: "One step is missing at the end. Which function does the opposite of `Quat::from_euler`?",
            seen_in: ROTATIONS,
            costs: ROTATIONS,
            variants: ways![ComponentsAsAngles<0, false>, ComponentsAsAngles<0, true>, ComponentsAsAngles<1, false>, ComponentsAsAngles<1, true>, ComponentsAsAngles<2, false>, ComponentsAsAngles<2, true>, ComponentsAsAngles<3, false>, ComponentsAsAngles<3, true>],
        },
        Misconception {
            id: "rotation_vector",
            title: "You take three angles for the axis of one rotation.",
            explanation: "An axis times an angle are three numbers too, and for a turn about X, Y or Z alone they are the three \
                          angles. Where two angles are not zero, they mean another rotation.",
            hint: "`from_euler` and `to_euler` belong together. Do you use both?",
            seen_in: ROTATIONS,
            costs: ROTATIONS,
            variants: ways![RotationVector<true, true>, RotationVector<true, false>, RotationVector<false, true>],
        },
    ]
}

fn about_conversion() -> Vec<Misconception> {
    vec![
        Misconception {
            id: "opposite_order",
            title: "You multiply the rotations about the three axes in the opposite order.",
            explanation: "The angles mean Rz Ry Rx, and you take them for Rx Ry Rz. As you do so on both ways, turns about one axis \
                          come out right all the same. Where several angles change, the bone takes another way.",
            hint: "Which `EulerRot` stands for Rz Ry Rx, and in which order does it take the angles?",
            seen_in: ROTATIONS,
            costs: &["all_axes"],
            variants: ways![Ordered<0, 0>],
        },
        Misconception {
            id: "other_order",
            title: "You multiply the rotations about the three axes in another order.",
            explanation: "The angles mean Rz Ry Rx. With another order on both ways, small turns about one axis come out right all \
                          the same. Where several angles change, the bone takes another way, and angles beyond a right angle \
                          become other ones.",
            hint: "Which `EulerRot` stands for Rz Ry Rx, and in which order does it take the angles?",
            seen_in: ROTATIONS,
            costs: &["all_axes", "wrap"],
            variants: ways![Ordered<1, 1>, Ordered<2, 2>, Ordered<3, 3>, Ordered<4, 4>],
        },
        Misconception {
            id: "two_orders",
            title: "You make quaternions in one order and angles in another.",
            explanation: "The angles mean Rz Ry Rx, when you make a quaternion of them and when you make them of a quaternion. \
                          Otherwise not even a posture that is blended with itself stays what it is.",
            hint: "Compare the `EulerRot` in your two calls.",
            seen_in: ROTATIONS,
            costs: ROTATIONS,
            variants: ways![
                Ordered<5, 0>, Ordered<5, 1>, Ordered<5, 2>, Ordered<5, 3>, Ordered<5, 4>,
                Ordered<0, 5>, Ordered<1, 5>, Ordered<2, 5>, Ordered<3, 5>, Ordered<4, 5>,
            ],
        },
        Misconception {
            id: "x_and_z_exchanged",
            title: "You mix up which angle is about which axis.",
            explanation: "A posture holds the angles about X, Y and Z, in this order. `EulerRot::ZYX` takes and gives them about Z, \
                          Y and X.",
            hint: "Blend a turn about X with itself. About which axis does your result turn?",
            seen_in: ROTATIONS,
            costs: ROTATIONS,
            variants: ways![Exchanged<true>, Exchanged<false>],
        },
        Misconception {
            id: "degrees_and_radians",
            title: "You mix up degrees and radians.",
            explanation: "The angles of a posture are in degrees, those that come in and those that go out. glam's functions \
                          take and give radians.",
            hint: "What is a half turn in degrees, and what is it in radians? Follow it through your function.",
            seen_in: ROTATIONS,
            costs: ROTATIONS,
            variants: ways![
                DegreesAndRadians<true, false>,
                DegreesAndRadians<false, true>,
                DegreesAndRadians<true, true>,
            ],
        },
        Misconception {
            id: "degrees_and_order",
            title: "You mix up degrees and radians, and the order of the three rotations too.",
            explanation: "These are two mistakes. The angles of a posture are in degrees, and glam's functions take and give \
                          radians. And the angles mean Rz Ry Rx.",
            hint: "Begin with the unit, on both ways. Then ask which `EulerRot` stands for Rz Ry Rx, and in which order it takes the \
                   angles.",
            seen_in: ROTATIONS,
            costs: ROTATIONS,
            variants: ways![
                OrderedDegrees<0, true, true>, OrderedDegrees<0, true, false>, OrderedDegrees<0, false, true>,
                OrderedDegrees<1, true, true>, OrderedDegrees<2, true, true>,
                OrderedDegrees<3, true, true>, OrderedDegrees<4, true, true>,
            ],
        },
    ]
}

fn about_slerp() -> Vec<Misconception> {
    vec![
        Misconception {
            id: "no_shorter_way",
            title: "You do not take the shorter way round.",
            explanation: "q and −q are the same rotation, but from a third one the way to one of them is longer. Angles on both \
                          sides of ±180 often give the one that is far away.",
            hint: "What does the sign of the dot product say? glam's `slerp` looks at it; `slerp_long` does not.",
            seen_in: ROTATIONS,
            costs: &["wrap"],
            variants: ways![AsTheyCome],
        },
        Misconception {
            id: "uneven_speed",
            title: "You go along a straight line and not along the arc.",
            explanation: "Even steps on a straight line, brought back to length 1, are not even on the arc: the bone turns slowly \
                          at both ends and fast in between.",
            hint: "`lerp` goes straight. What is the s in `slerp`?",
            seen_in: ROTATIONS,
            costs: ROTATIONS,
            variants: ways![StraightLine],
        },
    ]
}

fn about_the_ends() -> Vec<Misconception> {
    vec![
        Misconception {
            id: "blend_backwards",
            title: "You count `t` from the wrong posture.",
            explanation: "When `t` is 0, the result should be the first posture, and when it is 1, the second.",
            hint: "Put 0 in for `t` by hand. Which posture is left?",
            seen_in: ALL,
            costs: ALL,
            variants: ways![Backwards<true, true>],
        },
        Misconception {
            id: "angles_backwards",
            title: "You count `t` from the wrong posture for the angles.",
            explanation: "Your translations go from the first posture to the second, and your rotations from the second to the \
                          first.",
            hint: "In which order do you hand the two rotations on, and what do you make of `t`?",
            seen_in: ALL,
            costs: ROTATIONS,
            variants: ways![Backwards<true, false>],
        },
        Misconception {
            id: "translations_backwards",
            title: "You count `t` from the wrong posture for the translations.",
            explanation: "Your rotations go from the first posture to the second, and your translations from the second to the \
                          first.",
            hint: "Where is the figure when `t` is 0?",
            seen_in: ALL,
            costs: TRANSLATIONS,
            variants: ways![Backwards<false, true>],
        },
        Misconception {
            id: "translations_stay",
            title: "You do not blend the translations.",
            explanation: "Rotations alone do not move a figure from its place: it would jump at every old frame.",
            hint: "A posture holds `angles` and `translations`. Where is the root at `t`?",
            seen_in: TRANSLATIONS,
            costs: TRANSLATIONS,
            variants: ways![TranslationsStay<0>, TranslationsStay<1>, TranslationsStay<2>],
        },
        Misconception {
            id: "translations_on_an_arc",
            title: "You move the bones on an arc.",
            explanation: "`slerp` is for what turns. A translation goes straight from the one place to the other, and the figure with \
                          it.",
            hint: "Where is a point half-way between two others? Which function of a `Vec3` gives it?",
            seen_in: TRANSLATIONS,
            costs: TRANSLATIONS,
            variants: ways![TranslationsOnAnArc],
        },
        Misconception {
            id: "only_the_root_moves",
            title: "You blend the translation of the root only.",
            explanation: "Nearly all other bones have none, but a file can give some. Where both postures hold zero, a blend of the \
                          two is zero too.",
            hint: "Does a bone that is never moved need to be treated in another way?",
            seen_in: TRANSLATIONS,
            costs: TRANSLATIONS,
            variants: ways![OnlyTheRootMoves<0>, OnlyTheRootMoves<1>, OnlyTheRootMoves<2>],
        },
    ]
}
