//! Editing a motion: frames between keyframes are interpolated, and the keyframes are set by hand or chosen automatically.

mod hand;
mod wish;

pub use hand::Hand;
pub use wish::{Keys, Wish};
