//! The skeleton: joints in parents-first order.

use std::fmt;

use glam::Vec3;

use crate::{Channel, Joint, JointId, RotationOrder};

/// A tree of joints, or several: every parent stands before its children, so that one pass from front to back
/// meets each parent first.
///
/// Joints are only ever added, by [`add_joint`](Skeleton::add_joint) and [`add_end_site`](Skeleton::add_end_site),
/// which keep that order true.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(try_from = "Vec<Joint>", into = "Vec<Joint>"))]
pub struct Skeleton {
    joints: Vec<Joint>,
    channel_count: usize,
}

impl Skeleton {
    /// A skeleton without joints.
    pub fn new() -> Self {
        Skeleton::default()
    }

    /// Adds a joint behind all others; a root when `parent` is `None`. `offset` is relative to the parent.
    ///
    /// # Errors
    ///
    /// When the parent is not in this skeleton or is an End Site, or when a channel occurs twice.
    pub fn add_joint(
        &mut self,
        parent: Option<JointId>,
        name: impl Into<String>,
        offset: Vec3,
        channels: impl Into<Vec<Channel>>,
    ) -> Result<JointId, SkeletonError> {
        let channels = channels.into();
        for (i, channel) in channels.iter().enumerate() {
            if channels[..i].contains(channel) {
                return Err(SkeletonError::RepeatedChannel(*channel));
            }
        }
        self.add(parent, name.into(), offset, channels, false)
    }

    /// Adds the tip of a bone: an End Site, `offset` away from its parent.
    ///
    /// # Errors
    ///
    /// When the parent is not in this skeleton or is an End Site itself.
    pub fn add_end_site(
        &mut self,
        parent: JointId,
        name: impl Into<String>,
        offset: Vec3,
    ) -> Result<JointId, SkeletonError> {
        self.add(Some(parent), name.into(), offset, Vec::new(), true)
    }

    fn add(
        &mut self,
        parent: Option<JointId>,
        name: String,
        offset: Vec3,
        channels: Vec<Channel>,
        is_end_site: bool,
    ) -> Result<JointId, SkeletonError> {
        if let Some(parent) = parent {
            match self.get(parent) {
                None => return Err(SkeletonError::UnknownParent(parent)),
                Some(joint) if joint.is_end_site => return Err(SkeletonError::ChildOfEndSite(parent)),
                Some(_) => {}
            }
        }
        let id = JointId(self.joints.len());
        self.channel_count += channels.len();
        let rotation_order = RotationOrder::of_channels(&channels);
        self.joints.push(Joint { id, name, parent, offset, rotation_order, channels, is_end_site });
        Ok(id)
    }

    /// The joints and End Sites, parents first, in the order of the file.
    pub fn joints(&self) -> &[Joint] {
        &self.joints
    }

    /// The joint with this id, if there is one.
    pub fn get(&self, id: JointId) -> Option<&Joint> {
        self.joints.get(id.0)
    }

    /// How many joints and End Sites there are.
    pub fn len(&self) -> usize {
        self.joints.len()
    }

    /// Whether there is no joint.
    pub fn is_empty(&self) -> bool {
        self.joints.is_empty()
    }

    /// How many numbers a frame holds: all channels of all joints.
    pub fn channel_count(&self) -> usize {
        self.channel_count
    }

    /// A name for people: the joint's own, and for an End Site also whose it is.
    pub fn label(&self, id: JointId) -> String {
        match self.get(id) {
            None => format!("joint {}", id.0),
            Some(Joint { is_end_site: true, parent: Some(parent), name, .. }) => {
                format!("{name} of {}", self.joints[parent.0].name)
            }
            Some(joint) => joint.name.clone(),
        }
    }

    /// How many ancestors each joint has.
    pub fn depths(&self) -> Vec<usize> {
        let mut depths: Vec<usize> = Vec::with_capacity(self.len());
        for joint in &self.joints {
            depths.push(joint.parent.map_or(0, |parent| depths[parent.0] + 1));
        }
        depths
    }

    /// Where the joints stand when nothing is turned and no position channel is used: the sums of the offsets.
    pub fn rest_positions(&self) -> Vec<Vec3> {
        let mut positions: Vec<Vec3> = Vec::with_capacity(self.len());
        for joint in &self.joints {
            let parent = joint.parent.map_or(Vec3::ZERO, |parent| positions[parent.0]);
            positions.push(parent + joint.offset);
        }
        positions
    }

    /// The skeleton's size, the measure of all position tolerances: the diagonal of the box around its rest pose,
    /// in the file's unit. Zero for a skeleton of one point.
    pub fn extent(&self) -> f32 {
        let positions = self.rest_positions();
        let Some(&first) = positions.first() else { return 0.0 };
        let low = positions.iter().fold(first, |low, &p| low.min(p));
        let high = positions.iter().fold(first, |high, &p| high.max(p));
        low.distance(high)
    }
}

impl From<Skeleton> for Vec<Joint> {
    fn from(skeleton: Skeleton) -> Self {
        skeleton.joints
    }
}

/// Builds the skeleton anew, so that what holds for one that was built joint by joint holds for this one too. Ids and
/// rotation orders are those that follow from the joints' order and channels.
impl TryFrom<Vec<Joint>> for Skeleton {
    type Error = SkeletonError;

    fn try_from(joints: Vec<Joint>) -> Result<Self, SkeletonError> {
        let mut skeleton = Skeleton::new();
        for Joint { name, parent, offset, channels, is_end_site, .. } in joints {
            match (parent, is_end_site) {
                (Some(parent), true) => skeleton.add_end_site(parent, name, offset)?,
                _ => skeleton.add_joint(parent, name, offset, channels)?,
            };
        }
        Ok(skeleton)
    }
}

/// Why a joint cannot be added to a skeleton.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SkeletonError {
    /// No joint has this id (yet).
    UnknownParent(JointId),
    /// An End Site is the tip of a bone: nothing can hang on it.
    ChildOfEndSite(JointId),
    /// One joint lists this channel twice.
    RepeatedChannel(Channel),
}

impl fmt::Display for SkeletonError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SkeletonError::UnknownParent(id) => write!(f, "there is no joint {} to hang a joint on", id.0),
            SkeletonError::ChildOfEndSite(id) => {
                write!(f, "joint {} is an End Site: nothing can hang on it", id.0)
            }
            SkeletonError::RepeatedChannel(channel) => write!(f, "the channel {channel} occurs twice"),
        }
    }
}

impl std::error::Error for SkeletonError {}
