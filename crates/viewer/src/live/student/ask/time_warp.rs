//! Time warping. The functions make postures, and the reference places the bones.

use std::ops::Range;
use std::time::Duration;

use exam::time_warp::{Answer as WarpAnswer, Question as WarpQuestion};
use exam::{Answer, Failure, Question, Subject};
use skeleton::Pose;
use skeleton::acclaim::{Between, Posture};

use super::{PIECE_LIMIT, put, unfit};
use crate::live::student::posed::{Details, Extra, Posed};
use crate::motion::bones::Bones;
use crate::motion::stage::Stage;
use crate::motion::time_map::TimeMap;

/// With more bones than this in all frames together part 3 is not asked: its answer has to fit into memory.
const MOST_BONES: usize = 1_000_000;

/// Part 1 is asked about so many frames, evenly spread: enough for a curve.
const MOST_PLACES: usize = 1_000;

/// Whether part 3 makes the warped motion on `stage`, which has bones. Otherwise, in a stretch between keyframes and where
/// there are too many frames, the places of frames are right ones, and part 2 blends what is there.
pub(crate) fn is_asked_whole(stage: &Stage) -> bool {
    let Some(bones) = stage.bones() else { return false };
    let bones = bones.motion().skeleton().len();
    let fits = |count: usize| count.saturating_mul(bones) <= MOST_BONES;
    matches!(stage.warp(), Some(TimeMap::Whole { old, new }) if fits(old) && fits(new))
}

/// For its curve part 1 is asked about frame 0, and then at each step of so many frames.
pub(crate) fn places_step(map: &TimeMap) -> usize {
    map.frame_count().div_ceil(MOST_PLACES).max(1)
}

/// Asks for `frames` of a warped motion. What is not warped, or has no bones, is not asked about.
pub(in crate::live::student) fn poses(
    subject: &mut impl Subject,
    stage: &Stage,
    frames: Range<usize>,
    limit: Duration,
) -> Result<Vec<Posed>, Failure> {
    let (Some(bones), Some(map)) = (stage.bones(), stage.warp()) else {
        let joints = stage.motion().skeleton().len();
        let nothing = || Extra::Warp { given: None, place: None, bones: None };
        return Ok(frames.map(|_| Posed { pose: Bones::nowhere(joints), extra: nothing() }).collect());
    };
    if !is_asked_whole(stage) {
        let places: Vec<Between> = frames.map(|index| map.place(index)).collect();
        let postures = blends(subject, bones, &places, limit)?;
        return Ok(postures.iter().map(|posture| posed(bones, Some(posture), None, None)).collect());
    }
    let old = bones.motion();
    let postures = (0..old.frame_count()).map(|index| old.posture(index)).collect();
    let question = WarpQuestion::Motion { postures, new_count: map.frame_count() };
    let WarpAnswer::Motion(warped) = put(subject, question, limit)? else { return Err(unfit()) };
    let places = places(subject, &map, frames.clone());
    let posed =
        |(index, place): (usize, Option<Between>)| posed(bones, warped.get(index), Some(warped.len()), place);
    Ok(frames.zip(places).map(posed).collect())
}

/// Where part 1 says the frames are: some of them, and a single one in any case. Where it fails nothing is known: part 3 need
/// not call it.
fn places(subject: &mut impl Subject, map: &TimeMap, frames: Range<usize>) -> Vec<Option<Between>> {
    let step = if frames.len() == 1 { 1 } else { places_step(map) };
    let asked: Vec<usize> = frames.clone().filter(|index| index % step == 0).collect();
    let (answers, _) = positions(subject, map, &asked);
    let mut places = vec![None; frames.len()];
    for (index, place) in asked.iter().zip(answers) {
        places[index - frames.start] = Some(place);
    }
    places
}

/// Asks part 1 where each of these `frames` is. Gives the places before the first frame at which it fails, and how it does.
pub(in crate::live::student) fn positions(
    subject: &mut impl Subject,
    map: &TimeMap,
    frames: &[usize],
) -> (Vec<Between>, Option<Failure>) {
    let (old_count, new_count) = (map.old_count(), map.frame_count());
    let question = |new_frame: &usize| {
        Question::TimeWarp(WarpQuestion::Position { new_frame: *new_frame, old_count, new_count })
    };
    let mut places = Vec::with_capacity(frames.len());
    for frames in frames.chunks(MOST_PLACES) {
        let questions: Vec<Question> = frames.iter().map(question).collect();
        let (answers, failure) = subject.ask_all(&questions.iter().collect::<Vec<_>>(), PIECE_LIMIT);
        for answer in answers {
            let Answer::TimeWarp(WarpAnswer::Position(place)) = answer else {
                return (places, Some(unfit()));
            };
            places.push(place);
        }
        if failure.is_some() {
            return (places, failure);
        }
    }
    (places, None)
}

/// What part 2 makes of each of these places in the old motion.
pub(in crate::live::student) fn blends(
    subject: &mut impl Subject,
    bones: &Bones,
    places: &[Between],
    limit: Duration,
) -> Result<Vec<Posture>, Failure> {
    let questions: Vec<Question> = places.iter().map(|place| blend(bones, *place)).collect();
    let (answers, failure) = subject.ask_all(&questions.iter().collect::<Vec<_>>(), limit);
    if let Some(failure) = failure {
        return Err(failure);
    }
    let posture = |answer| match answer {
        Answer::TimeWarp(WarpAnswer::Blend(posture)) => Ok(posture),
        _ => Err(unfit()),
    };
    let postures = answers.into_iter().map(posture).collect::<Result<Vec<_>, _>>()?;
    if postures.len() == places.len() { Ok(postures) } else { Err(unfit()) }
}

fn blend(bones: &Bones, Between { before, after, t }: Between) -> Question {
    let [from, to] = [before, after].map(|index| bones.motion().posture(index));
    Question::TimeWarp(WarpQuestion::Blend { from, to, t })
}

/// Whether the old motion has both frames.
pub(in crate::live::student) fn is_there(map: &TimeMap, place: &Between) -> bool {
    place.before.max(place.after) < map.old_count()
}

/// Asks part 2 what is in frame `frame`: at its right place, and at that which part 1 says, where that is
/// [at work](is_asked_whole).
pub(in crate::live::student) fn details(
    subject: &mut impl Subject,
    stage: &Stage,
    frame: usize,
    limit: Duration,
) -> Result<Details, Failure> {
    let (Some(bones), Some(map)) = (stage.bones(), stage.warp()) else { return Err(unfit()) };
    let place = match is_asked_whole(stage) {
        true => places(subject, &map, frame..frame + 1).pop().flatten(),
        false => None,
    };
    let own = place.filter(|place| is_there(&map, place));
    let places: Vec<Between> = [map.place(frame)].into_iter().chain(own).collect();
    let postures = blends(subject, bones, &places, limit)?;
    let mut poses = postures.iter().map(|posture| pose(bones, posture));
    let right = poses.next().ok_or_else(unfit)?;
    Ok(Details::Blended { right, place, own: poses.next() })
}

fn posed(bones: &Bones, posture: Option<&Posture>, given: Option<usize>, place: Option<Between>) -> Posed {
    let nowhere = || Bones::nowhere(bones.joint_count());
    let all = bones.motion().skeleton().len();
    let counts = posture.map(|posture| [posture.angles.len(), posture.translations.len()]);
    let other = counts.into_iter().flatten().find(|count| *count != all);
    let pose = posture.map_or_else(nowhere, |posture| pose(bones, posture));
    Posed { pose, extra: Extra::Warp { given, place, bones: other } }
}

/// Where the joints are in a posture, of which bones may be missing: these are not turned.
fn pose(bones: &Bones, posture: &Posture) -> Pose {
    let mut pose = Pose::default();
    bones.pose(&bones.reference(posture), &mut pose);
    pose
}
