//! What the parts of forward kinematics are worth: 5 + 5 + 5 points.

use crate::{CheckRubric, PartRubric, Rubric};

/// The rubric of forward kinematics.
pub static RUBRIC: Rubric = Rubric {
    exercise: "fk",
    title: "Forward kinematics",
    parts: &[
        PartRubric {
            id: "part1",
            function: "local_quaternion",
            title: "local quaternion",
            checks: &[
                check("single_axis", 1, "one angle, the others zero"),
                check("rotation_orders", 2, "three angles, in each of the six rotation orders"),
                check("big_angles", 1, "angles beyond 180 degrees, of either sign"),
                check("cursor", 1, "each joint takes its own angles from the frame, and NONE takes none"),
            ],
        },
        PartRubric {
            id: "part2",
            function: "global_quaternion",
            title: "global quaternion",
            checks: &[
                check("root", 1, "a root, which has no parent"),
                check("child", 2, "a joint and its parent"),
                check("branch", 1, "a joint whose parent is not the joint before it"),
                check("deep", 1, "joints and End Sites far down a chain"),
            ],
        },
        PartRubric {
            id: "part3",
            function: "global_position",
            title: "global position",
            checks: &[
                check("root", 1, "a root, which the frame moves"),
                check("child", 2, "a joint or an End Site and its parent"),
                check("branch", 1, "a joint whose parent is not the joint before it"),
                check("moved", 1, "a joint that the frame moves against its parent"),
            ],
        },
    ],
};

const fn check(id: &'static str, points: u32, title: &'static str) -> CheckRubric {
    CheckRubric { id, points, title }
}
