//! Questions about whole motions, and what can be wrong with the answers.

use std::time::{Duration, Instant};

use exam::interpolation::{Answer as InterpolationAnswer, Question as InterpolationQuestion};
use exam::keyframes::{Answer as KeyframesAnswer, Question as KeyframesQuestion, Reduction};
use exam::{Answer, Failure, Question, Subject};
use grading::{interpolation, keyframes};
use skeleton::{LocalPose, Representation, Skeleton};

use crate::edit::Progress;
use crate::live::worker::Trouble;
use crate::motion::stage::Stage;

/// About how many joints are interpolated for one question: few enough for an answer without a wait that one would notice.
const JOINTS_AT_ONCE: usize = 8_000;

/// How long the functions may take for that. It is far more than they need.
const PATIENCE: Duration = Duration::from_secs(5);

/// How long they may take for a single frame, while the one is looked for that fails.
const FRAME_LIMIT: Duration = Duration::from_secs(2);

/// How long they may take to choose keyframes.
const REDUCTION_LIMIT: Duration = Duration::from_secs(10);

/// Why there is no answer that can be used: for the program, and in words for the student.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Wrong {
    pub(super) failure: Failure,
    pub(super) trouble: Trouble,
}

impl Wrong {
    /// No answer came.
    fn failed(failure: Failure, details: impl IntoIterator<Item = String>) -> Wrong {
        let mut trouble = Trouble::from(failure.clone());
        trouble.details.extend(details);
        Wrong { failure, trouble }
    }

    /// An answer came that makes no sense.
    fn absurd(why: String, details: impl IntoIterator<Item = String>) -> Wrong {
        let trouble = Trouble { headline: why.clone(), details: details.into_iter().collect() };
        Wrong { failure: Failure::Unreadable { why }, trouble }
    }
}

/// Asks for all frames between the keyframes of `stretch`, or as many as `progress` lets it. `hush` is called before questions are put whose answers are
/// not shown.
pub(super) fn between(
    subject: &mut dyn Subject,
    stage: &Stage,
    representation: Representation,
    stretch: (usize, usize),
    progress: Progress,
    hush: impl FnOnce(),
) -> Result<Vec<LocalPose>, Wrong> {
    let stretch = Stretch::new(stage, representation, stretch);
    let at_once = (JOINTS_AT_ONCE / stage.motion().skeleton().len().max(1)).max(1);
    let frames: Vec<usize> = (stretch.start + 1..stretch.end).collect();
    let (count, mut poses) = (frames.len(), Vec::with_capacity(frames.len()));
    for frames in frames.chunks(at_once) {
        match stretch.ask(subject, frames, PATIENCE) {
            Ok(some) => {
                // Before the next question: nothing is collected that cannot be used.
                for (frame, pose) in frames.iter().zip(&some) {
                    stretch.check(*frame, pose)?;
                }
                poses.extend(some);
            }
            Err(failure) => {
                hush();
                return Err(stretch.find(subject, frames, failure));
            }
        }
        if progress(poses.len(), count).is_break() {
            break;
        }
    }
    Ok(poses)
}

/// The frames between two keyframes.
struct Stretch<'a> {
    skeleton: &'a Skeleton,
    from: skeleton::Frame,
    to: skeleton::Frame,
    start: usize,
    end: usize,
    representation: Representation,
}

impl<'a> Stretch<'a> {
    fn new(stage: &'a Stage, representation: Representation, (start, end): (usize, usize)) -> Stretch<'a> {
        let (from, to) = (stage.frame(start), stage.frame(end));
        Stretch { skeleton: stage.motion().skeleton(), from, to, start, end, representation }
    }

    /// How far `frame` is from the first keyframe to the second.
    fn t(&self, frame: usize) -> f32 {
        (frame - self.start) as f32 / (self.end - self.start) as f32
    }

    fn ask(
        &self,
        subject: &mut dyn Subject,
        frames: &[usize],
        limit: Duration,
    ) -> Result<Vec<LocalPose>, Failure> {
        let question = InterpolationQuestion::Between {
            skeleton: self.skeleton.clone(),
            from: self.from.clone(),
            to: self.to.clone(),
            ts: frames.iter().map(|frame| self.t(*frame)).collect(),
            representation: self.representation,
        };
        match subject.ask(&Question::Interpolation(question), limit)? {
            Answer::Interpolation(InterpolationAnswer::Between(poses)) if poses.len() == frames.len() => {
                Ok(poses)
            }
            _ => Err(unfit()),
        }
    }

    /// What is wrong with `frames`, which fail as `failure` says: where the first one fails too, it is named.
    fn find(&self, subject: &mut dyn Subject, frames: &[usize], failure: Failure) -> Wrong {
        let begin = Instant::now();
        for frame in frames {
            // Functions that are only slow would be asked for long.
            if matches!(failure, Failure::NoAnswer { .. }) || begin.elapsed() > 2 * PATIENCE {
                break;
            }
            if let Err(failure) = self.ask(subject, &[*frame], FRAME_LIMIT) {
                return Wrong::failed(failure, [self.place(*frame)]);
            }
        }
        let [.., last] = frames else { return Wrong::failed(failure, []) };
        Wrong::failed(failure, [format!("in frames {} to {last}, {}", frames[0], self.ends())])
    }

    /// Whether a pose can be shown.
    fn check(&self, frame: usize, pose: &LocalPose) -> Result<(), Wrong> {
        let function = interpolation::RUBRIC.parts[2].function;
        let (joints, rotations, positions) =
            (self.skeleton.len(), pose.rotations.len(), pose.positions.len());
        if (rotations, positions) != (joints, joints) {
            let headline = format!(
                "your {function} gives {rotations} rotations and {positions} positions, for {joints} joints"
            );
            let hint = "Each joint and each End Site has one of both, in the order of skeleton.joints().";
            return Err(Wrong::absurd(headline, [self.place(frame), hint.into()]));
        }
        let lost = |(rotation, position): (&glam::Quat, &glam::Vec3)| match () {
            () if !rotation.is_finite() => Some("rotation"),
            () if !position.is_finite() => Some("position"),
            () => None,
        };
        let transforms = pose.rotations.iter().zip(&pose.positions).zip(self.skeleton.joints());
        for (transform, joint) in transforms {
            let Some(what) = lost(transform) else { continue };
            let label: String = self.skeleton.label(joint.id).chars().take(60).collect();
            let headline = format!(
                "your {function} gives NaN or infinity as the {what} of joint {}",
                parser::printable(&label)
            );
            let hint =
                "Something was divided by zero, or the root or the arc cosine of a wrong number was taken.";
            return Err(Wrong::absurd(headline, [self.place(frame), hint.into()]));
        }
        Ok(())
    }

    fn place(&self, frame: usize) -> String {
        format!("in frame {frame}, t = {:.3}, {}", self.t(frame), self.ends())
    }

    fn ends(&self) -> String {
        format!("between the keyframes {} and {}, with {}", self.start, self.end, self.representation)
    }
}

/// Asks for the motion reduced to each of `counts` keyframes.
pub(super) fn reduce(
    subject: &mut dyn Subject,
    stage: &Stage,
    representation: Representation,
    counts: &[usize],
) -> Result<Vec<Reduction>, Wrong> {
    let frame_count = stage.frame_count();
    let question = KeyframesQuestion::Motion {
        skeleton: stage.motion().skeleton().clone(),
        frames: stage.frames(),
        representation,
        counts: counts.to_vec(),
    };
    let place = |counts: &[usize]| {
        let counts: Vec<String> = counts.iter().map(ToString::to_string).collect();
        format!("{frame_count} frames to {} keyframes, with {representation}", counts.join(", "))
    };
    let reductions = match subject.ask(&Question::Keyframes(question), REDUCTION_LIMIT) {
        Ok(Answer::Keyframes(KeyframesAnswer::Motion(reductions))) if reductions.len() == counts.len() => {
            reductions
        }
        Ok(_) => return Err(Wrong::failed(unfit(), [place(counts)])),
        Err(failure) => {
            let slow = matches!(failure, Failure::TimedOut { .. });
            let hint = "Or it is only slow: a shorter motion, such as data/dance.bvh, tells.";
            return Err(Wrong::failed(failure, [place(counts)].into_iter().chain(slow.then(|| hint.into()))));
        }
    };
    for (count, reduction) in counts.iter().zip(&reductions) {
        if let Some((headline, hint)) = absurdity(reduction, frame_count) {
            return Err(Wrong::absurd(headline, [place(&[*count]), hint.into()]));
        }
    }
    Ok(reductions)
}

/// What makes a reduction useless, if anything does, and a hint.
fn absurdity(reduction: &Reduction, frame_count: usize) -> Option<(String, &'static str)> {
    let Reduction { keyframes, error } = reduction;
    let [pose_error, _, reduce] = [0, 1, 2].map(|part| keyframes::RUBRIC.parts[part].function);
    let (Some(first), Some(last)) = (keyframes.first(), keyframes.last()) else {
        return Some((format!("your {reduce} keeps no keyframes at all"), ENDS));
    };
    if let Some(beyond) = keyframes.iter().find(|frame| **frame >= frame_count) {
        let headline = format!("your {reduce} keeps frame {beyond}, which the motion does not have");
        return Some((headline, "Frames are counted from 0: the last one is the number of frames minus 1."));
    }
    if let Some(pair) = keyframes.windows(2).find(|pair| pair[0] >= pair[1]) {
        let headline = format!("your {reduce} gives {} and after it {}", pair[0], pair[1]);
        return Some((headline, "Keyframes are given in ascending order, each once."));
    }
    if *first != 0 {
        return Some((format!("your {reduce} removes the first frame: it begins with {first}"), ENDS));
    }
    if *last != frame_count - 1 {
        return Some((format!("your {reduce} removes the last frame: it ends with {last}"), ENDS));
    }
    if !error.is_finite() {
        let headline = format!("your {pose_error} gives NaN or infinity: all errors together are {error}");
        return Some((
            headline,
            "Something was divided by zero, or the root of a negative number was taken.",
        ));
    }
    None
}

const ENDS: &str = "The first and the last frame always stay.";

fn unfit() -> Failure {
    Failure::Unreadable { why: "the answer does not fit the question".into() }
}
