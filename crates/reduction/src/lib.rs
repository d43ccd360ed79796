//! Motions reduced to keyframes, fast, and the best that can be done.
//!
//! A frame that is no keyframe is interpolated between the nearest keyframes before and after it. Its error is the
//! sum, over the tips of the skeleton, of the squared distances to where they are in the motion. [`Errors`] tells it
//! for single frames, for gaps between two keyframes, and for whole reductions. [`greedy`] and [`curve`] remove one
//! keyframe after the other, always the one that costs least; [`local_moves`] improves what they leave; [`optimum`]
//! is the least error that any so many keyframes can have.
//!
//! # Ties and noise
//!
//! Of several keyframes that cost the same, the earliest is removed. Where a motion stands still all costs would be
//! rounding, and chance would choose. So a gap that [stands still](inbetween#standing-still) has an error of exactly
//! 0, and is not posed at all. This rule is in the errors and in no algorithm: any that looks at the same errors
//! removes the same keyframes. And a motion that stands still from end to end, where the gap at the front grows by
//! one frame with each removal, costs next to nothing.
//!
//! # Odd input
//!
//! A count below 2 counts as 2, and one above the number of frames as that number. The first and the last frame
//! always stay. A motion without frames has no keyframes. Errors of frames that a motion does not have are not a
//! number.
#![deny(missing_docs)]

mod errors;
mod greedy;
mod moves;
mod optimum;

pub use errors::Errors;
pub use greedy::{Curve, curve, greedy};
pub use moves::local_moves;
pub use optimum::{Optimum, optimum};
