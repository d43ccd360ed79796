//! The misconceptions of forward kinematics: what is said about each, what it costs, and how it is recognised.

use exam::Functions;
use glam::{Quat, Vec3};
use skeleton::{FkFunctions, FrameCursor, Joint, Pose};

use super::variants::{Exact, Fraction, ThreeDecimals, ThreeRounded, TwoDecimals, local, position, rotation};
use crate::{Accepted, Misconception};

/// Ways to answer a part that get full points, with a remark.
pub fn accepted(part: &str) -> Vec<Accepted> {
    let remark = "Your π has only a few digits. That is accepted here, and in this assignment it was once given as \
                  3.14, but after several joints the error can be seen. `f32::to_radians` and \
                  `std::f32::consts::PI` are exact.";
    let short_pis: [Local; 4] = [
        local::right::<TwoDecimals>,
        local::right::<ThreeDecimals>,
        local::right::<ThreeRounded>,
        local::right::<Fraction>,
    ];
    match part {
        "part1" => short_pis.map(|function| Accepted { remark, functions: part1(function) }).into(),
        _ => Vec::new(),
    }
}

/// The misconceptions of one part.
pub fn misconceptions(part: &str) -> Vec<Misconception> {
    match part {
        "part1" => [about_rotation(), about_cursor()].into_iter().flatten().collect(),
        "part2" => [about_child_rotation(), about_root_rotation()].into_iter().flatten().collect(),
        "part3" => [about_child_position(), about_root_position()].into_iter().flatten().collect(),
        _ => Vec::new(),
    }
}

type Local = fn(&Joint, &mut FrameCursor) -> Quat;
type Rotation = fn(&Joint, Quat, &Pose) -> Quat;
type Position = fn(&Joint, Vec3, &Pose) -> Vec3;

/// The right functions but for one.
fn part1(local_quaternion: Local) -> Functions {
    Functions::Fk(FkFunctions { local_quaternion, ..solutions::FK })
}

fn part2(global_quaternion: Rotation) -> Functions {
    Functions::Fk(FkFunctions { global_quaternion, ..solutions::FK })
}

fn part3(global_position: Position) -> Functions {
    Functions::Fk(FkFunctions { global_position, ..solutions::FK })
}

/// The same mistake with each π.
macro_rules! with_each_pi {
    ($($function:ident $(::<_ $(, $rest:tt)*>)?),* $(,)?) => {
        [$(
            local::$function::<Exact $($(, $rest)*)?> as Local,
            local::$function::<TwoDecimals $($(, $rest)*)?>,
            local::$function::<ThreeDecimals $($(, $rest)*)?>,
            local::$function::<ThreeRounded $($(, $rest)*)?>,
            local::$function::<Fraction $($(, $rest)*)?>,
        )*]
        .map(part1)
        .into()
    };
}

fn about_rotation() -> Vec<Misconception> {
    const SEEN_IN: &[&str] = &["single_axis", "rotation_orders", "big_angles"];
    const ORDERS: &[&str] = &["rotation_orders", "big_angles"];
    vec![
        Misconception {
            id: "degrees_as_radians",
            title: "You use degrees as if they were radians.",
            explanation: "The frame's angles are in degrees. Sine and cosine, and all of glam's functions, want radians.",
            hint: "What is a half turn in degrees, and what is it in radians?",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: vec![part1(local::degrees_as_radians)],
        },
        Misconception {
            id: "angle_not_halved",
            title: "You do not halve the angle.",
            explanation: "A quaternion works on a vector from both sides, q v q⁻¹, and so turns it twice. It holds the \
                          sine and cosine of half the angle.",
            hint: "Your joints turn twice as far as they should. Look at the angle inside sine and cosine.",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: with_each_pi![not_halved],
        },
        Misconception {
            id: "angles_negated",
            title: "You turn the wrong way round.",
            explanation: "The axes are right-handed: with the thumb along the axis, the fingers curl the way of a \
                          positive angle.",
            hint: "Look for a minus sign, an inverse or a conjugate that should not be there.",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: with_each_pi![negated],
        },
        Misconception {
            id: "order_reversed",
            title: "Your order is reversed.",
            explanation: "A motion's angles are intrinsic: each rotation is about axes that those before it have \
                          turned. Fixed axes would need the opposite order.",
            hint: "The first angle's quaternion stands leftmost. (glam's orders that end in `Ex` are about fixed axes.)",
            seen_in: SEEN_IN,
            costs: ORDERS,
            variants: with_each_pi![reversed],
        },
        Misconception {
            id: "always_one_order",
            title: "You treat all joints as if they had the same rotation order.",
            explanation: "Each joint has an order of its own, which says about which axis its first, second and third \
                          angle turns.",
            hint: "Use `joint.rotation_order`. Does your code come by there for every joint?",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: with_each_pi![
                always_taken_as::<_, 0>,
                always_taken_as::<_, 1>,
                always_taken_as::<_, 2>,
                always_taken_as::<_, 3>,
                always_taken_as::<_, 4>,
                always_taken_as::<_, 5>,
            ],
        },
        Misconception {
            id: "angles_taken_as_xyz",
            title: "You take every joint's angles as x, y, z.",
            explanation: "The angles arrive in the joint's own order: with ZYX the first is about Z. You multiply in \
                          the right order, but with the wrong angles.",
            hint: "With the order ZYX, about which axis is the first of the three angles?",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: with_each_pi![taken_as_xyz],
        },
        Misconception {
            id: "always_multiplied_in_one_order",
            title: "You multiply the three rotations of all joints in the same order.",
            explanation: "Each angle goes to the right axis, but rotations do not commute: the joint's order is also \
                          the order of the product.",
            hint: "If you use `match`, does every order have an arm with a product of its own?",
            seen_in: SEEN_IN,
            costs: ORDERS,
            variants: with_each_pi![
                always_multiplied::<_, 0>,
                always_multiplied::<_, 1>,
                always_multiplied::<_, 2>,
                always_multiplied::<_, 3>,
                always_multiplied::<_, 4>,
                always_multiplied::<_, 5>,
            ],
        },
        Misconception {
            id: "w_first",
            title: "You put w first.",
            explanation: "Quaternions are written (x, y, z, w) here, as in glam: `Quat::from_xyzw`. Many books write w \
                          first.",
            hint: "What does your function give for three zero angles? It should be (0, 0, 0, 1).",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: with_each_pi![w_first, w_first_in_factors],
        },
        Misconception {
            id: "angles_packed",
            title: "You put the three angles into a quaternion as they are.",
            explanation: "The numbers of a quaternion are no angles: they are the axis times the sine of half the \
                          angle, and its cosine.",
            hint: "Make one quaternion for each of the three angles, and multiply them.",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: [
                local::packed::<0, false, false> as Local,
                local::packed::<0, false, true>,
                local::packed::<0, true, false>,
                local::packed::<0, true, true>,
                local::packed::<1, false, false>,
                local::packed::<1, false, true>,
                local::packed::<1, true, false>,
                local::packed::<1, true, true>,
            ]
            .map(part1)
            .into(),
        },
        Misconception {
            id: "half_angle_in_one",
            title: "You halve the angle for only one of sine and cosine.",
            explanation: "Both need the same half angle. Otherwise the quaternion's length is not 1, and it is no \
                          rotation.",
            hint: "Compare the angle inside sine with the one inside cosine, for each of the three axes.",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: with_each_pi![
                half_in_one::<_, true, 0>,
                half_in_one::<_, true, 1>,
                half_in_one::<_, true, 2>,
                half_in_one::<_, true, 3>,
                half_in_one::<_, false, 0>,
                half_in_one::<_, false, 1>,
                half_in_one::<_, false, 2>,
                half_in_one::<_, false, 3>,
            ],
        },
    ]
}

fn about_cursor() -> Vec<Misconception> {
    const CURSOR: &[&str] = &["cursor"];
    vec![
        Misconception {
            id: "cursor_moved_on_none",
            title: "You take angles for a joint that has none.",
            explanation: "With the order NONE (an End Site, for one) the frame holds no angles for the joint. What you \
                          take belongs to the next joint.",
            hint: "Ask for `joint.rotation_order` before you take anything.",
            seen_in: CURSOR,
            costs: CURSOR,
            variants: [local::moves_on_none as Local, local::turns_on_none].map(part1).into(),
        },
        Misconception {
            id: "cursor_not_moved",
            title: "You read the angles but do not move past them.",
            explanation: "There is one cursor for the whole frame. What a joint leaves, the next joint gets: all \
                          joints turn like the root.",
            hint: "`peek3` leaves the cursor where it is. What moves it?",
            seen_in: CURSOR,
            costs: CURSOR,
            variants: vec![part1(local::never_moves)],
        },
        Misconception {
            id: "cursor_one_short",
            title: "You take one angle too few.",
            explanation: "Every joint that rotates has three angles. The one that you leave becomes the next joint's \
                          first.",
            hint: "Count how often you take an angle for one joint.",
            seen_in: CURSOR,
            costs: CURSOR,
            variants: vec![part1(local::takes_two)],
        },
    ]
}

fn about_child_rotation() -> Vec<Misconception> {
    const SEEN_IN: &[&str] = &["child", "branch", "deep"];
    vec![
        Misconception {
            id: "local_times_parent",
            title: "You multiply in the wrong order: local times parent.",
            explanation: "In a product the right factor happens first. The joint turns in axes that its parent has \
                          turned, so the local rotation comes first, and the parent's after it.",
            hint: "Which of the two should stand on the left?",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: vec![part2(rotation::swapped)],
        },
        Misconception {
            id: "parent_only",
            title: "You give the parent's rotation and leave the joint's own out.",
            explanation: "A joint turns with its parent, and against it by its own local rotation.",
            hint: "Where do you use `local`?",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: vec![part2(rotation::parent_only)],
        },
        Misconception {
            id: "parent_twice",
            title: "You use the parent's rotation twice.",
            explanation: "The parent's global rotation is already the product of all rotations down to it. It comes \
                          in once.",
            hint: "You need not walk up the skeleton: one product is enough.",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: [
                rotation::parent_twice as Rotation,
                rotation::parent_on_both_sides,
                rotation::parent_squared,
            ]
            .map(part2)
            .into(),
        },
        Misconception {
            id: "sum_of_rotations",
            title: "You add or blend the two quaternions.",
            explanation: "One rotation after another is the product of their quaternions. Their sum, made a unit \
                          quaternion, lies halfway between them.",
            hint: "Which operation on quaternions puts one rotation after another?",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: [rotation::sum as Rotation, rotation::sum_normalized, rotation::blend]
                .map(part2)
                .into(),
        },
        Misconception {
            id: "parent_inverted",
            title: "You use the inverse of the parent's rotation.",
            explanation: "The inverse leads from the world's axes into the parent's. You want to go the other way.",
            hint: "Leave the inverse (or the conjugate) out, and ask again which factor stands on the left.",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: [rotation::inverse as Rotation, rotation::inverse_behind].map(part2).into(),
        },
        Misconception {
            id: "previous_rotation",
            title: "You use the joint that comes before this one as if it were its parent.",
            explanation: "In a chain they are the same. Where the skeleton branches, the joint before is the end of \
                          another branch.",
            hint: "`joint.parent` says which joint is the parent.",
            seen_in: SEEN_IN,
            costs: &["branch"],
            variants: vec![part2(rotation::previous)],
        },
    ]
}

fn about_root_rotation() -> Vec<Misconception> {
    const ROOT: &[&str] = &["root"];
    vec![
        Misconception {
            id: "root_forgotten",
            title: "You leave the root unturned.",
            explanation: "A root has no parent, but it has a rotation of its own, and all other joints turn with it.",
            hint: "What is left of the product when there is no parent?",
            seen_in: ROOT,
            costs: ROOT,
            variants: vec![part2(rotation::root_forgotten)],
        },
        Misconception {
            id: "root_twice",
            title: "You use the root's rotation twice.",
            explanation: "A root has no parent, so that nothing comes in beside its own rotation, once.",
            hint: "What do you multiply by when there is no parent?",
            seen_in: ROOT,
            costs: ROOT,
            variants: vec![part2(rotation::root_twice)],
        },
    ]
}

fn about_child_position() -> Vec<Misconception> {
    const SEEN_IN: &[&str] = &["child", "branch", "moved"];
    vec![
        Misconception {
            id: "own_rotation",
            title: "You turn the local position by the joint's own rotation.",
            explanation: "A joint's own rotation turns what hangs on it, not the joint itself. The local position is \
                          along the parent's axes.",
            hint: "Whose rotation turns the bone that leads to this joint?",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: vec![part3(position::own_rotation)],
        },
        Misconception {
            id: "offset_not_rotated",
            title: "You do not turn the local position.",
            explanation: "The local position is along the parent's axes. The sum needs it along the world's.",
            hint: "Part 2 gave you what turns the one into the other.",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: vec![part3(position::not_rotated)],
        },
        Misconception {
            id: "parent_position_not_added",
            title: "You do not add the parent's position.",
            explanation: "The turned local position is the way from the parent to the joint. It begins where the \
                          parent is.",
            hint: "All your bones begin at the origin.",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: vec![part3(position::parent_not_added)],
        },
        Misconception {
            id: "parent_position_rotated",
            title: "You turn the parent's position too.",
            explanation: "The parent's position is already in the world's axes. Only the local position is turned.",
            hint: "Look at the parentheses: what does the quaternion work on?",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: vec![part3(position::parent_rotated_too)],
        },
        Misconception {
            id: "inverse_rotation",
            title: "You turn the local position the wrong way round.",
            explanation: "The parent's global rotation leads from its axes into the world's. Its inverse leads back.",
            hint: "If you write q v q⁻¹ out, which of the two stands on the left?",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: vec![part3(position::inverse)],
        },
        Misconception {
            id: "one_sided_product",
            title: "You multiply the local position by the quaternion from one side only.",
            explanation: "A quaternion turns a vector from both sides: q v q⁻¹. With one side only the result is no \
                          rotated vector.",
            hint: "glam's `q * v` with a `Vec3` does both sides for you.",
            seen_in: SEEN_IN,
            costs: SEEN_IN,
            variants: [position::from_the_left_only as Position, position::from_the_right_only]
                .map(part3)
                .into(),
        },
        Misconception {
            id: "previous_position",
            title: "You hang the joint on the one that comes before it instead of on its parent.",
            explanation: "In a chain they are the same. Where the skeleton branches, the joint before is the end of \
                          another branch.",
            hint: "`joint.parent` says which joint is the parent.",
            seen_in: SEEN_IN,
            costs: &["branch"],
            variants: vec![part3(position::previous)],
        },
        Misconception {
            id: "always_the_offset",
            title: "You use the joint's offset where the frame has put something else in its place.",
            explanation: "Most joints are always at their offset. Some have position channels, which move them.",
            hint: "The function is given `local_position`.",
            seen_in: SEEN_IN,
            costs: &["moved"],
            variants: vec![part3(position::always_offset)],
        },
    ]
}

fn about_root_position() -> Vec<Misconception> {
    const ROOT: &[&str] = &["root"];
    vec![Misconception {
        id: "root_stays",
        title: "Your root stays where it is.",
        explanation: "The frame says where the root is. Its offset, or the origin, is only where it would be without \
                      the frame.",
        hint: "What is `local_position` for a root?",
        seen_in: ROOT,
        costs: ROOT,
        variants: [position::root_at_offset as Position, position::root_at_origin].map(part3).into(),
    }]
}
