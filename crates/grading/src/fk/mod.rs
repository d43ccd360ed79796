//! Grading the forward-kinematics exercise.

mod compare;
pub(crate) mod misconceptions;
mod paper;
mod rubric;
pub(crate) mod variants;
mod whole_motion;

pub use crate::compare::{POSITION_TOLERANCE, ROTATION_TOLERANCE, angle_between};
pub use misconceptions::{accepted, misconceptions};
pub use paper::exam;
pub use rubric::RUBRIC;
pub use variants::TEMPLATE;
