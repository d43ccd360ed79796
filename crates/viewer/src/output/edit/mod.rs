//! Motions reduced to keyframes, and what that costs, as files.

pub mod angles;
mod choose;
mod curves;
pub mod experiment;
mod plot;
mod reduced;
mod reordered;

use reduction::Errors;

pub use choose::{Choice, Method, TooLong};
pub use curves::write_csv;
pub use plot::svg;
pub use reduced::{Misfit, Reduced, reduced};
pub use reordered::reordered;

/// The root of the mean of the squared distances between where a tip is and where it should be, over all tips and all frames, in
/// the file's unit. `error` is the sum of the squares. 0 for a motion without frames.
pub fn rms(errors: &Errors, error: f64) -> f64 {
    let places = errors.clip().tips(0).len() * errors.frame_count();
    if places == 0 { 0.0 } else { (error.max(0.0) / places as f64).sqrt() }
}
