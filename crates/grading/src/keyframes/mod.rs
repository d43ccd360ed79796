//! Grading the exercise on keyframes.

mod clip;
mod compare;
mod misconceptions;
mod paper;
mod rubric;
mod variants;
mod wander;
mod whole_motion;

pub use compare::ERROR_TOLERANCE;
pub use misconceptions::misconceptions;
pub use paper::exam;
pub use rubric::RUBRIC;
pub use variants::TEMPLATE;
