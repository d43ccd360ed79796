//! Motions reduced to keyframes, and what that costs, as files.

mod choose;
mod curves;
pub mod experiment;
mod plot;
mod reduced;
mod reordered;

use reduction::Errors;

use crate::edit::root_mean_square;

pub use choose::{Choice, Method, TooLong};
pub use curves::write_csv;
pub use plot::svg;
pub(crate) use reduced::LEAST_MISFIT;
pub use reduced::{Misfit, Reduced, reduced};
pub use reordered::reordered;
pub(crate) use reordered::turns;

/// The [`root_mean_square`] over all tips and all frames of a motion whose accumulated error is `error`.
pub fn rms(errors: &Errors, error: f64) -> f64 {
    root_mean_square(error, errors.clip().tips(0).len() * errors.frame_count())
}
