//! What the parts of the exercise on Acclaim forward kinematics are worth.

use crate::{CheckRubric, PartRubric, Rubric};

/// The rubric of the exercise on Acclaim forward kinematics.
pub static RUBRIC: Rubric = Rubric {
    exercise: "acclaim",
    title: "Acclaim forward kinematics",
    invitation: "run `cargo view --exercise acclaim` and see it walk",
    parts: &[
        PartRubric {
            id: "part1",
            function: "bone_rotation",
            title: "bone rotation",
            like_template: "no rotation, whatever the angles",
            checks: &[
                CheckRubric::new("root", 1, "the root, whose parent is the world"),
                CheckRubric::new("angles", 2, "a bone's three angles, multiplied as Rz Ry Rx"),
                CheckRubric::new("rest", 2, "axes that are turned against the parent's at rest"),
            ],
        },
        PartRubric {
            id: "part2",
            function: "bone_ends",
            title: "bone ends",
            like_template: "no length: the bone ends where it starts",
            checks: &[
                CheckRubric::new("start", 1, "the start is the parent's end"),
                CheckRubric::new("end", 3, "the end: length, direction and rotation"),
                CheckRubric::new("translation", 1, "an end that a translation moves"),
            ],
        },
        PartRubric {
            id: "part3",
            function: "visit_bones",
            title: "all bones",
            like_template: "nothing, and visits no other bone than the one it is given",
            checks: &[
                CheckRubric::new("chain", 1, "a chain of bones"),
                CheckRubric::new("siblings", 2, "several bones on one"),
                CheckRubric::new("subtree", 1, "a bone in the middle, and what hangs on it"),
                CheckRubric::new("all", 1, "a whole skeleton, every bone once and parents first"),
            ],
        },
    ],
};
