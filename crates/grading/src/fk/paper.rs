//! The questions of the forward-kinematics exam.

use exam::fk::Question as FkQuestion;
use exam::{Answer, Functions, Question};
use glam::Quat;
use skeleton::{Axis, Channel, Joint, Pose, RotationOrder, Skeleton, Transform};

use super::compare;
use super::misconceptions::{accepted, misconceptions};
use super::whole_motion::RightPoses;
use super::{RUBRIC, TEMPLATE};
use crate::compare::{quaternion, vector};
use crate::dice::Dice;
use crate::exam_paper::{Known, input};
use crate::figure::{self, figure};
use crate::{Case, Difference, Exam, Reference, WholeMotion};

/// Frames of the whole motion that the three parts pose together.
const WHOLE_MOTION_FRAMES: usize = 60;

/// The exam of forward kinematics. The same seed gives the same questions.
pub fn exam(seed: u64, reference: &dyn Reference) -> Exam {
    let skeleton = figure(&mut Dice::new(seed, "fk figure"));
    let writer = Writer { seed, reference, size: skeleton.extent(), skeleton: &skeleton };
    let known = Known { template: Functions::Fk(TEMPLATE), accepted, misconceptions };
    Exam::fill(&RUBRIC, &known, |part, check| writer.cases(part, check), writer.whole_motion())
}

type Compare = fn(&Case, &Answer, &Answer) -> Option<Difference>;

struct Writer<'a> {
    seed: u64,
    reference: &'a dyn Reference,
    skeleton: &'a Skeleton,
    size: f32,
}

impl Writer<'_> {
    fn cases(&self, part: &str, check: &str) -> Vec<Case> {
        let dice = &mut Dice::new(self.seed, &format!("fk {part} {check}"));
        match (part, check) {
            ("part1", "single_axis") => self.single_axis(dice),
            ("part1", "rotation_orders") => self.three_angles(dice, 4, 25.0, 80.0),
            ("part1", "big_angles") => self.three_angles(dice, 2, 200.0, 1000.0),
            ("part1", "cursor") => vec![self.cursor(dice)],
            ("part2", check) => {
                self.joints(check, 12).map(|joint| self.global_quaternion(dice, joint)).collect()
            }
            ("part3", check) => self
                .joints(check, 12)
                .map(|joint| self.global_position(dice, joint, check == "moved"))
                .collect(),
            _ => Vec::new(),
        }
    }

    /// One angle in each place of each order.
    fn single_axis(&self, dice: &mut Dice) -> Vec<Case> {
        let orders = RotationOrder::ROTATING.into_iter();
        let places = orders.flat_map(|order| (0..3).map(move |place| (order, place)));
        places
            .map(|(order, place)| {
                let mut angles = [0.0; 3];
                angles[place] = dice.angle(20.0, 160.0);
                self.local_quaternion(order, angles)
            })
            .collect()
    }

    fn three_angles(&self, dice: &mut Dice, per_order: usize, low: f32, high: f32) -> Vec<Case> {
        let orders =
            RotationOrder::ROTATING.into_iter().flat_map(|order| std::iter::repeat_n(order, per_order));
        orders
            .map(|order| self.local_quaternion(order, std::array::from_fn(|_| dice.angle(low, high))))
            .collect()
    }

    fn local_quaternion(&self, order: RotationOrder, angles: [f32; 3]) -> Case {
        let mut joint = self.skeleton.joints()[0].clone();
        let turns = order.axes().into_iter().flatten().map(Channel::Rotation);
        joint.channels = Axis::ALL.map(Channel::Position).into_iter().chain(turns).collect();
        joint.rotation_order = order;
        let axes = order.axes().into_iter().flatten();
        let listed: Vec<String> = axes.zip(angles).map(|(axis, angle)| format!("{axis} {angle}°")).collect();
        let inputs = vec![
            input("joint", format!("{}, rotation order {order}", joint.name)),
            input("angles", listed.join(", ")),
        ];
        // The next joint's angles lie behind this joint's, as in a file.
        let angles = angles.into_iter().chain([11.0, -7.0, 5.0]).collect();
        let question = FkQuestion::LocalQuaternions { joints: vec![joint], angles };
        Case { group: Some(order.to_string()), ..self.case(question, inputs, compare::rotation_of_joint) }
    }

    /// The whole figure, joint by joint, with one cursor.
    fn cursor(&self, dice: &mut Dice) -> Case {
        let joints = self.skeleton.joints().to_vec();
        let rotating = joints.iter().filter(|joint| joint.rotation_order != RotationOrder::None).count();
        let angles = (0..3 * rotating).map(|_| dice.angle(10.0, 170.0)).collect();
        let inputs = vec![
            input(
                "joints",
                format!(
                    "{rotating} with angles and {} without, one after the other",
                    joints.len() - rotating
                ),
            ),
            input("angles", format!("{}, three for each joint that has any", 3 * rotating)),
        ];
        self.case(FkQuestion::LocalQuaternions { joints, angles }, inputs, compare::cursor)
    }

    /// At most `count` joints that a check is about.
    fn joints(&self, check: &str, count: usize) -> impl Iterator<Item = &Joint> {
        let depths = self.skeleton.depths();
        let chosen = self.skeleton.joints().iter().filter(move |joint| {
            let after_parent = joint.parent.is_some_and(|parent| parent.0 + 1 == joint.id.0);
            let moves = joint.channels.iter().any(|channel| matches!(channel, Channel::Position(_)));
            match check {
                "root" => joint.is_root(),
                "child" => after_parent && !moves,
                "branch" => !after_parent && !joint.is_root() && !moves,
                "deep" => after_parent && depths[joint.id.0] >= 6,
                "moved" => after_parent && moves,
                _ => false,
            }
        });
        // Every joint serves several times, with other rotations.
        let chosen: Vec<&Joint> = chosen.collect();
        chosen.into_iter().cycle().take(count)
    }

    fn global_quaternion(&self, dice: &mut Dice, joint: &Joint) -> Case {
        let pose = self.pose_before(dice, joint);
        let local =
            if joint.rotation_order == RotationOrder::None { Quat::IDENTITY } else { dice.rotation() };
        let mut inputs = vec![self.who(joint), input("local (x, y, z, w)", quaternion(local))];
        if let Some(parent) = joint.parent {
            inputs.push(input("parent's rotation (x, y, z, w)", quaternion(pose[parent].rotation)));
        }
        let question = FkQuestion::GlobalQuaternion { joint: joint.clone(), local, pose };
        self.case(question, inputs, compare::global_rotation)
    }

    fn global_position(&self, dice: &mut Dice, joint: &Joint, moved: bool) -> Case {
        let mut pose = self.pose_before(dice, joint);
        pose[joint.id].rotation = dice.rotation();
        let moved = moved || joint.is_root();
        let local_position = if moved { figure::moved_position(dice, joint.offset) } else { joint.offset };
        let mut inputs = vec![
            self.who(joint),
            input("local position", format!("{} (file's unit)", vector(local_position))),
        ];
        if let Some(parent) = joint.parent {
            inputs.push(input("parent's position", vector(pose[parent].position)));
            inputs.push(input("parent's rotation (x, y, z, w)", quaternion(pose[parent].rotation)));
        }
        inputs.push(input("own rotation (x, y, z, w)", quaternion(pose[joint.id].rotation)));
        let question = FkQuestion::GlobalPosition { joint: joint.clone(), local_position, pose };
        self.case(question, inputs, compare::global_position)
    }

    /// A pose as the traversal has it when it comes to `joint`: all before it are turned and placed, the rest is not.
    fn pose_before(&self, dice: &mut Dice, joint: &Joint) -> Pose {
        let transforms = self.skeleton.joints().iter().map(|other| {
            if other.id < joint.id {
                Transform { rotation: dice.rotation(), position: dice.vector(10.0, 60.0) }
            } else {
                Transform::IDENTITY
            }
        });
        transforms.collect::<Vec<_>>().into()
    }

    fn who(&self, joint: &Joint) -> (String, String) {
        let name = self.skeleton.label(joint.id);
        let parent = joint
            .parent
            .map_or("a root".to_owned(), |parent| format!("child of {}", self.skeleton.label(parent)));
        input("joint", format!("{name}, {parent}"))
    }

    fn case(&self, question: FkQuestion, inputs: Vec<(String, String)>, difference: Compare) -> Case {
        let question = Question::Fk(question);
        let expected = self.reference.answer(&question);
        Case { question, expected, difference, inputs, group: None, size: self.size }
    }

    fn whole_motion(&self) -> WholeMotion {
        let dice = &mut Dice::new(self.seed, "fk whole motion");
        let motion = figure::motion(dice, self.skeleton, WHOLE_MOTION_FRAMES);
        let frames = (0..motion.frame_count()).map(|index| motion.frame(index)).collect();
        let skeleton = self.skeleton.clone();
        let question = Question::Fk(FkQuestion::Poses { skeleton: skeleton.clone(), frames });
        let expected = self.reference.answer(&question);
        let judge = Box::new(RightPoses { skeleton, question: question.clone(), expected });
        WholeMotion { question, judge }
    }
}
