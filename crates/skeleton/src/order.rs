//! The rotation order of a joint.

use std::fmt;

use crate::{Axis, Channel};

/// In which order a joint's three angles arrive, and so in which order its three rotations are multiplied.
///
/// `Zyx` means that the frame holds the angle about Z first, then Y, then X, and that the local rotation is
/// `Rz * Ry * Rx`: intrinsic rotations, each about the axes that the rotations before it have already turned.
/// The numbers are those of the original assignment's `enum`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[repr(u8)]
pub enum RotationOrder {
    /// No rotation channels: the frame holds no angles for this joint. End Sites are like this.
    #[default]
    None = 0,
    /// Z, then Y, then X.
    Zyx = 1,
    /// Y, then Z, then X.
    Yzx = 2,
    /// Z, then X, then Y.
    Zxy = 3,
    /// X, then Z, then Y.
    Xzy = 5,
    /// Y, then X, then Z.
    Yxz = 6,
    /// X, then Y, then Z.
    Xyz = 7,
}

impl RotationOrder {
    /// The six orders that rotate, without `None`.
    pub const ROTATING: [RotationOrder; 6] = [
        RotationOrder::Zyx,
        RotationOrder::Yzx,
        RotationOrder::Zxy,
        RotationOrder::Xzy,
        RotationOrder::Yxz,
        RotationOrder::Xyz,
    ];

    /// The axes in the order of their angles, or `None` for [`RotationOrder::None`].
    pub fn axes(self) -> Option<[Axis; 3]> {
        use Axis::{X, Y, Z};
        match self {
            RotationOrder::None => None,
            RotationOrder::Zyx => Some([Z, Y, X]),
            RotationOrder::Yzx => Some([Y, Z, X]),
            RotationOrder::Zxy => Some([Z, X, Y]),
            RotationOrder::Xzy => Some([X, Z, Y]),
            RotationOrder::Yxz => Some([Y, X, Z]),
            RotationOrder::Xyz => Some([X, Y, Z]),
        }
    }

    /// The order that a joint's channels ask for. Position channels do not matter. With one or two rotation
    /// channels the missing axes follow in the order X, Y, Z: their angles are zero, so that any place is right.
    pub fn of_channels(channels: &[Channel]) -> RotationOrder {
        let mut axes: Vec<Axis> = Vec::with_capacity(3);
        for channel in channels {
            if let Channel::Rotation(axis) = *channel
                && !axes.contains(&axis)
            {
                axes.push(axis);
            }
        }
        if axes.is_empty() {
            return RotationOrder::None;
        }
        for axis in Axis::ALL {
            if !axes.contains(&axis) {
                axes.push(axis);
            }
        }
        let same = |order: &RotationOrder| order.axes().is_some_and(|own| own[..] == axes[..]);
        RotationOrder::ROTATING.into_iter().find(same).unwrap_or_default()
    }
}

impl fmt::Display for RotationOrder {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            RotationOrder::None => "NONE",
            RotationOrder::Zyx => "ZYX",
            RotationOrder::Yzx => "YZX",
            RotationOrder::Zxy => "ZXY",
            RotationOrder::Xzy => "XZY",
            RotationOrder::Yxz => "YXZ",
            RotationOrder::Xyz => "XYZ",
        })
    }
}
