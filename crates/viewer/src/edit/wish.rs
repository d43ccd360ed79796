//! What a user wants to see of an edited motion.

use skeleton::Representation;

/// What is interpolated, and how.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Wish {
    /// What of the rotations is interpolated.
    pub representation: Representation,
    /// Between which keyframes.
    pub keys: Keys,
    /// Whether the error curves of both representations are wanted too.
    pub curves: bool,
}

/// Where keyframes come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Keys {
    /// The first and the last frame of a stretch, set by hand. Frames outside are as they are.
    Ends(usize, usize),
    /// So many keyframes, chosen over the whole motion.
    Automatic(usize),
}
