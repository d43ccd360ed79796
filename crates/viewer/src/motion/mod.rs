//! Motions set up for being looked at.

pub mod body;
mod sides;
pub mod source;
pub mod stage;
pub mod upright;
