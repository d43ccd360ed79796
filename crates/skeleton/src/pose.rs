//! Where the joints of one frame stand.

use std::ops::{Index, IndexMut};

use glam::{Quat, Vec3};

use crate::JointId;

/// Where a joint stands and how it is turned, in world axes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Transform {
    /// Turns the joint's own axes into the world's. A unit quaternion (x, y, z, w).
    pub rotation: Quat,
    /// In the motion's unit.
    pub position: Vec3,
}

impl Transform {
    /// Not turned, at the origin.
    pub const IDENTITY: Transform = Transform { rotation: Quat::IDENTITY, position: Vec3::ZERO };
}

/// The global transforms of all joints in one frame. `pose[id]` is the transform of joint `id`.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Pose {
    transforms: Vec<Transform>,
}

impl Pose {
    /// A pose of `joints` joints, all at the origin and not turned.
    pub fn identity(joints: usize) -> Self {
        Pose { transforms: vec![Transform::IDENTITY; joints] }
    }

    /// How many joints this pose holds.
    pub fn len(&self) -> usize {
        self.transforms.len()
    }

    /// Whether this pose holds no joint.
    pub fn is_empty(&self) -> bool {
        self.transforms.is_empty()
    }

    /// The transforms in the order of the joints.
    pub fn transforms(&self) -> &[Transform] {
        &self.transforms
    }

    /// The same, to be changed.
    pub fn transforms_mut(&mut self) -> &mut [Transform] {
        &mut self.transforms
    }

    /// Puts `joints` joints back to the origin, not turned, and keeps the memory.
    pub fn reset(&mut self, joints: usize) {
        self.transforms.clear();
        self.transforms.resize(joints, Transform::IDENTITY);
    }
}

impl From<Vec<Transform>> for Pose {
    fn from(transforms: Vec<Transform>) -> Self {
        Pose { transforms }
    }
}

/// # Panics
///
/// If the pose has no joint `id`. An id from the same skeleton is always there.
impl Index<JointId> for Pose {
    type Output = Transform;

    fn index(&self, id: JointId) -> &Transform {
        &self.transforms[id.0]
    }
}

/// # Panics
///
/// If the pose has no joint `id`.
impl IndexMut<JointId> for Pose {
    fn index_mut(&mut self, id: JointId) -> &mut Transform {
        &mut self.transforms[id.0]
    }
}
