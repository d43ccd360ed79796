//! The three parts together, over several postures of a figure.

use exam::acclaim::{Answer as AcclaimAnswer, Question as AcclaimQuestion};
use exam::{Answer, Failure, Question};
use skeleton::acclaim::{BoneId, BonePlace, Posture, Skeleton};

use super::figure::{figure, posture};
use super::misconceptions::accepted;
use crate::compare::POSITION_TOLERANCE;
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
        let mut details = vec![match bone.parent {
            Some(parent) => {
                let parent = self.skeleton.get(parent).map_or("", |parent| &parent.name);
                format!("Its parent, {parent}, is in its place: look at what becomes of {}.", bone.name)
            }
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
