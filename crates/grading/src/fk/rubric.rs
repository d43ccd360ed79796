//! What the parts of forward kinematics are worth.

use crate::{CheckRubric, PartRubric, Rubric};

/// The rubric of forward kinematics.
pub static RUBRIC: Rubric = Rubric {
    exercise: "fk",
    title: "Forward kinematics",
    invitation: "run `cargo view` and see it run",
    parts: &[
        PartRubric {
            id: "part1",
            function: "local_quaternion",
            title: "local quaternion",
            like_template: "no rotation, whatever the angles",
            checks: &[
                CheckRubric::new("single_axis", 1, "one angle, the others zero"),
                CheckRubric::new("rotation_orders", 2, "three angles, in each of the six rotation orders"),
                CheckRubric::new("big_angles", 1, "angles beyond 180 degrees, of either sign"),
                CheckRubric::new(
                    "cursor",
                    1,
                    "each joint takes its own angles from the frame, and NONE takes none",
                ),
            ],
        },
        PartRubric {
            id: "part2",
            function: "global_quaternion",
            title: "global quaternion",
            like_template: "the local rotation alone (`pose[joint.id]` is not filled in yet: it is the parent's that you need)",
            checks: &[
                CheckRubric::new("root", 1, "a root, which has no parent"),
                CheckRubric::new("child", 2, "a joint and its parent"),
                CheckRubric::new("branch", 1, "a joint at a branch: the joint before it is not its parent"),
                CheckRubric::new("deep", 1, "joints and End Sites far down a chain"),
            ],
        },
        PartRubric {
            id: "part3",
            function: "global_position",
            title: "global position",
            like_template: "the local position alone",
            checks: &[
                CheckRubric::new("root", 1, "a root, which the frame moves"),
                CheckRubric::new("child", 2, "a joint or an End Site and its parent"),
                CheckRubric::new("branch", 1, "a joint at a branch: the joint before it is not its parent"),
                CheckRubric::new("moved", 1, "a joint with position channels of its own"),
            ],
        },
    ],
};
