//! What a student's functions are asked, and what they are given.

use std::fmt;

use glam::{Quat, Vec3};

use super::{Bone, Posture, Skeleton};

/// Where a bone is and how it is turned, in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct BonePlace {
    /// Turns the bone's own axes into the world's. A unit quaternion (x, y, z, w).
    pub rotation: Quat,
    /// Where it starts, in the file's unit.
    pub start: Vec3,
    /// Where it ends, in the file's unit.
    pub end: Vec3,
}

impl BonePlace {
    /// Not turned, at the origin.
    pub const ORIGIN: BonePlace = BonePlace { rotation: Quat::IDENTITY, start: Vec3::ZERO, end: Vec3::ZERO };
}

/// Is shown every bone, one after the other.
pub struct Visitor<'a>(&'a mut dyn FnMut(&Bone));

impl<'a> Visitor<'a> {
    /// `see` is called with each bone that is visited.
    pub fn new(see: &'a mut dyn FnMut(&Bone)) -> Self {
        Visitor(see)
    }

    /// Works out where `bone` is: parts 1 and 2. Its parent must have been visited before.
    pub fn visit(&mut self, bone: &Bone) {
        (self.0)(bone);
    }
}

impl fmt::Debug for Visitor<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Visitor")
    }
}

/// The three functions of the assignment on Acclaim forward kinematics.
#[derive(Clone, Copy, Debug)]
pub struct AcclaimFunctions {
    /// Part 1: how a bone is turned in the world, from its angles (degrees, about its own X, Y and Z) and its parent's
    /// rotation.
    pub bone_rotation: fn(&Bone, [f32; 3], Quat) -> Quat,
    /// Part 2: where a bone starts and ends, from its rotation, its parent's end and its translation.
    pub bone_ends: fn(&Bone, Quat, Vec3, Vec3) -> (Vec3, Vec3),
    /// Part 3: visits a bone and all that hangs on it, parents first.
    pub visit_bones: fn(&Skeleton, &Bone, &mut Visitor),
}

/// Between which two frames of a motion something is, and how far.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Between {
    /// The frame before, from 0.
    pub before: usize,
    /// The frame after; the same one where there is none.
    pub after: usize,
    /// How far it is from the one to the other: 0 is the frame before, 1 the frame after.
    pub t: f32,
}

/// The three functions of the assignment on time warping.
#[derive(Clone, Copy, Debug)]
pub struct TimeWarpFunctions {
    /// Part 1: where a frame of the warped motion is in the old one: the new frame, how many frames there were, and how
    /// many there are to be.
    pub old_position: fn(usize, usize, usize) -> Between,
    /// Part 2: between two postures.
    pub blend: fn(&Posture, &Posture, f32) -> Posture,
    /// Part 3: a motion with another number of frames.
    pub warp: fn(&[Posture], usize) -> Vec<Posture>,
}
