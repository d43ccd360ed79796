//! One joint of a skeleton.

use glam::Vec3;

use crate::{Channel, RotationOrder};

/// A joint's place in its skeleton: 0 for the first joint of the file, then in the order of the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct JointId(pub usize);

/// One node of a skeleton: a root, a joint below it, or an End Site, which marks the tip of the last bone.
///
/// Joints are known by their [`id`](Joint::id). Names are for people: a file may use one twice.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Joint {
    /// This joint's own place in the skeleton and in a [`Pose`](crate::Pose).
    pub id: JointId,
    /// The name in the file. An End Site's is what the file writes there, mostly `End Site`.
    pub name: String,
    /// The joint that this one hangs on; `None` for a root.
    pub parent: Option<JointId>,
    /// The position relative to the parent, in the parent's axes, in the file's unit, when nothing moves.
    pub offset: Vec3,
    /// In which order this joint's three angles arrive; `None` when it has no angles.
    pub rotation_order: RotationOrder,
    /// What the numbers of a frame mean for this joint, in the order of the file.
    pub channels: Vec<Channel>,
    /// Whether this is an End Site: the tip of a bone, without channels and without children.
    pub is_end_site: bool,
}

impl Joint {
    /// Whether this joint hangs on no other.
    pub fn is_root(&self) -> bool {
        self.parent.is_none()
    }
}
