//! What stands in the world beside figures: traces, arrows and words.

use glam::Vec3;

use super::{Off, Side};

/// Where a joint has been, from long ago until now.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Trail {
    /// Which one it is: trails that are counted differently get colours that can be told apart, where they have no side.
    pub index: usize,
    /// On which side of the body the joint is.
    pub side: Side,
    /// The places, the present one last.
    pub points: Vec<Vec3>,
}

/// An arrow, a word, or both, in the world.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// Where the arrow starts; without a start there is no arrow.
    pub from: Option<Vec3>,
    /// Where the arrow ends.
    pub to: Vec3,
    /// What is written beside the tip.
    pub text: String,
    /// Where the text stands, in pixels to the right of and below the tip. To the left it ends there, to the right it
    /// begins there, and straight above or below it is centred. From farther away a thin line leads to the tip.
    pub text_offset: (i32, i32),
    /// What it is about.
    pub tint: Tint,
}

/// What a colour stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tint {
    /// A joint.
    Joint,
    /// A bone on a side of the body, as a line.
    Bone(Side),
    /// The same in the light.
    Body(Side),
    /// A joint that is off.
    Off(Off),
    /// The goal.
    Ghost,
    /// How far an interpolated joint is from the original one.
    Error,
    /// A keyframe.
    Keyframe,
    /// The X axis.
    X,
    /// The Y axis.
    Y,
    /// The Z axis.
    Z,
    /// Anything else: dark.
    Ink,
}
