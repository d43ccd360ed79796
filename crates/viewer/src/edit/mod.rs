//! Editing a motion: frames between keyframes are interpolated, and the keyframes are set by hand or chosen automatically.
//!
//! A [`Wish`] says what is wanted, and a [`Hand`] does the work: the reference's, or a student's. [`perform`] makes an
//! [`Edited`] motion of both, here and now; an [`Engine`] does so on a thread of its own, for a window.

mod edited;
mod engine;
mod hand;
mod perform;
mod reductions;
mod reference;
#[cfg(test)]
mod tests;
mod wish;

pub use edited::Edited;
pub use engine::{Engine, EngineState};
pub use hand::{Hand, Maker, Makers, Progress};
pub use perform::{MOST_JOINTS, NotEdited, is_too_long, perform, root_mean_square};
pub use reductions::{Curves, Reductions, remaining};
pub use reference::ReferenceHand;
pub use wish::{Keys, Wish};
