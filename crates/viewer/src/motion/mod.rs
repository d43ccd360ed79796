//! Motions set up for being looked at.

pub mod body;
pub mod bones;
mod sides;
pub mod source;
pub mod stage;
pub mod time_map;
pub mod upright;
