//! Grading the exercise on interpolation.

mod compare;
mod misconceptions;
mod paper;
mod rubric;
mod variants;
mod whole_motion;

pub use compare::{ANGLE_TOLERANCE, CLOSE_TOLERANCE};
pub use misconceptions::{accepted, misconceptions};
pub use paper::exam;
pub use rubric::RUBRIC;
pub use variants::TEMPLATE;
