//! Part 3: single joints of each order, and whole figures.

use exam::Question;
use exam::interpolation::Question as InterpolationQuestion;
use glam::Quat;
use skeleton::{Axis, Channel, Frame, FrameCursor, Joint, Representation, RotationOrder, Skeleton};

use super::{BETWEEN, Compare, Writer, input};
use crate::dice::{Dice, two_decimals};
use crate::figure::moved_position;
use crate::interpolation::compare;
use crate::interpolation::variants::quaternion;
use crate::interpolation::whole_motion::RightFrames;
use crate::{Case, WholeMotion};

/// How far it is to the frames of whole figures. Half-way, even some wrong ways are right.
const TIMES: [f32; 3] = [0.25, 0.6, 0.9];

/// The same for positions, with both frames themselves.
const TIMES_OF_POSITIONS: [f32; 5] = [0.5, 0.25, 0.8, 0.0, 1.0];

/// Into how many steps the way of the whole motion is divided.
const STEPS: u8 = 8;

/// The rotations of one joint in each order, and then of whole figures.
pub(super) fn rotations(writer: &Writer, dice: &mut Dice, skeleton: &Skeleton, check: &str) -> Vec<Case> {
    let representation = if check == "euler" { Representation::Euler } else { Representation::Quaternion };
    let single = RotationOrder::ROTATING.into_iter().zip(BETWEEN.into_iter().rev());
    let mut cases: Vec<Case> =
        single.map(|(order, t)| one_joint(writer, dice, order, t, representation)).collect();
    cases.extend(TIMES.map(|t| {
        let frames = frames(dice, skeleton);
        ask(writer, skeleton, frames, t, representation, compare::rotations)
    }));
    cases
}

/// The positions of whole figures, in both representations in turns.
pub(super) fn positions(writer: &Writer, dice: &mut Dice, skeleton: &Skeleton) -> Vec<Case> {
    let representations = Representation::ALL.into_iter().cycle();
    let case = |(t, representation)| {
        let frames = frames(dice, skeleton);
        ask(writer, skeleton, frames, t, representation, compare::positions)
    };
    TIMES_OF_POSITIONS.into_iter().zip(representations).map(case).collect()
}

/// Several moments between two frames of the figure, with quaternions.
pub(super) fn whole_motion(writer: &Writer, dice: &mut Dice, skeleton: &Skeleton) -> WholeMotion {
    let [from, to] = frames(dice, skeleton);
    let ts: Vec<f32> = (0..=STEPS).map(|step| f32::from(step) / f32::from(STEPS)).collect();
    let question = Question::Interpolation(InterpolationQuestion::Between {
        skeleton: skeleton.clone(),
        from,
        to,
        ts: ts.clone(),
        representation: Representation::Quaternion,
    });
    let expected = writer.reference.answer(&question);
    let judge =
        Box::new(RightFrames { skeleton: skeleton.clone(), ts, question: question.clone(), expected });
    WholeMotion { question, judge }
}

/// A root and its tip, with angles that pass neither 0 nor ±180 degrees.
fn one_joint(
    writer: &Writer,
    dice: &mut Dice,
    order: RotationOrder,
    t: f32,
    representation: Representation,
) -> Case {
    let mut skeleton = Skeleton::new();
    let turns = order.axes().into_iter().flatten().map(Channel::Rotation);
    let channels: Vec<Channel> = Axis::ALL.map(Channel::Position).into_iter().chain(turns).collect();
    let root = skeleton
        .add_joint(None, "Hips", dice.vector(2.0, 9.0), channels)
        .expect("a root has no parent that could be missing, and an order names every axis once");
    skeleton.add_end_site(root, "End Site", dice.vector(3.0, 6.0)).expect("the parent has just been added");
    let frames = between_angles(dice, &skeleton, |dice| {
        let from = dice.angle(5.0, 80.0);
        (from, from + from.signum() * dice.between(30.0, 90.0))
    });
    let listed = |frame: &Frame| {
        let axes = order.axes().into_iter().flatten().zip(&frame.angles);
        axes.map(|(axis, angle)| format!("{axis} {angle}°")).collect::<Vec<_>>().join(", ")
    };
    let mut inputs = vec![
        input("joint", format!("Hips, rotation order {order}")),
        input("angles, from", listed(&frames[0])),
        input("angles, to", listed(&frames[1])),
    ];
    let case = ask(writer, &skeleton, frames, t, representation, compare::rotations);
    inputs.extend(case.inputs.into_iter().skip(1));
    Case { group: Some(order.to_string()), inputs, ..case }
}

/// Two frames of a figure in which everything changes. Angles pass ±180 degrees, some jump there and some go on counting
/// as in a file; some have full turns between them.
fn frames(dice: &mut Dice, skeleton: &Skeleton) -> [Frame; 2] {
    between_angles(dice, skeleton, |dice| {
        let from = dice.angle(5.0, 175.0);
        let to = from + dice.angle(20.0, 150.0);
        let to = match dice.below(4) {
            0 => to,
            1 => to + 360.0,
            2 => to - 720.0,
            _ if to > 180.0 => to - 360.0,
            _ if to < -180.0 => to + 360.0,
            _ => to,
        };
        (from, to)
    })
}

/// Two frames with the angles that `throw` gives. No joint turns by nearly nothing or nearly half a turn, where wrong ways
/// are right, or both ways equally long.
fn between_angles(
    dice: &mut Dice,
    skeleton: &Skeleton,
    throw: impl Fn(&mut Dice) -> (f32, f32),
) -> [Frame; 2] {
    let [mut from, mut to] = [Frame::default(), Frame::default()];
    for joint in skeleton.joints() {
        if joint.rotation_order != RotationOrder::None {
            let angles = |dice: &mut Dice| {
                let legs: [(f32, f32); 3] = std::array::from_fn(|_| throw(dice));
                [legs.map(|(from, _)| two_decimals(from)), legs.map(|(_, to)| two_decimals(to))]
            };
            let is_clear = |[from, to]: &[[f32; 3]; 2]| {
                let cosine = quaternion(joint, *from).dot(quaternion(joint, *to)).abs();
                (0.2..0.98).contains(&cosine)
            };
            let mut thrown = angles(dice);
            while !is_clear(&thrown) {
                thrown = angles(dice);
            }
            from.angles.extend(thrown[0]);
            to.angles.extend(thrown[1]);
        }
        let moves = joint.channels.iter().any(|channel| matches!(channel, Channel::Position(_)));
        let mut position = || if moves { moved_position(dice, joint.offset) } else { joint.offset };
        from.local_positions.push(position());
        to.local_positions.push(position());
    }
    [from, to]
}

fn ask(
    writer: &Writer,
    skeleton: &Skeleton,
    [from, to]: [Frame; 2],
    t: f32,
    representation: Representation,
    difference: Compare,
) -> Case {
    let joints = skeleton.joints();
    let rotating = joints.iter().filter(|joint| joint.rotation_order != RotationOrder::None).count();
    let inputs = vec![
        input("joints", format!("{rotating} with angles and {} without", joints.len() - rotating)),
        input("representation", representation.to_string()),
        input("t", t.to_string()),
    ];
    let ends = [&from, &to].map(|frame| local_rotations(skeleton, frame));
    let skeleton = skeleton.clone();
    let size = skeleton.extent();
    let question = InterpolationQuestion::Frame { skeleton, from, to, t, representation, ends };
    Case { size, ..writer.case(question, inputs, difference) }
}

fn local_rotations(skeleton: &Skeleton, frame: &Frame) -> Vec<Quat> {
    let mut cursor = FrameCursor::new(&frame.angles);
    let rotation = |joint: &Joint| match joint.rotation_order {
        RotationOrder::None => Quat::IDENTITY,
        _ => quaternion(joint, cursor.take3()),
    };
    skeleton.joints().iter().map(rotation).collect()
}
