//! The vocabulary of forward kinematics.
//!
//! A [`Skeleton`] is a list of [`Joint`]s, every parent before its children. A [`Motion`] is a skeleton and one row
//! of channel values per frame. A [`Pose`] says where every joint of one frame stands, as one global
//! [`Transform`] each. [`pose_frame`] is the fixed traversal that turns a frame into a pose: it calls the three
//! functions of [`FkFunctions`] for every joint. A [`LocalPose`] is what is between two frames, and [`FrameErrors`] and
//! [`RemovalCosts`] are what an algorithm that chooses keyframes looks at. Skeletons of bones, as Acclaim files hold
//! them, have words of their own: [`acclaim`].
//!
//! Conventions, everywhere: right-handed axes, column vectors, rotations as unit quaternions written (x, y, z, w),
//! angles of a motion in degrees, lengths in the motion's own unit.
#![deny(missing_docs)]

pub mod acclaim;
mod channel;
mod cursor;
mod inbetween;
mod joint;
mod keyframes;
mod motion;
mod order;
mod pose;
mod traversal;
mod tree;

pub use channel::{Axis, Channel};
pub use cursor::FrameCursor;
pub use inbetween::{InterpolationFunctions, LocalPose, Representation};
pub use joint::{Joint, JointId};
pub use keyframes::{Clip, FrameErrors, KeyframesFunctions, MakeClip, RemovalCosts};
pub use motion::{Frame, Motion, MotionError, PositionChannels};
pub use order::RotationOrder;
pub use pose::{Pose, Transform};
pub use traversal::{FkFunctions, Leftover, pose_frame};
pub use tree::{Skeleton, SkeletonError};
