//! Grading the forward-kinematics exercise.

mod compare;
pub(crate) mod figure;
mod misconceptions;
mod paper;
mod rubric;
mod variants;
mod whole_motion;

pub use compare::{POSITION_TOLERANCE, ROTATION_TOLERANCE, angle_between};
pub use misconceptions::{accepted, misconceptions};
pub use paper::exam;
pub use rubric::RUBRIC;
pub use variants::TEMPLATE;
