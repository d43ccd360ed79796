//! The exercise on keyframes: what can be asked of its three functions.

mod chain;
mod triples;

use serde::{Deserialize, Serialize};
use skeleton::{
    Clip, Frame, FrameErrors, KeyframesFunctions, MakeClip, Pose, RemovalCosts, Representation, Skeleton,
};

use chain::Chain;
pub use triples::Triples;

/// A question to one of the three functions, or to all of them together.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Question {
    /// Part 1.
    PoseError {
        /// The skeleton of both poses.
        skeleton: Skeleton,
        /// As it is.
        original: Pose,
        /// As it is interpolated.
        interpolated: Pose,
    },
    /// Part 2.
    RemovalCost {
        /// The keyframe before.
        before: usize,
        /// The keyframe that is removed.
        frame: usize,
        /// The keyframe after.
        after: usize,
        /// The error of every frame between any two others: start, frame, end.
        errors: Triples,
    },
    /// Part 3.
    Reduce {
        /// How many frames the motion has.
        frame_count: usize,
        /// How many keyframes are wanted.
        count: usize,
        /// What every removal costs: before, frame, after.
        costs: Triples,
    },
    /// All three parts together, with poses that come with the question.
    Chain {
        /// The skeleton that moves.
        skeleton: Skeleton,
        /// Its poses.
        originals: Vec<Pose>,
        /// The pose of every frame between any two others, in the order of [`Triples`]: start, frame, end.
        between: Vec<Pose>,
        /// How many keyframes are wanted.
        count: usize,
    },
    /// All three parts together, over a motion of any length. Only functions with clips
    /// ([`Functions::with_clips`](crate::Functions::with_clips)) can answer it.
    Motion {
        /// The skeleton that moves.
        skeleton: Skeleton,
        /// The frames of the motion.
        frames: Vec<Frame>,
        /// What is interpolated between keyframes.
        representation: Representation,
        /// How many keyframes are wanted, one reduction for each number.
        counts: Vec<usize>,
    },
}

/// The answer to a [`Question`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Answer {
    /// The error of one pose.
    PoseError(f64),
    /// By how much the accumulated error grows.
    RemovalCost(f64),
    /// The keyframes that stay: the answer to `Reduce` and to `Chain`.
    Reduce(Vec<usize>),
    /// One reduction for each number of keyframes.
    Motion(Vec<Reduction>),
}

/// A motion reduced to keyframes.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Reduction {
    /// The keyframes that stay.
    pub keyframes: Vec<usize>,
    /// The sum of the errors of all frames between them, by part 1. Not a number when these are no keyframes from the
    /// first frame to the last, in ascending order.
    pub error: f64,
}

impl Question {
    /// Asks `functions`, here and now. A panic of theirs goes through.
    pub fn ask(&self, functions: &KeyframesFunctions, make_clip: Option<MakeClip>) -> Answer {
        match self {
            Question::PoseError { skeleton, original, interpolated } => {
                Answer::PoseError((functions.pose_error)(skeleton, original, interpolated))
            }
            Question::RemovalCost { before, frame, after, errors } => {
                let error = |start, end, frame| errors.get(start, frame, end);
                let errors = FrameErrors::new(&error);
                Answer::RemovalCost((functions.removal_cost)(*before, *frame, *after, &errors))
            }
            Question::Reduce { frame_count, count, costs } => {
                let cost = |before, frame, after| costs.get(before, frame, after);
                Answer::Reduce((functions.reduce)(*frame_count, *count, &RemovalCosts::new(&cost)))
            }
            Question::Chain { skeleton, originals, between, count } => {
                let clip = GivenPoses { originals, between };
                Answer::Reduce(Chain::new(functions, skeleton, &clip).reduce(*count))
            }
            Question::Motion { skeleton, frames, representation, counts } => {
                let Some(make_clip) = make_clip else { return Answer::Motion(Vec::new()) };
                let clip = make_clip(skeleton, frames, *representation);
                let chain = Chain::new(functions, skeleton, &*clip);
                Answer::Motion(counts.iter().map(|count| chain.reduction(*count)).collect())
            }
        }
    }

    /// More bytes than any honest answer to this question takes on the wire.
    pub(crate) fn answer_limit(&self) -> usize {
        const PER_FRAME: usize = 10;
        let frames = match self {
            Question::PoseError { .. } | Question::RemovalCost { .. } => 1,
            Question::Reduce { frame_count, .. } => *frame_count,
            Question::Chain { originals, .. } => originals.len(),
            Question::Motion { frames, counts, .. } => {
                counts.iter().map(|count| count.saturating_add(4).min(frames.len() + 4)).sum()
            }
        };
        1024 + PER_FRAME * frames
    }
}

/// Poses that came with a question.
struct GivenPoses<'a> {
    originals: &'a [Pose],
    between: &'a [Pose],
}

impl Clip for GivenPoses<'_> {
    fn frame_count(&self) -> usize {
        self.originals.len()
    }

    fn original(&self, frame: usize, pose: &mut Pose) {
        pose.clone_from(&self.originals[frame]);
    }

    fn between(&self, start: usize, end: usize, frame: usize, pose: &mut Pose) {
        pose.clone_from(&self.between[triples::rank(self.originals.len(), start, frame, end)]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Answer as AnyAnswer;
    use crate::wire::{self, Reply};

    /// What an answer takes on the wire.
    fn length(answer: Answer) -> usize {
        wire::to_bytes(&Reply::Answered(AnyAnswer::Keyframes(answer))).unwrap().len()
    }

    #[test]
    fn honest_answers_fit_the_limit() {
        for frames in [0, 1, 2, 5, 300, 20_000] {
            let all = || (0..frames).collect::<Vec<usize>>();
            let reduce = Question::Reduce { frame_count: frames, count: 0, costs: Triples::default() };
            assert!(length(Answer::Reduce(all())) <= reduce.answer_limit(), "{frames}");

            // As many as are wanted and no more than there are, but for the two that always stay.
            let counts: Vec<usize> = (0..200).map(|n| n * frames / 100).chain([usize::MAX]).collect();
            let reduction = |count: &usize| {
                let stay = (*count).max(2).min(frames);
                Reduction { keyframes: (frames - stay..frames).collect(), error: 1e300 }
            };
            let reductions = counts.iter().map(reduction).collect();
            let motion = Question::Motion {
                skeleton: Skeleton::new(),
                frames: vec![Frame::default(); frames],
                representation: Representation::Euler,
                counts,
            };
            assert!(length(Answer::Motion(reductions)) <= motion.answer_limit(), "{frames}");
        }
        let numbers = [Answer::PoseError(-1e300), Answer::RemovalCost(f64::NAN)];
        let question = Question::RemovalCost { before: 0, frame: 1, after: 2, errors: Triples::default() };
        assert!(numbers.into_iter().all(|number| length(number) <= question.answer_limit()));
    }
}
