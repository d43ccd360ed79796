//! One bone, and what can move in it.

use std::fmt;

use glam::{Quat, Vec3};

use crate::{Axis, Channel, RotationOrder};

/// A bone's place in its skeleton. The root is 0; a parent stands before its children.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct BoneId(pub usize);

impl BoneId {
    /// The root of every skeleton.
    pub const ROOT: BoneId = BoneId(0);
}

/// How a bone's own axes are turned against the world's in the rest pose.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct LocalAxes {
    /// The angles about X, Y and Z, in degrees.
    pub angles: [f32; 3],
    /// The order in which the three rotations are multiplied, the first one leftmost. What a file calls `XYZ` is
    /// `Zyx` here: it is meant about fixed axes, X first, so that the product is Rz * Ry * Rx.
    pub order: RotationOrder,
}

impl LocalAxes {
    /// The world's own axes.
    pub const WORLD: LocalAxes = LocalAxes { angles: [0.0; 3], order: RotationOrder::Zyx };

    /// The order as files write it, `XYZ` for `Zyx`: that of the product from right to left. Nothing where there is no order.
    pub fn letters(&self) -> String {
        self.order.axes().into_iter().flatten().rev().map(|axis| axis.to_string()).collect()
    }

    /// The rotation from the world's axes to these.
    pub(super) fn rotation(&self) -> Quat {
        let axes = self.order.axes().into_iter().flatten();
        let turn = |axis: Axis| Quat::from_axis_angle(axis.unit(), self.angles[axis.index()].to_radians());
        axes.map(turn).fold(Quat::IDENTITY, |product, turn| product * turn).normalize()
    }
}

impl Default for LocalAxes {
    fn default() -> Self {
        LocalAxes::WORLD
    }
}

/// One way in which a bone can move: a dof, as files say.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct DegreeOfFreedom {
    /// What the motion's number means: a rotation about one of the bone's own axes, in degrees, or a translation of the
    /// bone's end along one of the world's axes, in the file's unit.
    pub channel: Channel,
    /// The least that the bone should be moved; −∞ where there is no limit. Motions may go beyond.
    pub low: f32,
    /// The most that the bone should be moved; ∞ where there is no limit.
    pub high: f32,
}

impl DegreeOfFreedom {
    /// A movement without limits.
    pub fn unlimited(channel: Channel) -> Self {
        DegreeOfFreedom { channel, low: f32::NEG_INFINITY, high: f32::INFINITY }
    }

    /// Whether this movement has a limit on either side.
    pub fn is_limited(&self) -> bool {
        self.low != f32::NEG_INFINITY || self.high != f32::INFINITY
    }

    /// The word that files use for a channel, for example `rx` or `tz`.
    pub fn word(channel: Channel) -> &'static str {
        match channel {
            Channel::Position(Axis::X) => "tx",
            Channel::Position(Axis::Y) => "ty",
            Channel::Position(Axis::Z) => "tz",
            Channel::Rotation(Axis::X) => "rx",
            Channel::Rotation(Axis::Y) => "ry",
            Channel::Rotation(Axis::Z) => "rz",
        }
    }

    /// The channel that a word of a file names, in upper or lower case; `None` for any other word.
    pub fn channel_of(word: &str) -> Option<Channel> {
        let all = Axis::ALL.into_iter().flat_map(|axis| [Channel::Position(axis), Channel::Rotation(axis)]);
        all.into_iter().find(|&channel| Self::word(channel).eq_ignore_ascii_case(word))
    }
}

impl fmt::Display for DegreeOfFreedom {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(Self::word(self.channel))
    }
}

/// What a file says of one bone.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct BoneData {
    /// One word, in any letters.
    pub name: String,
    /// Where the bone points in the rest pose, in the world's axes: a unit vector.
    pub direction: Vec3,
    /// From start to end, in the file's unit.
    pub length: f32,
    /// The axes about which the bone turns.
    pub axis: LocalAxes,
    /// What can move, in the order of the motion's numbers. Of the rotations the last one is leftmost in the product.
    pub dofs: Vec<DegreeOfFreedom>,
}

/// A bone, or the root.
///
/// The tree is that of first children and next siblings: to visit all that hangs on a bone, go to its `child`, and
/// from there from `sibling` to `sibling`.
#[derive(Clone, Debug, PartialEq)]
pub struct Bone {
    /// This bone's own place in the skeleton and in a posture.
    pub id: BoneId,
    /// The name, by which a file's other parts and its motions refer to the bone; `root` for the root.
    pub name: String,
    /// The bone where this one starts; `None` for the root.
    pub parent: Option<BoneId>,
    /// The first of the bones that start at the end of this one.
    pub child: Option<BoneId>,
    /// The next bone with the same parent.
    pub sibling: Option<BoneId>,
    /// Where the bone points in the rest pose, in the world's axes: a unit vector. Zero for the root.
    pub direction: Vec3,
    /// From start to end, in the file's unit. Zero for the root.
    pub length: f32,
    /// The bone's own axes as the file gives them. For the root, its `orientation`.
    pub axis: LocalAxes,
    /// What can move, in the order of the motion's numbers; nothing for a bone that is fixed to its parent.
    pub dofs: Vec<DegreeOfFreedom>,
    /// In which order the rotations about the bone's own axes are multiplied, the first one leftmost: that of the dofs
    /// from last to first. `None` for a bone without dofs.
    pub rotation_order: RotationOrder,
    /// C: turns the world's axes into the bone's own, in the rest pose.
    pub axis_rotation: Quat,
    /// C of the parent, inverted, times C: turns the parent's own axes into this bone's, in the rest pose. For the root
    /// it is C, since the world is its parent.
    pub rot_parent_current: Quat,
    /// The direction in the bone's own axes: C⁻¹ × direction.
    pub local_direction: Vec3,
}

impl Bone {
    /// Whether this is the root.
    pub fn is_root(&self) -> bool {
        self.parent.is_none()
    }

    /// From start to end in the rest pose, in the world's axes, in the file's unit.
    pub fn rest_vector(&self) -> Vec3 {
        self.length * self.direction
    }
}

/// The order in which the rotations of `dofs` are multiplied, the first one leftmost: the reverse of the list. An axis
/// that is missing has the angle zero, so that it may stand anywhere. It stands where the list would be X, Y, Z if
/// that can be, because programs that let all bones turn about all axes mean that.
pub(super) fn rotation_order(dofs: &[DegreeOfFreedom]) -> RotationOrder {
    if dofs.is_empty() {
        return RotationOrder::None;
    }
    let mut axes: Vec<Axis> = Vec::with_capacity(3);
    for dof in dofs {
        if let Channel::Rotation(axis) = dof.channel {
            axes.push(axis);
        }
    }
    if axes.is_sorted_by_key(|axis| axis.index()) {
        axes = Axis::ALL.to_vec();
    }
    for axis in Axis::ALL {
        if !axes.contains(&axis) {
            axes.push(axis);
        }
    }
    let product: Vec<Channel> = axes.into_iter().rev().map(Channel::Rotation).collect();
    RotationOrder::of_channels(&product)
}
