//! Makes the motions in `data/`.
#![deny(missing_docs)]

mod error;
mod humanoid;
mod leg;
mod math;
mod recorder;
mod running;
mod spline;

pub use error::Error;
pub use parser::bvh::write;
pub use running::running;

/// The seconds between two frames, as motion files recorded at 120 frames per second write them.
const FRAME_TIME: f64 = 0.008333;
