//! Motions reduced to keyframes, and what that costs, as files.

pub mod angles;
