//! What the parts of the exercise on time warping are worth.

use crate::{CheckRubric, PartRubric, Rubric};

/// The rubric of the exercise on time warping.
pub static RUBRIC: Rubric = Rubric {
    exercise: "time-warp",
    title: "Time warping",
    invitation: "run `cargo view --exercise time-warp` and press `↑`",
    parts: &[
        PartRubric {
            id: "part1",
            function: "old_position",
            title: "old position",
            like_template: "the new frame itself, whatever the counts",
            checks: &[
                CheckRubric::new("slower", 2, "more frames than before"),
                CheckRubric::new("faster", 1, "fewer frames than before"),
                CheckRubric::new("last", 1, "the end of the motion: there is no frame after the last one"),
                CheckRubric::new("long", 1, "motions of millions of frames"),
            ],
        },
        PartRubric {
            id: "part2",
            function: "blend",
            title: "blend",
            like_template: "the first posture, whatever `t`",
            checks: &[
                CheckRubric::new("translations", 1, "translations"),
                CheckRubric::new("one_axis", 1, "rotations about one axis"),
                CheckRubric::new("all_axes", 2, "rotations about several axes"),
                CheckRubric::new("wrap", 1, "angles on both sides of ±180 degrees: the shorter way round"),
            ],
        },
        PartRubric {
            id: "part3",
            function: "warp",
            title: "whole motion",
            like_template: "the motion as it was, whatever the count",
            checks: &[
                CheckRubric::new("longer", 2, "more frames than before"),
                CheckRubric::new("shorter", 1, "fewer frames than before"),
                CheckRubric::new("same", 1, "as many frames as before, and twice as many and back"),
                CheckRubric::new("few", 1, "motions of one frame and none, and counts of 1 and 0"),
            ],
        },
    ],
};
