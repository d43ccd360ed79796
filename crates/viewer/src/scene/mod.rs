//! What is to be seen: plain data, no pixels.
//!
//! A [`Scene`] is filled anew for every picture, from poses and texts, and says nothing about how things are drawn:
//! colours, widths and shapes are up to [`Painter`](crate::draw::Painter). It is kept from picture to picture, so that
//! filling it takes no new memory.

mod figure;
mod instruments;
mod marks;
mod panel;
mod plot;
mod pool;

use crate::camera::Camera;
use crate::draw::canvas::Ground;

pub use figure::{Axes, Bone, Dot, Figure, Look, Off, Side};
pub use instruments::{ScaleBar, Timeline};
pub use marks::{Mark, Tint, Trail};
pub use panel::{Corner, Line, Panel};
pub use plot::{Curve, Plot, Stroke, Tick};
pub use pool::Pool;

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
    /// Frames that are marked on this bar, in ascending order.
    pub keyframes: Vec<usize>,
    /// Curves in a corner.
    pub plot: Option<Plot>,
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
