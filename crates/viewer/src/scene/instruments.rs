//! What measures time and lengths.

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
