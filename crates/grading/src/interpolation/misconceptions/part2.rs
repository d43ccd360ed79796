//! Misconceptions about slerp.
//!
//! Where two rotations are nearly the same, the last digit of a rounded number decides what a wrong function gives. So
//! most misconceptions are recognised elsewhere (`seen_in`), although they cost the check `close` too. And what is wrong at
//! the ends can be another mistake.

use crate::Misconception;
use crate::interpolation::variants::{functions, slerp};

const ALL: &[&str] = &["near", "shorter_way", "close", "ends"];

/// Where the way between the two shows.
const FAR: &[&str] = &["near", "shorter_way"];

pub(super) fn misconceptions() -> Vec<Misconception> {
    [about_the_way(), about_the_arc(), about_close_rotations(), about_t()].into_iter().flatten().collect()
}

fn about_the_way() -> Vec<Misconception> {
    vec![
        Misconception {
            id: "no_shorter_way",
            title: "You do not take the shorter way round.",
            explanation: "q and −q are the same rotation, but from a third one the way to one of them is longer. Your \
                          function takes the way that it is given. Changing the signs of both changes nothing.",
            hint: "What becomes of the dot product when one of the two changes its sign? And when both do?",
            seen_in: FAR,
            costs: &["shorter_way", "close"],
            variants: vec![functions::<slerp::AsTheyCome>(), functions::<slerp::BothTurnedRound>()],
        },
        Misconception {
            id: "longer_way",
            title: "You take the longer way round.",
            explanation: "Where the dot product is positive, the two quaternions are already on the same side, and \
                          nothing has to be done. You do it just there.",
            hint: "Try two equal rotations: which sign has their dot product, and what do you make of it?",
            seen_in: FAR,
            costs: &["near", "shorter_way", "close"],
            variants: vec![functions::<slerp::LongerWay>()],
        },
        Misconception {
            id: "old_cosine",
            title: "You change the sign of one quaternion, but keep the angle from before.",
            explanation: "θ is the angle between the two quaternions that you interpolate. When one of them has changed \
                          its sign, the cosine of θ has changed too.",
            hint: "Behind which line of yours is the dot product out of date?",
            seen_in: FAR,
            costs: &["shorter_way", "close"],
            variants: vec![functions::<slerp::OldCosine<false>>(), functions::<slerp::OldCosine<true>>()],
        },
    ]
}

fn about_the_arc() -> Vec<Misconception> {
    const NEAR: &[&str] = &["near"];
    vec![
        Misconception {
            id: "uneven_speed",
            title: "You go along a straight line and not along the arc.",
            explanation: "Even steps on a straight line, brought back to length 1, are not even on the arc: the joint \
                          turns slowly at both ends and fast in between.",
            hint: "Compare your weights with those of the formula. Where are the sines?",
            seen_in: NEAR,
            costs: FAR,
            variants: vec![functions::<slerp::StraightLine>()],
        },
        Misconception {
            id: "inside_the_sphere",
            title: "You go along a straight line and leave the unit quaternions.",
            explanation: "The straight line between two unit quaternions leads through the inside of the sphere, where \
                          the length is less than 1 and nothing is a rotation. Scaling the result would make it one, \
                          but the speed would not be even.",
            hint: "Which weights has the formula in the place of 1 − t and t?",
            seen_in: NEAR,
            costs: FAR,
            variants: vec![functions::<slerp::StraightLineInside>()],
        },
        Misconception {
            id: "other_angle",
            title: "You put another angle into the formula than the one between the two quaternions.",
            explanation: "θ is the angle between the two as vectors of four numbers. The joint turns by twice as much, \
                          but the formula knows nothing of joints.",
            hint: "The cosine of θ is the dot product. Is there a 2 or a half between them and your sines?",
            seen_in: NEAR,
            costs: FAR,
            variants: vec![
                functions::<slerp::OtherAngle<true, false>>(),
                functions::<slerp::OtherAngle<true, true>>(),
                functions::<slerp::OtherAngle<false, false>>(),
                functions::<slerp::OtherAngle<false, true>>(),
            ],
        },
    ]
}

fn about_close_rotations() -> Vec<Misconception> {
    const CLOSE: &[&str] = &["close"];
    vec![
        Misconception {
            id: "division_by_zero",
            title: "You divide by sin θ even where it is 0.",
            explanation: "Between two equal rotations there is no angle, and 0 divided by 0 is not a number (NaN). A \
                          joint that rests in both frames would disappear.",
            hint: "When two rotations are so close that the arc is as good as straight, what else goes evenly from one \
                   to the other?",
            seen_in: CLOSE,
            costs: CLOSE,
            variants: vec![functions::<slerp::AlwaysDivides>()],
        },
        Misconception {
            id: "cosine_above_one",
            title: "You take the arc cosine of a number that can be above 1.",
            explanation: "The dot product of two unit quaternions is at most 1, but computers round, and it can come \
                          out as 1.0000001. No angle has such a cosine: the result is not a number (NaN), and that is \
                          not equal to 0 either.",
            hint: "Look at the dot product before you take its arc cosine.",
            seen_in: CLOSE,
            costs: CLOSE,
            variants: vec![functions::<slerp::DividesUnlessZero>()],
        },
        Misconception {
            id: "close_before_shorter",
            title: "You look whether the two are nearly the same before you change a sign.",
            explanation: "q and −q are the same rotation, and their dot product is −1. That they are the same shows \
                          when one of them has changed its sign, and not before.",
            hint: "Which of the two special cases should come first?",
            seen_in: CLOSE,
            costs: CLOSE,
            variants: vec![functions::<slerp::NearBeforeShorter>()],
        },
    ]
}

fn about_t() -> Vec<Misconception> {
    vec![
        Misconception {
            id: "rotation_goes_on",
            title: "You go on before the first rotation and beyond the second.",
            explanation: "A `t` below 0 counts as 0, and one above 1 as 1: between two frames there is nothing else.",
            hint: "`f32` has a function that keeps a number between two others.",
            seen_in: &["ends"],
            costs: &["ends"],
            variants: vec![functions::<slerp::GoesOn>()],
        },
        Misconception {
            id: "rotation_backwards",
            title: "You count `t` from the wrong end.",
            explanation: "When `t` is 0, the result should be the first rotation, and when it is 1, the second.",
            hint: "Put 0 in for `t` by hand. Which of the two is left?",
            seen_in: FAR,
            costs: ALL,
            variants: vec![functions::<slerp::Backwards>()],
        },
    ]
}
