//! Misconceptions about a whole frame: its rotations, which angles they come from, and its positions.

use crate::Misconception;
use crate::interpolation::variants::frame::{
    Always, Backwards, ComponentsAsAngles, DegreesAsRadians, Exchanged, MultipliedAs, NeverMoves, Offsets,
    OneFrame, OneShort, OnlyRoots, OtherAngles, OtherSlerp, Packed, PackedAndUnpacked, PackedForSlerp,
    PackedStraight, PositionsStay, Reversed, SortedByAxis, TakenAs, TakenAsXyz, TakenReversedAs, TakesOnNone,
};
use crate::interpolation::variants::{angles, functions, slerp};

const ALL: &[&str] = &["euler", "quaternion", "positions"];
const ROTATIONS: &[&str] = &["euler", "quaternion"];

pub(super) fn misconceptions() -> Vec<Misconception> {
    let all = [about_conversion(), about_components(), about_representation(), about_frames()];
    all.into_iter().flatten().chain(about_positions()).collect()
}

/// A list of functions, one for each way.
macro_rules! ways {
    ($($way:ty),* $(,)?) => { vec![$(functions::<$way>()),*] };
}

fn about_conversion() -> Vec<Misconception> {
    vec![
        Misconception {
            id: "frame_degrees_as_radians",
            title: "You make rotations of degrees as if they were radians.",
            explanation: "The frame's angles are in degrees. Sine and cosine, and all of glam's functions, want radians.",
            hint: "What is a half turn in degrees, and what is it in radians?",
            // With Euler angles the answer depends on which full turn part 1's result is in.
            seen_in: &["quaternion"],
            costs: ROTATIONS,
            variants: ways![DegreesAsRadians],
        },
        Misconception {
            id: "frame_order_reversed",
            title: "You multiply the three rotations of a joint in the reverse order.",
            explanation: "A motion's angles are intrinsic: each rotation is about axes that those before it have \
                          turned. Fixed axes would need the opposite order.",
            hint: "In which order did you multiply in part 1 of forward kinematics? (glam's orders that end in `Ex` are \
                   about fixed axes.)",
            seen_in: ROTATIONS,
            costs: ROTATIONS,
            variants: ways![Reversed],
        },
        Misconception {
            id: "frame_order_ignored",
            title: "You do not make the rotations in each joint's own rotation order.",
            explanation: "`joint.rotation_order` says two things: which axis each of the three angles is about, and in \
                          which order the three rotations are multiplied. It differs from joint to joint.",
            hint: "Go through your code with a joint whose order is ZXY: about which axis is its first angle?",
            seen_in: ROTATIONS,
            costs: ROTATIONS,
            variants: ways![
                TakenAs<0>,
                TakenAs<1>,
                TakenAs<2>,
                TakenAs<3>,
                TakenAs<4>,
                TakenAs<5>,
                TakenReversedAs<0>,
                TakenReversedAs<5>,
                MultipliedAs<0>,
                MultipliedAs<1>,
                MultipliedAs<2>,
                MultipliedAs<3>,
                MultipliedAs<4>,
                MultipliedAs<5>,
                TakenAsXyz,
                SortedByAxis,
            ],
        },
    ]
}

fn about_components() -> Vec<Misconception> {
    vec![
        Misconception {
            id: "frame_angles_packed",
            title: "You put three angles into a quaternion as they are.",
            explanation: "The numbers of a quaternion are not angles: they are the axis times the sine of half the \
                          angle, and its cosine.",
            hint: "Part 1 of forward kinematics makes a quaternion of three angles. What did you do there?",
            seen_in: ROTATIONS,
            costs: ROTATIONS,
            variants: ways![
                Packed<0, false, false, false>, Packed<0, false, false, true>,
                Packed<0, false, true, false>, Packed<0, false, true, true>,
                Packed<0, true, false, false>, Packed<0, true, false, true>,
                Packed<0, true, true, false>, Packed<0, true, true, true>,
                Packed<1, false, false, false>, Packed<1, false, false, true>,
                Packed<1, false, true, false>, Packed<1, false, true, true>,
                Packed<1, true, false, false>, Packed<1, true, false, true>,
                Packed<1, true, true, false>, Packed<1, true, true, true>,
            ],
        },
        Misconception {
            id: "slerp_of_angles",
            title: "You hand three angles to `slerp` as if they were a quaternion.",
            explanation: "`slerp` goes from one rotation to another. Three angles are not one yet: put into a quaternion \
                          as they are, they mean nothing, even if what comes out looks like angles again.",
            hint: "You make a quaternion of three angles elsewhere. When should that happen here, before `slerp` or after \
                   it?",
            seen_in: ROTATIONS,
            costs: &["quaternion"],
            variants: ways![
                PackedForSlerp<0, false, false>, PackedForSlerp<0, false, true>,
                PackedForSlerp<0, true, false>, PackedForSlerp<0, true, true>,
                PackedForSlerp<1, false, false>, PackedForSlerp<1, false, true>,
                PackedForSlerp<1, true, false>, PackedForSlerp<1, true, true>,
                PackedAndUnpacked<0, false>, PackedAndUnpacked<0, true>,
                PackedAndUnpacked<1, false>, PackedAndUnpacked<1, true>,
                PackedStraight<false, false>, PackedStraight<false, true>,
                PackedStraight<true, true>,
            ],
        },
        Misconception {
            id: "components_as_angles",
            title: "You take the numbers of a quaternion for angles.",
            explanation: "x, y and z of a unit quaternion lie between −1 and 1. Taken for degrees they hardly turn the \
                          joint.",
            hint: "What `slerp` gives you is a rotation already. What is still to be done with it?",
            seen_in: ROTATIONS,
            costs: &["quaternion"],
            variants: ways![
                ComponentsAsAngles<false, false>, ComponentsAsAngles<false, true>,
                ComponentsAsAngles<true, false>, ComponentsAsAngles<true, true>,
            ],
        },
    ]
}

fn about_representation() -> Vec<Misconception> {
    vec![
        Misconception {
            id: "always_euler",
            title: "You interpolate Euler angles, whichever representation is asked for.",
            explanation: "`representation` says what to interpolate. Where all three angles change, quaternions lead \
                          along another way than angles.",
            hint: "What does your function do differently when `representation` is `Quaternion`?",
            seen_in: ROTATIONS,
            costs: &["quaternion"],
            variants: ways![Always<true>],
        },
        Misconception {
            id: "always_quaternion",
            title: "You interpolate quaternions, whichever representation is asked for.",
            explanation: "`representation` says what to interpolate. Where all three angles change, angles lead along \
                          another way than quaternions.",
            hint: "What does your function do differently when `representation` is `Euler`?",
            seen_in: ROTATIONS,
            costs: &["euler"],
            variants: ways![Always<false>],
        },
        Misconception {
            id: "representations_exchanged",
            title: "You exchange the two representations.",
            explanation: "With `Euler` it is the angles that are interpolated, and then a quaternion is made of them. \
                          With `Quaternion` a quaternion is made at each end first.",
            hint: "Look at the names of the two arms of your `match`, or at your `if`.",
            seen_in: ROTATIONS,
            costs: ROTATIONS,
            variants: ways![Exchanged],
        },
        Misconception {
            id: "frame_angles_straight",
            title: "You interpolate the angles of a frame otherwise than your part 1 does.",
            explanation: "Part 1 takes the shorter way round. Here the angles go straight from one number to the other, \
                          full turns included.",
            hint: "Which function of yours already knows the way between two sets of angles?",
            seen_in: ROTATIONS,
            costs: &["euler"],
            variants: ways![OtherAngles<angles::Straight>],
        },
        Misconception {
            id: "frame_rotations_straight",
            title: "You interpolate the quaternions of a frame otherwise than your part 2 does.",
            explanation: "Part 2 goes at an even speed and the shorter way round. A straight line, or an arc without a \
                          look at the dot product, does not do both.",
            hint: "Which function of yours already knows the way between two rotations?",
            seen_in: ROTATIONS,
            costs: &["quaternion"],
            variants: ways![
                OtherSlerp<slerp::StraightLine>,
                OtherSlerp<slerp::StraightLineInside>,
                OtherSlerp<slerp::AsTheyCome>,
            ],
        },
    ]
}

fn about_frames() -> Vec<Misconception> {
    vec![
        Misconception {
            id: "frame_cursor_not_moved",
            title: "You read the angles but do not move past them.",
            explanation: "There is one cursor for each frame. What a joint leaves, the next joint gets: all joints turn \
                          like the first.",
            hint: "`peek3` leaves the cursor where it is, and so does a new cursor for every joint. What moves it?",
            seen_in: ROTATIONS,
            costs: ROTATIONS,
            variants: ways![NeverMoves],
        },
        Misconception {
            id: "frame_cursor_one_short",
            title: "You take one angle too few.",
            explanation: "Every joint that rotates has three angles. The one that you leave becomes the next joint's \
                          first.",
            hint: "Count how often you take an angle for one joint.",
            seen_in: ROTATIONS,
            costs: ROTATIONS,
            variants: ways![OneShort],
        },
        Misconception {
            id: "frame_angles_for_none",
            title: "You take angles for a joint that has none.",
            explanation: "With the order NONE (an End Site, for one) the frame holds no angles for the joint. What you \
                          take belongs to the next joint.",
            hint: "Ask for `joint.rotation_order` before you take anything.",
            seen_in: ROTATIONS,
            costs: ROTATIONS,
            variants: ways![TakesOnNone<true, false>, TakesOnNone<true, true>, TakesOnNone<false, true>],
        },
        Misconception {
            id: "rotations_stay",
            title: "You leave the rotations as they are in one of the two frames.",
            explanation: "Whatever `t`, your joints are turned as in that frame: between the two there is no way to go.",
            hint: "Look at what each of your two cursors was made of, and at what becomes of `t`.",
            seen_in: ROTATIONS,
            costs: ROTATIONS,
            variants: ways![OneFrame<false>, OneFrame<true>],
        },
        Misconception {
            id: "frame_backwards",
            title: "You count `t` from the wrong frame.",
            explanation: "When `t` is 0, the result should be the first frame, and when it is 1, the second.",
            hint: "In which order do you hand the two on, and what do you make of `t`?",
            seen_in: ALL,
            costs: ALL,
            variants: ways![Backwards<true, true>],
        },
        Misconception {
            id: "rotations_backwards",
            title: "You count `t` from the wrong frame for the rotations.",
            explanation: "Your positions go from the first frame to the second, and your rotations from the second to \
                          the first.",
            hint: "In which order do you hand the two rotations on, and what do you make of `t`?",
            seen_in: ALL,
            costs: ROTATIONS,
            variants: ways![Backwards<true, false>],
        },
    ]
}

fn about_positions() -> Vec<Misconception> {
    const POSITIONS: &[&str] = &["positions"];
    vec![
        Misconception {
            id: "positions_stay",
            title: "You do not interpolate the positions.",
            explanation: "Rotations alone do not move a figure from its place: it would jump at every keyframe.",
            hint: "Both frames hold `local_positions`. Where between them is the root at `t`?",
            seen_in: POSITIONS,
            costs: POSITIONS,
            variants: ways![PositionsStay<false>, PositionsStay<true>],
        },
        Misconception {
            id: "only_the_root_moves",
            title: "You interpolate the position of the root only.",
            explanation: "Other joints can have position channels too, and a skeleton can have several roots. The frame \
                          holds a position for every joint.",
            hint: "Does a joint that never moves need another treatment, if both frames hold the same position for it?",
            seen_in: POSITIONS,
            costs: POSITIONS,
            variants: ways![
                OnlyRoots<false, 0>, OnlyRoots<false, 1>, OnlyRoots<false, 2>,
                OnlyRoots<true, 0>, OnlyRoots<true, 1>, OnlyRoots<true, 2>,
            ],
        },
        Misconception {
            id: "always_offsets",
            title: "You use the joints' offsets in the place of the frames' positions.",
            explanation: "An offset says where a joint would be without a frame. Where a frame has position channels, \
                          as for the root, they take its place.",
            hint: "What does a `Frame` hold beside the angles?",
            seen_in: POSITIONS,
            costs: POSITIONS,
            variants: ways![Offsets],
        },
        Misconception {
            id: "positions_backwards",
            title: "You count `t` from the wrong frame for the positions.",
            explanation: "Your rotations go from the first frame to the second, and your positions from the second to \
                          the first.",
            hint: "Where is the root when `t` is 0?",
            seen_in: ALL,
            costs: POSITIONS,
            variants: ways![Backwards<false, true>],
        },
    ]
}
