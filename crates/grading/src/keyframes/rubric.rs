//! What the parts of the exercise on keyframes are worth.

use crate::{CheckRubric, PartRubric, Rubric};

/// The rubric of the exercise on keyframes.
pub static RUBRIC: Rubric = Rubric {
    exercise: "keyframes",
    title: "Keyframes",
    invitation: "run `cargo view --exercise keyframes` and press `p`",
    parts: &[
        PartRubric {
            id: "part1",
            function: "pose_error",
            title: "pose error",
            like_template: "0, whatever the poses",
            checks: &[
                CheckRubric::new("one_tip", 1, "one tip off"),
                CheckRubric::new("all_tips", 2, "all tips off: the sum of the squared distances"),
                CheckRubric::new("only_tips", 1, "other joints off, and tips in their places"),
                CheckRubric::new("leaves", 1, "a joint that nothing hangs on counts as a tip"),
            ],
        },
        PartRubric {
            id: "part2",
            function: "removal_cost",
            title: "removal cost",
            like_template: "0, whatever is removed",
            checks: &[
                CheckRubric::new("first", 1, "the keyframes on both sides are the next frames"),
                CheckRubric::new("gap", 2, "other frames between the keyframes on both sides"),
                CheckRubric::new("lower", 1, "a removal that makes the accumulated error smaller"),
                CheckRubric::new("edges", 1, "the first and the last keyframes of the motion on both sides"),
            ],
        },
        PartRubric {
            id: "part3",
            function: "reduce",
            title: "reduction",
            like_template: "all frames as keyframes",
            checks: &[
                CheckRubric::new("one", 1, "one keyframe to remove"),
                CheckRubric::new("many", 2, "many keyframes to remove, with new costs after each"),
                CheckRubric::new("ties", 1, "several that cost the same: the earliest goes first"),
                CheckRubric::new("few", 1, "few frames, and counts below 2 or above all frames"),
            ],
        },
    ],
};
