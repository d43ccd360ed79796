//! Forward kinematics: the joint.
//!
//! The traversal visits joint after joint, parents first, and no further than there are local positions. So a frame that
//! fails is asked again with fewer of these, and nothing else is different for the functions: the skeleton, the angles
//! and the pose's length stay.

use exam::fk::{Answer as FkAnswer, Question as FkQuestion};
use exam::{Failure, Subject};
use skeleton::{Frame, JointId, Pose};

use super::super::ask::{self, PIECE_LIMIT};
use super::{Place, same_kind, short};
use crate::motion::stage::Stage;

pub(super) fn find(subject: &mut impl Subject, stage: &Stage, index: usize, failure: &Failure) -> Place {
    let frame = stage.frame(index);
    let Some(joint) = joint(subject, stage, &frame, failure) else { return Place::default() };
    let at = format!("joint {}", short(&stage.motion().skeleton().label(joint)));
    Place { at: Some(at), part: part(subject, stage, &frame, joint, failure), ..Place::default() }
}

/// The first joint at which it fails.
fn joint(subject: &mut impl Subject, stage: &Stage, frame: &Frame, failure: &Failure) -> Option<JointId> {
    // Gives whether the first `count` joints are answered, or nothing when that cannot be told.
    let mut fine = |count: usize| match first_joints(subject, stage, frame, count) {
        Ok(_) => Some(true),
        Err(other) => same_kind(&other, failure).then_some(false),
    };
    let (mut good, mut bad) = (0, frame.local_positions.len());
    while bad - good > 1 {
        let middle = good.midpoint(bad);
        match fine(middle)? {
            true => good = middle,
            false => bad = middle,
        }
    }
    // Functions that do one thing now and another later could have led anywhere.
    let is_so = bad > 0 && !fine(bad)? && fine(bad - 1)?;
    is_so.then(|| JointId(bad - 1))
}

fn first_joints(
    subject: &mut impl Subject,
    stage: &Stage,
    frame: &Frame,
    count: usize,
) -> Result<Pose, Failure> {
    let mut cut = frame.clone();
    cut.local_positions.truncate(count);
    ask::warm_up(subject)?;
    let mut poses = ask::fk::poses(subject, stage, vec![cut], PIECE_LIMIT)?;
    poses.pop().map(|posed| posed.pose).ok_or_else(ask::unfit)
}

/// The part that fails when it is asked for this joint alone.
fn part(
    subject: &mut impl Subject,
    stage: &Stage,
    frame: &Frame,
    joint: JointId,
    failure: &Failure,
) -> Option<usize> {
    let failing = |part: usize, other: &Failure| same_kind(other, failure).then_some(part);
    let joints = &stage.motion().skeleton().joints()[..=joint.0];
    let this = joints.last()?;
    ask::warm_up(subject).ok()?;
    let local = match ask::fk::locals(subject, joints, frame.angles.clone(), PIECE_LIMIT) {
        Ok(locals) => locals.last()?.rotation,
        Err(other) => return failing(0, &other),
    };
    let mut pose = first_joints(subject, stage, frame, joint.0).ok()?;
    let question = FkQuestion::GlobalQuaternion { joint: this.clone(), local, pose: pose.clone() };
    match ask::put(subject, question, PIECE_LIMIT) {
        Ok(FkAnswer::GlobalQuaternion(rotation)) => pose[joint].rotation = rotation,
        Ok(_) => return None,
        Err(other) => return failing(1, &other),
    }
    let local_position = *frame.local_positions.get(joint.0)?;
    let question = FkQuestion::GlobalPosition { joint: this.clone(), local_position, pose };
    ask::put::<FkAnswer>(subject, question, PIECE_LIMIT).err().and_then(|other| failing(2, &other))
}
