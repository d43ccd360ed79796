//! Acclaim forward kinematics.

use std::ops::Range;
use std::time::Duration;

use exam::acclaim::{Answer as AcclaimAnswer, Question as AcclaimQuestion};
use exam::{Failure, Subject};
use skeleton::Pose;
use skeleton::acclaim::{BoneId, BonePlace};

use super::{put, unfit};
use crate::live::student::posed::{Extra, Posed};
use crate::motion::bones::Bones;
use crate::motion::stage::Stage;

/// Asks for the places of all bones in `frames`. A motion that has none, as before its file could be read, is not asked
/// about.
pub(in crate::live::student) fn poses(
    subject: &mut impl Subject,
    stage: &Stage,
    frames: Range<usize>,
    limit: Duration,
) -> Result<Vec<Posed>, Failure> {
    let Some(bones) = stage.bones() else {
        let joints = stage.motion().skeleton().len();
        return Ok(frames
            .map(|_| Posed { pose: Bones::nowhere(joints), extra: Extra::Bones(Vec::new()) })
            .collect());
    };
    let skeleton = bones.motion().skeleton().clone();
    let (count, expected) = (skeleton.len(), frames.len());
    let postures = frames.map(|index| stage.posture(index)).collect();
    match put(subject, AcclaimQuestion::Places { skeleton, postures }, limit)? {
        AcclaimAnswer::Places(all) if all.len() == expected && all.iter().all(|one| one.len() == count) => {
            Ok(all.into_iter().map(|places| posed(bones, places)).collect())
        }
        _ => Err(unfit()),
    }
}

fn posed(bones: &Bones, places: Vec<Option<BonePlace>>) -> Posed {
    let mut pose = Pose::default();
    bones.pose(&places, &mut pose);
    Posed { pose, extra: Extra::Bones(places) }
}

/// Asks part 3 which bones it visits, and in which order, from the root on.
pub(in crate::live::student) fn visits(
    subject: &mut impl Subject,
    stage: &Stage,
    limit: Duration,
) -> Result<Vec<BoneId>, Failure> {
    let Some(bones) = stage.bones() else { return Ok(Vec::new()) };
    let skeleton = bones.motion().skeleton().clone();
    match put(subject, AcclaimQuestion::Visits { skeleton, bone: BoneId::ROOT }, limit)? {
        AcclaimAnswer::Visits(visits) => Ok(visits),
        _ => Err(unfit()),
    }
}
