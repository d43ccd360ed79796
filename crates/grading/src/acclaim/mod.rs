//! Grading the exercise on Acclaim forward kinematics.

mod compare;
mod figure;
mod misconceptions;
mod paper;
mod rubric;
mod variants;
mod whole_motion;

pub use misconceptions::{accepted, misconceptions};
pub use paper::exam;
pub use rubric::RUBRIC;
pub use variants::TEMPLATE;
