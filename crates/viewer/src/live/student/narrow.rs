//! Where in a frame the student's functions panic, crash or never come back.
//!
//! The traversal visits joint after joint, parents first, and no further than there are local positions. So a frame that
//! fails is asked again with fewer of these, and nothing else is different for the functions: the skeleton, the angles
//! and the pose's length stay.

use exam::fk::{Answer as FkAnswer, Question as FkQuestion};
use exam::{Failure, Subject};
use skeleton::{Frame, JointId, Pose};

use super::ask::{self, JOINTS_LIMIT};
use crate::live::worker::Trouble;
use crate::motion::stage::Stage;

/// What is known about the place.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Place {
    /// The joint at which it happens.
    pub(super) joint: Option<JointId>,
    /// The part, from 0, in which it happens.
    pub(super) part: Option<usize>,
}

/// What is wrong with frame `index`, which fails as `failure` says, and where.
pub(crate) fn explain(subject: &mut impl Subject, stage: &Stage, index: usize, failure: &Failure) -> Trouble {
    let place = find(subject, stage, index, failure);
    trouble(stage, index, failure, place)
}

/// Finds the place at which frame `index` fails as `failure` says. What is not the same each time is not told.
pub(super) fn find(subject: &mut impl Subject, stage: &Stage, index: usize, failure: &Failure) -> Place {
    let frame = stage.frame(index);
    let Some(joint) = joint(subject, stage, &frame, failure) else { return Place::default() };
    Place { joint: Some(joint), part: part(subject, stage, &frame, joint, failure) }
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
    let mut poses = ask::poses(subject, stage, vec![cut], JOINTS_LIMIT)?;
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
    let local = match ask::locals(subject, joints, frame.angles.clone(), JOINTS_LIMIT) {
        Ok(locals) => locals.last()?.rotation,
        Err(other) => return failing(0, &other),
    };
    let mut pose = first_joints(subject, stage, frame, joint.0).ok()?;
    let question = FkQuestion::GlobalQuaternion { joint: this.clone(), local, pose: pose.clone() };
    match ask::put(subject, question, JOINTS_LIMIT) {
        Ok(FkAnswer::GlobalQuaternion(rotation)) => pose[joint].rotation = rotation,
        Ok(_) => return None,
        Err(other) => return failing(1, &other),
    }
    let local_position = *frame.local_positions.get(joint.0)?;
    let question = FkQuestion::GlobalPosition { joint: this.clone(), local_position, pose };
    ask::put(subject, question, JOINTS_LIMIT).err().and_then(|other| failing(2, &other))
}

fn same_kind(one: &Failure, other: &Failure) -> bool {
    std::mem::discriminant(one) == std::mem::discriminant(other)
}

/// What is told of frame `index`, in words for the student.
pub(super) fn trouble(stage: &Stage, index: usize, failure: &Failure, place: Place) -> Trouble {
    let mut trouble = Trouble::from(failure.clone());
    let joint = place.joint.map(|joint| {
        let label: String = stage.motion().skeleton().label(joint).chars().take(60).collect();
        format!("at joint {}, ", parser::printable(&label))
    });
    trouble.details.push(format!("{}in frame {index}", joint.unwrap_or_default()));
    if let Some(part) = place.part.and_then(|part| grading::fk::RUBRIC.parts.get(part)) {
        trouble.details.push(format!("in {}, {}", part.id, part.function));
    }
    trouble
}

impl From<Failure> for Trouble {
    fn from(failure: Failure) -> Trouble {
        // A panic's message may be of any length.
        let text: String = failure.to_string().chars().take(600).collect();
        let mut lines = text.lines().take(8).map(str::to_owned);
        Trouble { headline: lines.next().unwrap_or_default(), details: lines.collect() }
    }
}
