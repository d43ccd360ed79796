//! Grading the exercise on time warping.

mod compare;
mod misconceptions;
mod paper;
mod rubric;
mod throws;
mod variants;
mod whole_motion;

pub use compare::{PLACE_TOLERANCE, TRANSLATION_TOLERANCE};
pub use misconceptions::{accepted, misconceptions};
pub use paper::exam;
pub use rubric::RUBRIC;
pub use variants::TEMPLATE;
