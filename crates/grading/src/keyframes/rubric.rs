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
                check("one_tip", 1, "one tip off"),
                check("all_tips", 2, "all tips off: the sum of the squared distances"),
                check("only_tips", 1, "other joints off, and tips in their places"),
                check("leaves", 1, "a joint that nothing hangs on counts as a tip"),
            ],
        },
        PartRubric {
            id: "part2",
            function: "removal_cost",
            title: "removal cost",
            like_template: "0, whatever is removed",
            checks: &[
                check("first", 1, "the keyframes on both sides are the next frames"),
                check("gap", 2, "other frames between the keyframes on both sides"),
                check("lower", 1, "a removal that makes the accumulated error smaller"),
                check("edges", 1, "the first and the last keyframes of the motion on both sides"),
            ],
        },
        PartRubric {
            id: "part3",
            function: "reduce",
            title: "reduction",
            like_template: "all frames as keyframes",
            checks: &[
                check("one", 1, "one keyframe to remove"),
                check("many", 2, "many keyframes to remove, with new costs after each"),
                check("ties", 1, "several that cost the same: the earliest goes first"),
                check("few", 1, "few frames, and counts below 2 or above all frames"),
            ],
        },
    ],
};

const fn check(id: &'static str, points: u32, title: &'static str) -> CheckRubric {
    CheckRubric { id, points, title }
}
