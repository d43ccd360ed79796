//! What the parts of the exercise on interpolation are worth.

use crate::{CheckRubric, PartRubric, Rubric};

/// The rubric of the exercise on interpolation.
pub static RUBRIC: Rubric = Rubric {
    exercise: "interpolation",
    title: "Interpolation",
    invitation: "run `cargo view --exercise interpolation` and press `e`",
    parts: &[
        PartRubric {
            id: "part1",
            function: "interpolate_angles",
            title: "Euler angles",
            like_template: "the angles of the first frame, whatever `t`",
            checks: &[
                check("near", 1, "angles less than half a turn apart"),
                check("across", 2, "angles on both sides of ±180 degrees: the shorter way round"),
                check("turns", 1, "angles that are full turns apart"),
                check("ends", 1, "t at 0 and 1, below 0 and above 1"),
            ],
        },
        PartRubric {
            id: "part2",
            function: "slerp",
            title: "slerp",
            like_template: "the first rotation, whatever `t`",
            checks: &[
                check("near", 2, "two rotations less than half a turn apart, at an even speed"),
                check("shorter_way", 1, "quaternions that point apart: the shorter way round"),
                check("close", 1, "two rotations that are the same, or nearly"),
                check("ends", 1, "t at 0 and 1, below 0 and above 1"),
            ],
        },
        PartRubric {
            id: "part3",
            function: "interpolate_frame",
            title: "whole frame",
            like_template: "no rotation, at the positions of the first frame",
            checks: &[
                check("euler", 2, "the rotations of all joints, with Euler angles"),
                check("quaternion", 2, "the rotations of all joints, with quaternions"),
                check("positions", 1, "the positions of the root and of all other joints"),
            ],
        },
    ],
};

const fn check(id: &'static str, points: u32, title: &'static str) -> CheckRubric {
    CheckRubric { id, points, title }
}
