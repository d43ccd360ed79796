//! What the parts of the exercise on time warping are worth.

use crate::{CheckRubric, PartRubric, Rubric};

/// The rubric of the exercise on time warping.
pub static RUBRIC: Rubric = Rubric {
    exercise: "time-warp",
    title: "Time warping",
    invitation: "that was the last exercise",
    parts: &[
        PartRubric {
            id: "part1",
            function: "old_position",
            title: "old position",
            like_template: "the new frame itself, whatever the counts",
            checks: &[
                check("slower", 2, "more frames than before"),
                check("faster", 1, "fewer frames than before"),
                check("last", 1, "the end of the motion: there is no frame behind the last one"),
                check("long", 1, "motions of millions of frames"),
            ],
        },
        PartRubric {
            id: "part2",
            function: "blend",
            title: "blend",
            like_template: "the first posture, whatever `t`",
            checks: &[
                check("translations", 1, "translations"),
                check("one_axis", 1, "rotations about one axis"),
                check("all_axes", 2, "rotations about several axes"),
                check("wrap", 1, "angles on both sides of ±180 degrees: the shorter way round"),
            ],
        },
        PartRubric {
            id: "part3",
            function: "warp",
            title: "whole motion",
            like_template: "the motion as it was, whatever the count",
            checks: &[
                check("longer", 2, "more frames than before"),
                check("shorter", 1, "fewer frames than before"),
                check("same", 1, "as many frames as before, and twice as many and back"),
                check("few", 1, "motions of one frame and none, and counts of 1 and 0"),
            ],
        },
    ],
};

const fn check(id: &'static str, points: u32, title: &'static str) -> CheckRubric {
    CheckRubric { id, points, title }
}
