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
                CheckRubric::new("near", 1, "angles less than half a turn apart"),
                CheckRubric::new("across", 2, "angles on both sides of ±180 degrees: the shorter way round"),
                CheckRubric::new("turns", 1, "angles that are full turns apart"),
                CheckRubric::new("ends", 1, "t at 0 and 1, below 0 and above 1"),
            ],
        },
        PartRubric {
            id: "part2",
            function: "slerp",
            title: "slerp",
            like_template: "the first rotation, whatever `t`",
            checks: &[
                CheckRubric::new("near", 2, "two rotations less than half a turn apart, at an even speed"),
                CheckRubric::new("shorter_way", 1, "quaternions that point apart: the shorter way round"),
                CheckRubric::new("close", 1, "two rotations that are the same, or nearly"),
                CheckRubric::new("ends", 1, "t at 0 and 1, below 0 and above 1"),
            ],
        },
        PartRubric {
            id: "part3",
            function: "interpolate_frame",
            title: "whole frame",
            like_template: "no rotation, at the positions of the first frame",
            checks: &[
                CheckRubric::new("euler", 2, "the rotations of all joints, with Euler angles"),
                CheckRubric::new("quaternion", 2, "the rotations of all joints, with quaternions"),
                CheckRubric::new("positions", 1, "the positions of the root and of all other joints"),
            ],
        },
    ],
};
