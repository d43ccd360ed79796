//! What is to be seen: plain data, no pixels.
//!
//! A [`Scene`] is filled anew for every picture, from poses and texts, and says nothing about how things are drawn:
//! colours, widths and shapes are up to [`Painter`](crate::draw::Painter). It is kept from picture to picture, so that
//! filling it takes no new memory.

use std::fmt::{self, Write};
use std::ops::Deref;

use glam::{Quat, Vec3};

use crate::camera::Camera;
use crate::draw::canvas::Ground;

/// Everything in one picture. Lengths are in world units: those of the motion's file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scene {
    /// From where it is seen.
    pub camera: Camera,
    /// The plane below.
    pub ground: Ground,
    /// How the solid figure is drawn.
    pub style: Style,
    /// How large a figure is: the diagonal of the box around its rest pose.
    pub size: f32,
    /// The skeletons.
    pub figures: Pool<Figure>,
    /// Where End Sites have been.
    pub trails: Pool<Trail>,
    /// Arrows and words in the world.
    pub marks: Vec<Mark>,
    /// How large texts are: 1 is the size for an ordinary display.
    pub text_scale: f32,
    /// Texts on top of the picture.
    pub panels: Pool<Panel>,
    /// The bar that shows the frame among all frames.
    pub timeline: Option<Timeline>,
    /// A length to compare with.
    pub scale_bar: Option<ScaleBar>,
}

/// How the solid figure is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Style {
    /// As lit bodies with shadows.
    #[default]
    Lit,
    /// As plain lines.
    Lines,
}

/// A list whose items are kept, with their memory, when it is cleared.
#[derive(Clone, Debug, Default)]
pub struct Pool<T> {
    items: Vec<T>,
    used: usize,
}

impl<T> Pool<T> {
    /// Takes everything out.
    pub fn clear(&mut self) {
        self.used = 0;
    }

    /// Adds an item and gives it, as an earlier use has left it.
    pub fn add(&mut self) -> &mut T
    where
        T: Default,
    {
        if self.used == self.items.len() {
            self.items.push(T::default());
        }
        self.used += 1;
        &mut self.items[self.used - 1]
    }

    /// The items, to be changed.
    pub fn items_mut(&mut self) -> &mut [T] {
        &mut self.items[..self.used]
    }
}

impl<T> Deref for Pool<T> {
    type Target = [T];

    fn deref(&self) -> &[T] {
        &self.items[..self.used]
    }
}

impl<T: PartialEq> PartialEq for Pool<T> {
    fn eq(&self, other: &Pool<T>) -> bool {
        **self == **other
    }
}

impl<'a, T> IntoIterator for &'a Pool<T> {
    type Item = &'a T;
    type IntoIter = std::slice::Iter<'a, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl<T> FromIterator<T> for Pool<T> {
    fn from_iter<I: IntoIterator<Item = T>>(items: I) -> Pool<T> {
        let items: Vec<T> = items.into_iter().collect();
        Pool { used: items.len(), items }
    }
}

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

/// The part that a figure plays.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Look {
    /// The one to look at: bones, squares and axes in full colours.
    #[default]
    Solid,
    /// The same, pale: it is not up to date.
    Dimmed,
    /// The goal: thin and translucent.
    Ghost,
    /// An echo of the solid figure at another time. `0` is invisible, `1` as strong as the ghost.
    Echo(f32),
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

/// A length in the world to compare with.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ScaleBar {
    /// In world units.
    pub length: f32,
    /// The length in words.
    pub label: String,
}

/// Where the shown frame is among all frames.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Timeline {
    /// The frame, from 0.
    pub frame: usize,
    /// How many frames there are: at least 1.
    pub count: usize,
    /// The first and the last frame that are played.
    pub range: (usize, usize),
    /// Whether it is playing.
    pub playing: bool,
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
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Panel {
    /// Where it is.
    pub corner: Corner,
    text: String,
    /// What each line is, and where it ends in `text`.
    lines: Vec<(Line, usize)>,
}

impl Panel {
    /// Takes all lines out and puts the panel into a corner.
    pub fn begin(&mut self, corner: Corner) {
        self.corner = corner;
        self.text.clear();
        self.lines.clear();
    }

    /// Adds a line.
    pub fn add(&mut self, line: Line, text: impl fmt::Display) {
        // A string takes whatever is written to it.
        let _ = write!(self.text, "{text}");
        self.lines.push((line, self.text.len()));
    }

    /// The lines, from the top.
    pub fn lines(&self) -> impl Iterator<Item = (Line, &str)> {
        let starts = [0].into_iter().chain(self.lines.iter().map(|(_, end)| *end));
        starts.zip(&self.lines).map(|(start, (line, end))| (*line, &self.text[start..*end]))
    }
}

/// A corner of the picture. Two panels in one corner stand below each other.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Corner {
    /// Above, on the left.
    #[default]
    TopLeft,
    /// Above, on the right.
    TopRight,
    /// Below, on the left.
    BottomLeft,
    /// Below, on the right.
    BottomRight,
}

/// What a line of a panel is. Long ones are broken where the picture ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Line {
    /// Bold.
    Heading,
    /// Plain.
    Text,
    /// Less important.
    Quiet,
    /// Something is right.
    Right,
    /// Something is wrong.
    Trouble,
    /// A key, or a name, and what belongs to it.
    Key(&'static str),
    /// A colour and what it stands for.
    Legend(Tint),
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panel_gives_its_lines_back() {
        let mut panel = Panel::default();
        for round in 0..2 {
            panel.begin(Corner::BottomLeft);
            panel.add(Line::Heading, format_args!("round {round}"));
            panel.add(Line::Text, "");
            panel.add(Line::Key("h"), "help");
            let lines: Vec<_> = panel.lines().map(|(line, text)| (line, text.to_owned())).collect();
            let first = format!("round {round}");
            assert_eq!(
                lines,
                [(Line::Heading, first), (Line::Text, String::new()), (Line::Key("h"), "help".into())]
            );
        }
    }

    #[test]
    fn a_cleared_pool_keeps_the_memory_of_its_items() {
        let mut pool = Pool::<Vec<u8>>::default();
        pool.add().extend([1, 2, 3]);
        pool.clear();
        assert!(pool.is_empty());
        let again = pool.add();
        assert!(again.capacity() >= 3);
        again.clear();
        assert_eq!(pool, Pool::from_iter([Vec::new()]));
    }
}
