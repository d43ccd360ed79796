//! From bones to joints and back: the same figure, moving the same way, in the other format's words.

mod names;
mod to_bones;
mod to_joints;

use skeleton::acclaim;

pub use to_bones::{to_bones, to_bones_by_joint};
pub use to_joints::{depth_first, to_joints};

/// Why a motion cannot be told in the other format's words.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ConvertError {
    /// There is no joint.
    #[error("there is no joint, and a skeleton of bones has a root at least")]
    NoJoints,
    /// There are several roots.
    #[error("`{root}` is a second root, and a skeleton of bones has one")]
    SeveralRoots {
        /// The second root.
        root: String,
    },
    /// A joint changes its distance from its parent.
    #[error(
        "in frame {frame} (counted from 1) the joint `{joint}` is elsewhere on its parent than before: bones do not change \
         their length"
    )]
    MovedJoint {
        /// The joint.
        joint: String,
        /// The first frame in which it is, from 1.
        frame: usize,
    },
    /// A skeleton of joints cannot be built.
    #[error("{0}")]
    Joints(#[from] skeleton::SkeletonError),
    /// A skeleton of bones cannot be built.
    #[error("{0}")]
    Bones(#[from] acclaim::SkeletonError),
    /// The numbers do not make whole frames.
    #[error("{0}")]
    Motion(#[from] skeleton::MotionError),
}
