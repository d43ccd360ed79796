//! The three parts together, over several postures of a figure.

use std::iter::successors;

use exam::acclaim::{Answer as AcclaimAnswer, Question as AcclaimQuestion};
use exam::{Answer, Failure, Question};
use glam::Quat;
use skeleton::acclaim::{Bone, BoneId, BonePlace, Posture, Skeleton};

use super::figure::{figure, posture};
use super::misconceptions::accepted;
use crate::compare::{POSITION_TOLERANCE, between_rotations};
use crate::dice::Dice;
use crate::{Judge, Reference, Trouble, WholeMotion, WholeReport};

/// How many postures there are, the first of which is the rest pose.
const FRAMES: usize = 9;

/// All parts together, over postures from this seed.
pub(super) fn paper(seed: u64, reference: &dyn Reference) -> WholeMotion {
    let dice = &mut Dice::new(seed, "acclaim whole motion");
    let skeleton = figure(dice);
    let moved = (1..FRAMES).map(|_| posture(dice, &skeleton));
    let postures = [Posture::rest(&skeleton)].into_iter().chain(moved).collect();
    let question = Question::Acclaim(AcclaimQuestion::Places { skeleton: skeleton.clone(), postures });
    let expected = reference.answer(&question);
    let judge = Box::new(RightPlaces { skeleton, question: question.clone(), expected });
    WholeMotion { question, judge }
}

/// Knows where all bones are, and looks for the bone where others begin to go wrong.
#[derive(Debug)]
struct RightPlaces {
    skeleton: Skeleton,
    question: Question,
    expected: Answer,
}

impl Judge for RightPlaces {
    fn judge(&self, answer: &Answer) -> WholeReport {
        let (Some(expected), Some(got)) = (places(&self.expected), self.fitting(answer)) else {
            let why = "the places do not fit the skeleton".to_owned();
            return WholeReport::failed(Failure::Unreadable { why });
        };
        let frames = expected.len();
        let praise = format!("With your three functions every bone is in its place in all {frames} frames.");
        let report = |trouble| WholeReport { frames, praise, trouble };
        if self.first_off(expected, got).is_none() {
            return report(None);
        }
        // What part 1 accepts is accepted here too.
        let ways: Vec<Answer> =
            accepted("part1").iter().map(|way| self.question.ask(&way.functions)).collect();
        let is_accepted = |way: &Answer| places(way).is_some_and(|way| self.first_off(way, got).is_none());
        report(if ways.iter().any(is_accepted) { None } else { self.trouble(expected, got) })
    }
}

/// Those of all bones; nothing for a bone that was not visited.
type Places = Vec<Option<BonePlace>>;

fn places(answer: &Answer) -> Option<&[Places]> {
    match answer {
        Answer::Acclaim(AcclaimAnswer::Places(places)) => Some(places),
        _ => None,
    }
}

impl RightPlaces {
    /// The places, if there is one for every bone in every frame.
    fn fitting<'a>(&self, got: &'a Answer) -> Option<&'a [Places]> {
        let frames = places(&self.expected)?.len();
        let is_whole = |frame: &Places| frame.len() == self.skeleton.len();
        places(got).filter(|got| got.len() == frames && got.iter().all(is_whole))
    }

    fn trouble(&self, expected: &[Places], got: &[Places]) -> Option<Trouble> {
        let (frame, first) = self.first_off(expected, got)?;
        let bone = self.skeleton.get(first)?;
        let right = expected[frame][first.0].unwrap_or(BonePlace::ORIGIN);
        let how = match got[frame][first.0] {
            None => "it is not visited".to_owned(),
            Some(place) => {
                let (start, end) = (right.start.distance(place.start), right.end.distance(place.end));
                if self.is_off(end) {
                    format!("its end is {}", distance(end))
                } else {
                    format!("its start is {}, and its end in its place", distance(start))
                }
            }
        };
        let is_off = |frame: usize, id: BoneId| self.is_bone_off(&expected[frame][id.0], &got[frame][id.0]);
        let others = self.skeleton.bones().iter().filter(|other| is_off(frame, other.id)).count();
        let parent = bone.parent.and_then(|parent| self.skeleton.get(parent));
        let mut details = vec![match parent {
            Some(parent) => self.about_parent(bone, parent, expected, got, frame),
            None => "All others hang on it, directly or not.".to_owned(),
        }];
        details.push(format!("In this frame {others} of {} bones are off.", self.skeleton.len()));
        details.push(match frame {
            0 => "Frame 0 is the rest pose, in which all angles are zero.".to_owned(),
            _ => "In frame 0, the rest pose, all bones are in their places.".to_owned(),
        });
        let summary = format!(
            "With your three functions together, the first bone that is off is {} in frame {frame}: {how}.",
            bone.name
        );
        Some(Trouble::Different { summary, details })
    }

    /// Where to look when `bone` is off in this frame and its parent, with whatever that hangs on, is not.
    fn about_parent(
        &self,
        bone: &Bone,
        parent: &Bone,
        expected: &[Places],
        got: &[Places],
        frame: usize,
    ) -> String {
        // Who counts all rotations from the rest pose, the root's too, may do so.
        let is_rotation = |right: fn(&Bone, Quat) -> Quat, frame: usize, bone: &Bone| {
            let [expected, got] = [expected, got].map(|places| places[frame][bone.id.0]);
            let (Some(expected), Some(got)) = (expected, got) else { return true };
            between_rotations(right(bone, expected.rotation), got.rotation).is_none()
        };
        let from_rest = |bone: &Bone, rotation: Quat| rotation * bone.axis_rotation.inverse();
        let is_from_rest =
            (0..expected.len()).all(|frame| is_rotation(from_rest, frame, self.skeleton.root()));
        let right = if is_from_rest { from_rest } else { |_: &Bone, rotation: Quat| rotation };
        let is_turned = |bone: &Bone| !is_rotation(right, frame, bone);
        let is_visited = got[frame][bone.id.0].is_some();
        if !is_visited || !is_turned(parent) {
            return format!(
                "Its parent, {}, is in its place: look at what becomes of {}.",
                parent.name, bone.name
            );
        }
        let above = |bone: &Bone| bone.parent.and_then(|parent| self.skeleton.get(parent));
        let turned = successors(Some(parent), |bone| above(bone).filter(|above| is_turned(above)));
        let first = turned.last().unwrap_or(parent);
        format!(
            "Its parent, {}, is in its place, but turned otherwise than it should be: look at how {} is turned.",
            parent.name, first.name
        )
    }

    /// The first frame with a bone that is off, and the first such bone in it: its parent is in its place.
    fn first_off(&self, expected: &[Places], got: &[Places]) -> Option<(usize, BoneId)> {
        let frames = expected.iter().zip(got).enumerate();
        let mut all = frames.flat_map(|(frame, (expected, got))| {
            let bones = expected.iter().zip(got).enumerate();
            bones.map(move |(id, (expected, got))| (frame, BoneId(id), expected, got))
        });
        all.find(|(_, _, expected, got)| self.is_bone_off(expected, got)).map(|(frame, id, _, _)| (frame, id))
    }

    /// What is seen of a bone is where it starts and ends. Who counts its rotation from elsewhere, and uses it so, is right.
    fn is_bone_off(&self, expected: &Option<BonePlace>, got: &Option<BonePlace>) -> bool {
        let (Some(expected), Some(got)) = (expected, got) else { return true };
        let pairs = [(expected.start, got.start), (expected.end, got.end)];
        pairs.into_iter().any(|(expected, got)| self.is_off(expected.distance(got)))
    }

    /// What is not a number is off, too.
    fn is_off(&self, distance: f32) -> bool {
        distance.is_nan() || distance > POSITION_TOLERANCE * self.skeleton.extent()
    }
}

fn distance(distance: f32) -> String {
    if distance.is_finite() {
        format!("{distance:.3} (file's unit) from where it should be")
    } else {
        "not a number (NaN) or infinite".to_owned()
    }
}
