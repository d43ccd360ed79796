//! What can go wrong while a motion is made.

use skeleton::{MotionError, SkeletonError};

/// Why a motion cannot be made or written.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// A movement sets a joint that the skeleton does not have.
    #[error("there is no joint {0}")]
    UnknownJoint(String),
    /// A movement sets a bone that the skeleton does not have.
    #[error("there is no bone {0}")]
    UnknownBone(String),
    /// The skeleton's table is wrong.
    #[error("the skeleton cannot be built: {0}")]
    Skeleton(#[from] SkeletonError),
    /// The table of bones is wrong.
    #[error("the skeleton cannot be built: {0}")]
    Bones(#[from] skeleton::acclaim::SkeletonError),
    /// The frames do not fit the skeleton.
    #[error("the frames do not fit: {0}")]
    Motion(#[from] MotionError),
    /// The text cannot be written.
    #[error("the motion cannot be written: {0}")]
    Write(#[from] std::io::Error),
}
