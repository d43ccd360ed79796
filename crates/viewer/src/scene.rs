//! What is to be seen: plain data, no pixels.
//!
//! A [`Scene`] is made anew for every picture, from poses and texts, and says nothing about how things are drawn:
//! colours, widths and shapes are up to [`Painter`](crate::draw::Painter).

use glam::{Quat, Vec3};

use crate::camera::Camera;
use crate::canvas::Ground;

/// Everything in one picture. Lengths are in world units: those of the motion's file.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// From where it is seen.
    pub camera: Camera,
    /// The plane below.
    pub ground: Ground,
    /// The skeletons.
    pub figures: Vec<Figure>,
    /// Arrows and words in the world.
    pub marks: Vec<Mark>,
    /// How long a joint's axes are drawn.
    pub axis_length: f32,
    /// Texts on top of the picture.
    pub panels: Vec<Panel>,
}

/// One skeleton in one pose.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// How it stands out from others.
    pub look: Look,
    /// Lines between joints.
    pub bones: Vec<Bone>,
    /// The joints' places, End Sites included.
    pub joints: Vec<Vec3>,
    /// Local axes of joints.
    pub axes: Vec<Axes>,
}

/// The part that a figure plays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Look {
    /// The one to look at: bones, squares and axes in full colours.
    Solid,
    /// The goal: thin and translucent.
    Ghost,
    /// An echo of the solid figure at another time. `0` is invisible, `1` as strong as the ghost.
    Echo(f32),
}

/// A line from a joint to its parent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bone {
    /// The parent's end.
    pub from: Vec3,
    /// The joint's end.
    pub to: Vec3,
    /// On which side of the body it is.
    pub side: Side,
}

/// A side of the body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// The figure's own left.
    Left,
    /// The figure's own right.
    Right,
    /// Neither, or unknown.
    Middle,
}

/// The local axes of a joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axes {
    /// Where they start.
    pub origin: Vec3,
    /// How they are turned against the world's.
    pub rotation: Quat,
    /// Whether their tips carry the letters X, Y and Z.
    pub lettered: bool,
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
    /// A bone on a side of the body.
    Bone(Side),
    /// The goal.
    Ghost,
    /// The X axis.
    X,
    /// The Y axis.
    Y,
    /// The Z axis.
    Z,
    /// Anything else: dark.
    Ink,
}

/// A block of text in a corner of the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// Where it is.
    pub corner: Corner,
    /// Its lines, from the top.
    pub lines: Vec<Line>,
}

/// A corner of the picture. Two panels in one corner stand below each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Corner {
    /// Above, on the left.
    TopLeft,
    /// Below, on the left.
    BottomLeft,
    /// Below, on the right.
    BottomRight,
}

/// A line of a panel. Long ones are broken where the picture ends.
#[derive(Clone, Debug, PartialEq)]
pub enum Line {
    /// Bold.
    Heading(String),
    /// Plain.
    Text(String),
    /// Something is wrong.
    Trouble(String),
    /// A key and what it does.
    Key(&'static str, String),
    /// A colour and what it stands for.
    Legend(Tint, String),
}
