//! The vocabulary of Acclaim skeletons and motions.
//!
//! Where other formats speak of joints, this one speaks of bones. A [`Skeleton`] is a tree of [`Bone`]s, the first of
//! which is the root: a place, not a bone. Every other bone starts where its parent ends, and lies along its own
//! direction. A bone turns about axes of its own, and only about those that are its degrees of freedom. A [`Posture`]
//! holds the angles of all bones in one frame, and a [`Motion`] the numbers of all frames.
//!
//! # From a posture to positions
//!
//! In the rest pose a bone's own axes are turned against the world's by the rotation C ([`Bone::axis_rotation`]),
//! and the bone points along [`Bone::direction`] in the world. In a posture it is turned by M, the product of the
//! rotations about its own axes in its [`Bone::rotation_order`]. With G for how a bone is turned in the world against
//! its rest pose:
//!
//! - G = G(parent) C M C⁻¹
//! - start = end of the parent
//! - end = start + G (length × direction) + the posture's translation of the bone
//!
//! The same in the bone's own axes, with R = G C: R = R(parent) × [`Bone::rot_parent_current`] × M, and the bone
//! points along R × [`Bone::local_direction`].
//!
//! The root has no length. It starts and ends at the posture's translation of the root.

mod bone;
mod exercise;
mod motion;
mod posture;
mod tree;

pub use bone::{Bone, BoneData, BoneId, DegreeOfFreedom, LocalAxes};
pub use exercise::{AcclaimFunctions, Between, BonePlace, TimeWarpFunctions, Visitor};
pub use motion::{Columns, Motion};
pub use posture::Posture;
pub use tree::{AngleUnit, Root, Skeleton, SkeletonError, Units};
