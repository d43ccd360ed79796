//! Between two frames: what is interpolated, and what comes of it.

use std::fmt;

use glam::{Quat, Vec3};

use crate::{Frame, Skeleton};

/// What of a rotation is interpolated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Representation {
    /// The three Euler angles of a joint, each by itself. The quaternion is made of the angles that result.
    #[default]
    Euler,
    /// The unit quaternion that a joint's angles make.
    Quaternion,
}

impl Representation {
    /// Both of them.
    pub const ALL: [Representation; 2] = [Representation::Euler, Representation::Quaternion];

    /// What is interpolated, in words.
    pub fn name(self) -> &'static str {
        match self {
            Representation::Euler => "Euler angles",
            Representation::Quaternion => "quaternions",
        }
    }
}

impl fmt::Display for Representation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// How every joint of a skeleton is turned and where it is, relative to its parent.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct LocalPose {
    /// One unit quaternion (x, y, z, w) for every joint and End Site, in the order of the joints: the identity for those
    /// without angles.
    pub rotations: Vec<Quat>,
    /// One position for every joint and End Site, in the parent's axes, in the motion's unit.
    pub positions: Vec<Vec3>,
}

/// The three functions of the assignment on interpolation.
#[derive(Clone, Copy, Debug)]
pub struct InterpolationFunctions {
    /// Part 1: between two sets of Euler angles (degrees), each angle the shorter way round.
    pub interpolate_angles: fn([f32; 3], [f32; 3], f32) -> [f32; 3],
    /// Part 2: between two unit quaternions, the shorter way round and evenly.
    pub slerp: fn(Quat, Quat, f32) -> Quat,
    /// Part 3: between two frames, all joints.
    pub interpolate_frame: fn(&Skeleton, &Frame, &Frame, f32, Representation) -> LocalPose,
}
