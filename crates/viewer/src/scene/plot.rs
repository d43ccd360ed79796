//! Curves in a corner of the picture.

use skeleton::Representation;

use super::Pool;

/// A plot of curves. Places in it are shares of its width, from the left, and of its height, from below.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Plot {
    /// How many of the panels find their place before it does.
    pub behind: usize,
    /// What goes upwards.
    pub upwards: String,
    /// What goes to the right.
    pub rightwards: String,
    /// Numbers on the axis to the right.
    pub columns: Pool<Tick>,
    /// Numbers on the axis upwards.
    pub rows: Pool<Tick>,
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

/// One curve. Its name stands at its end.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Curve {
    /// Whose errors these are.
    pub representation: Representation,
    /// Its points, from the left to the right.
    pub points: Vec<(f32, f32)>,
}
