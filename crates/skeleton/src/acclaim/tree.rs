//! The skeleton: the root and its bones, parents first.

use std::collections::BTreeMap;
use std::fmt;
use std::ops::Index;

use glam::{Quat, Vec3};

use super::bone::rotation_order;
use super::{Bone, BoneData, BoneId, DegreeOfFreedom, LocalAxes};
use crate::{Axis, Channel, RotationOrder};

/// The root, and bones that hang on it or on each other. Every parent stands before its children, and bones with the
/// same parent are siblings in the order in which they were added.
///
/// Bones are only ever added, by [`add_bone`](Skeleton::add_bone). Their names are one word each and unique, where upper
/// and lower case are the same.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(try_from = "Plain", into = "Plain"))]
pub struct Skeleton {
    /// What the whole skeleton is called, on one line; may be empty.
    pub name: String,
    /// The units of the file.
    pub units: Units,
    position: Vec3,
    bones: Vec<Bone>,
    /// The last child of each bone, where the next one is hung on.
    last_children: Vec<Option<BoneId>>,
    by_name: BTreeMap<String, BoneId>,
}

/// What a file says of the root.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Root {
    /// What can move, in the order of the motion's numbers. Of the rotations the last one is leftmost in the product.
    pub order: Vec<Channel>,
    /// How the root's own axes are turned against the world's: the angles of `orientation`, in the order of `axis`.
    pub orientation: LocalAxes,
    /// What is added to the root's translation in every frame, in the file's unit.
    pub position: Vec3,
}

impl Default for Root {
    /// A root that moves along and turns about all three axes: tx ty tz rx ry rz.
    fn default() -> Self {
        let channels = Axis::ALL.map(Channel::Position).into_iter().chain(Axis::ALL.map(Channel::Rotation));
        Root { order: channels.collect(), orientation: LocalAxes::WORLD, position: Vec3::ZERO }
    }
}

/// The units in which a file is written. All lengths are kept as they are in the file, and all angles in degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Units {
    /// What masses would have to be multiplied by.
    pub mass: f32,
    /// What lengths and positions would have to be divided by, to become what was measured (inches, in the files of CMU).
    pub length: f32,
    /// How angles are written in the file.
    pub angle: AngleUnit,
}

impl Default for Units {
    /// Everything as it is, in degrees.
    fn default() -> Self {
        Units { mass: 1.0, length: 1.0, angle: AngleUnit::Degrees }
    }
}

/// How angles are written in a file. In memory they are in degrees.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum AngleUnit {
    /// `deg`
    #[default]
    Degrees,
    /// `rad`
    Radians,
}

impl Skeleton {
    /// A root, and nothing that hangs on it.
    ///
    /// # Errors
    ///
    /// When a dof occurs twice, or the orientation has no order.
    pub fn new(root: Root) -> Result<Self, SkeletonError> {
        let Root { order, orientation, position } = root;
        let dofs = order.into_iter().map(DegreeOfFreedom::unlimited).collect();
        let mut skeleton = Skeleton {
            name: String::new(),
            units: Units::default(),
            position,
            bones: Vec::new(),
            last_children: Vec::new(),
            by_name: BTreeMap::new(),
        };
        let (name, axis) = (String::from(ROOT), orientation);
        skeleton.add(None, BoneData { name, direction: Vec3::ZERO, length: 0.0, axis, dofs })?;
        Ok(skeleton)
    }

    /// Adds a bone behind all others, as the last child of `parent`.
    ///
    /// # Errors
    ///
    /// When the parent is not in this skeleton, the name cannot be used or is used already, a dof occurs twice, or the
    /// axis has no order.
    pub fn add_bone(&mut self, parent: BoneId, bone: BoneData) -> Result<BoneId, SkeletonError> {
        if self.get(parent).is_none() {
            return Err(SkeletonError::UnknownParent(parent));
        }
        if !Skeleton::accepts_name(&bone.name) {
            return Err(SkeletonError::Name(bone.name));
        }
        self.add(Some(parent), bone)
    }

    /// Whether a bone can be called like this, so that files can refer to it: by a word that means nothing else there.
    pub fn accepts_name(name: &str) -> bool {
        (1..=LONGEST_NAME).contains(&name.len())
            && !name.starts_with([':', '#'])
            && !name.contains(|c: char| c.is_ascii_whitespace() || c == '\x0b')
            && !["begin", "end", ROOT].into_iter().any(|word| name.eq_ignore_ascii_case(word))
    }

    fn add(&mut self, parent: Option<BoneId>, bone: BoneData) -> Result<BoneId, SkeletonError> {
        let BoneData { name, direction, length, axis, dofs } = bone;
        for (i, dof) in dofs.iter().enumerate() {
            if dofs[..i].iter().any(|other| other.channel == dof.channel) {
                return Err(SkeletonError::RepeatedDof(dof.channel));
            }
        }
        if axis.order == RotationOrder::None {
            return Err(SkeletonError::NoOrder(name));
        }
        let id = BoneId(self.bones.len());
        let key = name.to_ascii_lowercase();
        if self.by_name.contains_key(&key) {
            return Err(SkeletonError::RepeatedName(name));
        }
        self.by_name.insert(key, id);
        if let Some(parent) = parent {
            match self.last_children[parent.0].replace(id) {
                None => self.bones[parent.0].child = Some(id),
                Some(last) => self.bones[last.0].sibling = Some(id),
            }
        }
        let axis_rotation = axis.rotation();
        let above = parent.map_or(Quat::IDENTITY, |parent| self.bones[parent.0].axis_rotation);
        self.bones.push(Bone {
            id,
            name,
            parent,
            child: None,
            sibling: None,
            direction,
            length,
            axis,
            rotation_order: rotation_order(&dofs),
            dofs,
            axis_rotation,
            rot_parent_current: above.inverse() * axis_rotation,
            local_direction: axis_rotation.inverse() * direction,
        });
        self.last_children.push(None);
        Ok(id)
    }

    /// The root and all bones, parents first. There is always a root.
    pub fn bones(&self) -> &[Bone] {
        &self.bones
    }

    /// The root.
    pub fn root(&self) -> &Bone {
        &self.bones[BoneId::ROOT.0]
    }

    /// What is added to the root's translation in every frame, in the file's unit.
    pub fn position(&self) -> Vec3 {
        self.position
    }

    /// The bone with this id, if there is one.
    pub fn get(&self, id: BoneId) -> Option<&Bone> {
        self.bones.get(id.0)
    }

    /// The bone with this name, in upper or lower case; `root` is the root.
    pub fn find(&self, name: &str) -> Option<&Bone> {
        self.by_name.get(&name.to_ascii_lowercase()).map(|id| &self.bones[id.0])
    }

    /// How many bones there are, with the root.
    #[allow(clippy::len_without_is_empty)] // There is always a root.
    pub fn len(&self) -> usize {
        self.bones.len()
    }

    /// The bones that start where `bone` ends, from the first to the last.
    pub fn children(&self, bone: BoneId) -> impl Iterator<Item = &Bone> {
        let child = |id: Option<BoneId>| id.and_then(|id| self.get(id));
        std::iter::successors(child(self.get(bone).and_then(|bone| bone.child)), move |bone| {
            child(bone.sibling)
        })
    }

    /// Where each bone ends in the rest pose, in the world. It starts where its parent ends.
    pub fn rest_ends(&self) -> Vec<Vec3> {
        let mut ends: Vec<Vec3> = Vec::with_capacity(self.len());
        for bone in &self.bones {
            let start = bone.parent.map_or(self.position, |parent| ends[parent.0]);
            ends.push(start + bone.rest_vector());
        }
        ends
    }

    /// The skeleton's size, the measure of all position tolerances: the diagonal of the box around its rest pose,
    /// in the file's unit. Zero for a root alone.
    pub fn extent(&self) -> f32 {
        let ends = self.rest_ends();
        let low = ends.iter().fold(self.position, |low, &end| low.min(end));
        let high = ends.iter().fold(self.position, |high, &end| high.max(end));
        low.distance(high)
    }
}

/// # Panics
///
/// If the skeleton has no bone `id`. An id from the same skeleton is always there.
impl Index<BoneId> for Skeleton {
    type Output = Bone;

    fn index(&self, id: BoneId) -> &Bone {
        &self.bones[id.0]
    }
}

/// The name that every root has.
const ROOT: &str = "root";

/// The longest name, in bytes.
const LONGEST_NAME: usize = 4096;

/// A skeleton as it travels between processes.
#[cfg(feature = "serde")]
#[derive(serde::Serialize, serde::Deserialize)]
struct Plain {
    name: String,
    units: Units,
    root: Root,
    /// Every bone but the root, and its parent.
    bones: Vec<(BoneId, BoneData)>,
}

#[cfg(feature = "serde")]
impl From<Skeleton> for Plain {
    fn from(skeleton: Skeleton) -> Self {
        let Skeleton { name, units, position, bones, .. } = skeleton;
        let mut root = Root { position, ..Root::default() };
        let mut plain = Vec::with_capacity(bones.len());
        for Bone { name, parent, direction, length, axis, dofs, .. } in bones {
            match parent {
                None => {
                    root.order = dofs.iter().map(|dof| dof.channel).collect();
                    root.orientation = axis;
                }
                Some(parent) => plain.push((parent, BoneData { name, direction, length, axis, dofs })),
            }
        }
        Plain { name, units, root, bones: plain }
    }
}

/// Builds the skeleton anew, so that what holds for one that was built bone by bone holds for this one too.
#[cfg(feature = "serde")]
impl TryFrom<Plain> for Skeleton {
    type Error = SkeletonError;

    fn try_from(plain: Plain) -> Result<Self, SkeletonError> {
        let mut skeleton = Skeleton::new(plain.root)?;
        (skeleton.name, skeleton.units) = (plain.name, plain.units);
        for (parent, bone) in plain.bones {
            skeleton.add_bone(parent, bone)?;
        }
        Ok(skeleton)
    }
}

/// Why a bone cannot be added to a skeleton.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SkeletonError {
    /// No bone has this id (yet).
    UnknownParent(BoneId),
    /// A bone cannot be called like this.
    Name(String),
    /// Another bone has this name.
    RepeatedName(String),
    /// One bone lists this dof twice.
    RepeatedDof(Channel),
    /// The bone's axes are turned in no order.
    NoOrder(String),
}

impl fmt::Display for SkeletonError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SkeletonError::UnknownParent(id) => write!(f, "there is no bone {} to hang a bone on", id.0),
            SkeletonError::Name(name) => write!(
                f,
                "a bone cannot be called {name:?}: a name is one word of at most {LONGEST_NAME} bytes that does not \
                 begin with `:` or `#` and is not `begin`, `end` or `root`"
            ),
            SkeletonError::RepeatedName(name) => write!(f, "there is a bone `{name}` already"),
            SkeletonError::RepeatedDof(channel) => {
                write!(f, "the dof {} occurs twice", DegreeOfFreedom::word(*channel))
            }
            SkeletonError::NoOrder(name) => write!(f, "the axis of `{name}` has no order of rotation"),
        }
    }
}

impl std::error::Error for SkeletonError {}
