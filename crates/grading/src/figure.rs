//! Skeletons and motions that questions are about.

use glam::Vec3;
use skeleton::{Axis, Channel, JointId, Motion, RotationOrder, Skeleton};

use crate::dice::Dice;

/// The names and parents of the figure's joints. Below `Chain1` hangs a chain of seven more, and `Prop` is a root of
/// its own: what a figure holds in its hand is recorded like that.
const JOINTS: [(&str, Option<usize>); 21] = [
    ("Hips", None),
    ("LeftUpLeg", Some(0)),
    ("LeftLeg", Some(1)),
    ("LeftFoot", Some(2)),
    ("RightUpLeg", Some(0)),
    ("RightLeg", Some(4)),
    ("RightFoot", Some(5)),
    ("Spine", Some(0)),
    ("Chest", Some(7)),
    ("Neck", Some(8)),
    ("Head", Some(9)),
    ("LeftShoulder", Some(8)),
    ("LeftArm", Some(11)),
    ("LeftForeArm", Some(12)),
    ("LeftHand", Some(13)),
    ("RightShoulder", Some(8)),
    ("RightArm", Some(15)),
    ("RightForeArm", Some(16)),
    ("RightHand", Some(17)),
    ("Tail", Some(0)),
    ("Prop", None),
];

/// How many joints hang below the tail.
const CHAIN: usize = 8;

/// A figure with all six rotation orders and joints without rotation, mixed; joints with six channels; several children
/// on one joint; a deep chain; and two roots that are not at the origin.
pub(crate) fn figure(dice: &mut Dice) -> Skeleton {
    let mut skeleton = Skeleton::new();
    let mut ids: Vec<JointId> = Vec::new();
    let mut orders = Orders::default();
    for (index, (name, parent)) in JOINTS.into_iter().enumerate() {
        let parent = parent.map(|parent| ids[parent]);
        // Both shoulders are plain links without a rotation of their own.
        let order = if name.ends_with("Shoulder") { RotationOrder::None } else { orders.next(dice) };
        let moved = parent.is_none() || matches!(name, "LeftArm" | "RightLeg" | "Neck");
        let id = add(&mut skeleton, dice, parent, name, order, moved);
        ids.push(id);
        let is_tip = !JOINTS.iter().any(|(_, parent)| *parent == Some(index));
        if name == "Tail" {
            let mut last = id;
            for link in 1..=CHAIN {
                let order = orders.next(dice);
                last = add(&mut skeleton, dice, Some(last), &format!("Chain{link}"), order, false);
            }
            add_tip(&mut skeleton, dice, last);
        } else if is_tip {
            add_tip(&mut skeleton, dice, id);
        }
    }
    skeleton
}

fn add(
    skeleton: &mut Skeleton,
    dice: &mut Dice,
    parent: Option<JointId>,
    name: &str,
    order: RotationOrder,
    moved: bool,
) -> JointId {
    let mut channels = Vec::new();
    if moved {
        channels.extend(Axis::ALL.map(Channel::Position));
    }
    channels.extend(order.axes().into_iter().flatten().map(Channel::Rotation));
    let added = skeleton.add_joint(parent, name, dice.vector(2.0, 9.0), channels);
    added.expect("the table above lists parents first and every channel once")
}

fn add_tip(skeleton: &mut Skeleton, dice: &mut Dice, parent: JointId) {
    let added = skeleton.add_end_site(parent, "End Site", dice.vector(1.0, 4.0));
    added.expect("the parent has just been added");
}

/// Deals out the six orders, each once before any comes again.
#[derive(Default)]
struct Orders(Vec<RotationOrder>);

impl Orders {
    fn next(&mut self, dice: &mut Dice) -> RotationOrder {
        if self.0.is_empty() {
            self.0.extend(RotationOrder::ROTATING);
            dice.shuffle(&mut self.0);
        }
        self.0.pop().unwrap_or_default()
    }
}

/// A motion of `frames` frames in which every channel changes steadily, far beyond a full turn.
pub(crate) fn motion(dice: &mut Dice, skeleton: &Skeleton, frames: usize) -> Motion {
    let tracks: Vec<(f32, f32)> = skeleton
        .joints()
        .iter()
        .flat_map(|joint| &joint.channels)
        .map(|channel| match channel {
            Channel::Position(_) => (dice.angle(5.0, 40.0), dice.angle(0.1, 1.0)),
            Channel::Rotation(_) => (dice.angle(10.0, 400.0), dice.angle(1.0, 9.0)),
        })
        .collect();
    let values =
        (0..frames).flat_map(|frame| tracks.iter().map(move |(start, step)| start + step * frame as f32));
    Motion::new(skeleton.clone(), frames, 1.0 / 30.0, values.collect())
        .expect("one value per channel and frame")
}

/// A position that is not the joint's offset.
pub(crate) fn moved_position(dice: &mut Dice, offset: Vec3) -> Vec3 {
    offset + dice.vector(3.0, 8.0)
}
