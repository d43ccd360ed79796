//! Skeletons in their poses.

use glam::{Quat, Vec3};

/// One skeleton in one pose.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Figure {
    /// How it stands out from others.
    pub look: Look,
    /// Between joints.
    pub bones: Vec<Bone>,
    /// The joints, End Sites included.
    pub joints: Vec<Dot>,
    /// Local axes of joints.
    pub axes: Vec<Axes>,
}

impl Figure {
    /// Moves all of it.
    pub fn shift(&mut self, by: Vec3) {
        for bone in &mut self.bones {
            (bone.from, bone.to) = (bone.from + by, bone.to + by);
        }
        self.joints.iter_mut().for_each(|joint| joint.place += by);
        self.axes.iter_mut().for_each(|axes| axes.origin += by);
    }
}

/// The part that a figure plays.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Look {
    /// The one to look at: bones, squares and axes in full colours.
    #[default]
    Solid,
    /// The same, bright green for a moment: at a keyframe.
    Flash,
    /// The same as the solid one, pale: it is not up to date.
    Dimmed,
    /// The goal: thin and translucent.
    Ghost,
    /// An echo of the solid figure at another time. `0` is invisible, `1` as strong as the ghost.
    Echo(f32),
}

impl Look {
    /// Whether it is the figure to look at, up to date or not.
    pub fn is_solid(self) -> bool {
        matches!(self, Look::Solid | Look::Flash | Look::Dimmed)
    }
}

/// From a joint to its parent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bone {
    /// The parent's end.
    pub from: Vec3,
    /// The joint's end.
    pub to: Vec3,
    /// On which side of the body it is.
    pub side: Side,
    /// How thick it is where bones have a body.
    pub radius: f32,
    /// The joints at its ends, counted as in [`Figure::joints`]: the parent, and the joint itself.
    pub joints: (usize, usize),
}

/// A joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dot {
    /// Where it is.
    pub place: Vec3,
    /// How far that is from where it should be.
    pub off: Off,
    /// Whether it is the one that the user looks at.
    pub selected: bool,
}

impl From<Vec3> for Dot {
    /// A joint in its right place.
    fn from(place: Vec3) -> Dot {
        Dot { place, off: Off::Right, selected: false }
    }
}

/// How far a joint is from its right place, compared with the size of the figure.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Off {
    /// Within the tolerance of the checks.
    #[default]
    Right,
    /// Up to a fiftieth of the figure's size.
    Little,
    /// Up to a tenth of it.
    Some,
    /// More.
    Much,
}

impl Off {
    /// The share of the size that counts as right: the tolerance of the checks.
    pub const RIGHT: f32 = grading::fk::POSITION_TOLERANCE;
    /// Up to this share it is little.
    pub const LITTLE: f32 = 0.02;
    /// Up to this share it is some.
    pub const SOME: f32 = 0.1;

    /// For a joint that is off by this share of the figure's size.
    pub fn by(share: f32) -> Off {
        match share {
            share if share <= Off::RIGHT => Off::Right,
            share if share <= Off::LITTLE => Off::Little,
            share if share <= Off::SOME => Off::Some,
            _ => Off::Much,
        }
    }
}

/// A side of the body.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Side {
    /// The figure's own left.
    Left,
    /// The figure's own right.
    Right,
    /// Neither, or unknown.
    #[default]
    Middle,
}

/// The local axes of a joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axes {
    /// Where they start.
    pub origin: Vec3,
    /// How they are turned against the world's.
    pub rotation: Quat,
    /// How long each is, in world units.
    pub length: f32,
    /// Whether their tips carry the letters X, Y and Z.
    pub lettered: bool,
}
