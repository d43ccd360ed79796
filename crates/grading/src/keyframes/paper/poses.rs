//! Part 1: poses of which some joints are off.

use exam::keyframes::Question as KeyframesQuestion;
use glam::Vec3;
use skeleton::{JointId, Pose, Skeleton, pose_frame};

use super::{Draft, input};
use crate::dice::Dice;
use crate::figure::{figure, motion};
use crate::keyframes::variants::error::is_tip;

/// Joints that have no End Site in the check about leaves. Among the tips none of them is the first or the last.
const BARE: [&str; 3] = ["RightFoot", "Head", "LeftHand"];

pub(super) fn drafts(dice: &mut Dice, check: &str) -> Vec<Draft> {
    let skeleton = figure(dice);
    match check {
        "one_tip" => {
            let two = TwoPoses::of(dice, skeleton);
            two.tips().iter().map(|tip| two.draft(&off(dice, &[*tip]))).collect()
        }
        "all_tips" => {
            let two = TwoPoses::of(dice, skeleton);
            (0..4).map(|_| two.draft(&off(dice, &two.tips()))).collect()
        }
        "only_tips" => {
            let two = TwoPoses::of(dice, skeleton);
            let inner = two.inner();
            let single = inner.iter().step_by(4).map(|id| vec![*id]);
            single.chain([inner.clone()]).map(|ids| two.draft(&off(dice, &ids))).collect()
        }
        "leaves" => {
            let some = TwoPoses::of(dice, without_end_sites(&skeleton, |name| BARE.contains(&name)));
            let none = TwoPoses::of(dice, without_end_sites(&skeleton, |_| true));
            let mut drafts = Vec::new();
            for two in [some, none] {
                let tips = two.tips();
                let between = &tips[1..tips.len() - 1];
                let bare = between.iter().filter(|tip| !two.skeleton.joints()[tip.0].is_end_site);
                drafts.extend(bare.map(|tip| two.draft(&off(dice, &[*tip]))));
            }
            drafts
        }
        _ => Vec::new(),
    }
}

/// By how much each of these joints is off.
fn off(dice: &mut Dice, joints: &[JointId]) -> Vec<(JointId, Vec3)> {
    joints.iter().map(|id| (*id, dice.vector(1.0, 6.0))).collect()
}

/// The same skeleton without the End Sites of the joints with these names.
fn without_end_sites(skeleton: &Skeleton, bare: impl Fn(&str) -> bool) -> Skeleton {
    let mut copy = Skeleton::new();
    // For each joint its id in the copy. Nothing hangs on what is left out.
    let mut ids: Vec<JointId> = Vec::new();
    for joint in skeleton.joints() {
        let parent = joint.parent.map(|parent| ids[parent.0]);
        let is_left_out =
            joint.is_end_site && joint.parent.is_some_and(|parent| bare(&skeleton.joints()[parent.0].name));
        let added = match parent {
            _ if is_left_out => Ok(JointId(copy.len())),
            Some(parent) if joint.is_end_site => copy.add_end_site(parent, &*joint.name, joint.offset),
            _ => copy.add_joint(parent, &*joint.name, joint.offset, joint.channels.clone()),
        };
        ids.push(added.expect("the joints come from a skeleton, parents first"));
    }
    copy
}

/// A pose of a skeleton, and the joints' rotations in another one.
struct TwoPoses {
    skeleton: Skeleton,
    original: Pose,
    turned: Pose,
}

impl TwoPoses {
    fn of(dice: &mut Dice, skeleton: Skeleton) -> TwoPoses {
        let motion = motion(dice, &skeleton, 2);
        let pose = |frame| {
            let mut pose = Pose::default();
            pose_frame(&skeleton, &motion.frame(frame), &solutions::FK, &mut pose);
            pose
        };
        TwoPoses { original: pose(0), turned: pose(1), skeleton }
    }

    fn tips(&self) -> Vec<JointId> {
        self.ids(true)
    }

    fn inner(&self) -> Vec<JointId> {
        self.ids(false)
    }

    fn ids(&self, tips: bool) -> Vec<JointId> {
        let joints = self.skeleton.joints().iter();
        joints.filter(|joint| is_tip(&self.skeleton, joint) == tips).map(|joint| joint.id).collect()
    }

    /// In the interpolated pose these joints are off, and all others are in their places.
    fn draft(&self, off: &[(JointId, Vec3)]) -> Draft {
        let mut interpolated = self.turned.clone();
        for joint in self.skeleton.joints() {
            interpolated[joint.id].position = self.original[joint.id].position;
        }
        for (id, by) in off {
            interpolated[*id].position += *by;
        }
        let question = KeyframesQuestion::PoseError {
            skeleton: self.skeleton.clone(),
            original: self.original.clone(),
            interpolated,
        };
        Draft { question, inputs: self.inputs(off), group: None, size: self.skeleton.extent() }
    }

    fn inputs(&self, off: &[(JointId, Vec3)]) -> Vec<(String, String)> {
        let tips = self.tips();
        let joints = format!("{}, {} of them tips", self.skeleton.len(), tips.len());
        let mut inputs = vec![input("joints and End Sites", joints)];
        if off.len() > tips.len() {
            inputs.push(input("off", format!("all {} that are no tips", off.len())));
            return inputs;
        }
        for (id, by) in off {
            let hangs = if self.skeleton.joints()[id.0].is_end_site {
                ""
            } else if tips.contains(id) {
                ", on which nothing hangs"
            } else {
                ", which is no tip"
            };
            let by = format!("by ({}, {}, {}){hangs}", by.x, by.y, by.z);
            inputs.push(input(format!("{} is off", self.skeleton.label(*id)), by));
        }
        inputs
    }
}
