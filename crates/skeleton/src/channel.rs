//! Axes, and the channels that a motion stores per joint.

use std::fmt;

use glam::Vec3;

/// One of the three coordinate axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Axis {
    /// The first axis.
    X,
    /// The second axis.
    Y,
    /// The third axis.
    Z,
}

impl Axis {
    /// All three, in the order X, Y, Z.
    pub const ALL: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

    /// The unit vector along this axis.
    pub fn unit(self) -> Vec3 {
        match self {
            Axis::X => Vec3::X,
            Axis::Y => Vec3::Y,
            Axis::Z => Vec3::Z,
        }
    }

    /// 0 for X, 1 for Y, 2 for Z: the component of a vector that lies along this axis.
    pub fn index(self) -> usize {
        self as usize
    }
}

/// What one number of a frame's row means for its joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Channel {
    /// A local position along one axis, in the motion's unit.
    Position(Axis),
    /// A rotation about one local axis, in degrees, counter-clockwise when the axis points at the viewer.
    Rotation(Axis),
}

impl Channel {
    /// The BVH word for this channel, for example `Xposition`.
    pub fn word(self) -> &'static str {
        match self {
            Channel::Position(Axis::X) => "Xposition",
            Channel::Position(Axis::Y) => "Yposition",
            Channel::Position(Axis::Z) => "Zposition",
            Channel::Rotation(Axis::X) => "Xrotation",
            Channel::Rotation(Axis::Y) => "Yrotation",
            Channel::Rotation(Axis::Z) => "Zrotation",
        }
    }

    /// The channel that a BVH word names, in any mix of upper and lower case; `None` for any other word.
    pub fn from_word(word: &str) -> Option<Channel> {
        let all = Axis::ALL.into_iter().flat_map(|axis| [Channel::Position(axis), Channel::Rotation(axis)]);
        all.into_iter().find(|channel| channel.word().eq_ignore_ascii_case(word))
    }
}

impl fmt::Display for Axis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(["X", "Y", "Z"][self.index()])
    }
}

impl fmt::Display for Channel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.word())
    }
}
