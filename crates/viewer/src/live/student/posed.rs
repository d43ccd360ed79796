//! What a student's functions answer about a frame, whichever exercise they are of.

use exam::fk::LocalAnswer;
use skeleton::Pose;
use skeleton::acclaim::{Between, BoneId, BonePlace};

/// What the functions made of one frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Posed {
    /// The global transforms of all joints; NaN where the functions say nothing.
    pub pose: Pose,
    /// What else they say.
    pub extra: Extra,
}

/// What is known of a frame besides its pose.
#[derive(Clone, Debug, PartialEq)]
pub enum Extra {
    /// Forward kinematics.
    Angles {
        /// How many angles the functions took over the whole frame.
        taken: usize,
        /// How many angles the frame holds.
        available: usize,
    },
    /// Acclaim forward kinematics: where each bone is; nothing for one that was not visited.
    Bones(Vec<Option<BonePlace>>),
    /// Time warping.
    Warp {
        /// How many frames part 3 gives, where it was asked.
        given: Option<usize>,
        /// Where part 1 says the frame is, where it was asked.
        place: Option<Between>,
        /// How many bones the posture is of, where these are not as many as there are.
        bones: Option<usize>,
    },
}

/// What single parts answer when they are asked by themselves, in order to explain a joint or a bone.
#[derive(Clone, Debug, PartialEq)]
pub enum Details {
    /// Forward kinematics: what part 1 gives for every joint.
    Locals(Vec<LocalAnswer>),
    /// Acclaim forward kinematics: the bones in the order in which part 3 visits them, up to twice as many as there are and
    /// one more.
    Visits(Vec<BoneId>),
    /// Time warping: what part 2 makes of the frames between which this one is.
    Blended {
        /// Of the right ones.
        right: Pose,
        /// Where part 1 says the frame is, where it is asked and answers.
        place: Option<Between>,
        /// Of those that part 1 names; nothing where it names none that are there.
        own: Option<Pose>,
    },
}

impl Posed {
    /// The places of the bones, where the functions move bones.
    pub fn places(&self) -> Option<&[Option<BonePlace>]> {
        match &self.extra {
            Extra::Bones(places) => Some(places),
            Extra::Angles { .. } | Extra::Warp { .. } => None,
        }
    }
}
