//! Motions reduced to keyframes, and what that costs, as files.

pub mod angles;
mod choose;
mod curves;
mod plot;
mod reduced;

pub use choose::{Choice, Method, TooLong};
pub use curves::write_csv;
pub use plot::svg;
pub use reduced::{Misfit, Reduced, reduced};
