//! Curves in a corner of the picture.

use super::Pool;

/// A plot of curves. Places in it are shares of its width, from the left, and of its height, from below.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Plot {
    /// How many of the panels find their place before it does.
    pub behind: usize,
    /// Whether it is a small one. Then the names of its curves stand above them, and not at their ends.
    pub small: bool,
    /// What goes upwards.
    pub upwards: String,
    /// What goes to the right.
    pub rightwards: String,
    /// Numbers on the axis to the right.
    pub columns: Pool<Tick>,
    /// Numbers on the axis upwards.
    pub rows: Pool<Tick>,
    /// Places on the axis to the right at which something begins or ends: shares of the width.
    pub posts: Vec<f32>,
    /// The curves.
    pub curves: Pool<Curve>,
    /// The present state.
    pub mark: Option<(f32, f32)>,
    /// Why there are no curves, when there are none.
    pub note: String,
}

/// A number on an axis.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tick {
    /// Where it stands.
    pub at: f32,
    /// The number.
    pub label: String,
}

/// One curve and its name.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Curve {
    /// What it is called.
    pub name: String,
    /// How it is drawn.
    pub stroke: Stroke,
    /// Its points, from the left to the right.
    pub points: Vec<(f32, f32)>,
}

/// How a curve is drawn. Each can be told from the others by more than its colour.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Stroke {
    /// Without gaps.
    #[default]
    Solid,
    /// With gaps.
    Dashed,
    /// Thin and with gaps: what others are compared with.
    Faint,
}
