//! The misconceptions of interpolation: what is said about each, what it costs, and how it is recognised.

mod part1;
mod part2;
mod part3;

use super::variants::{frame::ShortPi, functions};
use crate::fk::misconceptions::short_pis;
use crate::{Accepted, Misconception};

/// Ways to answer a part that get full points, with a remark.
pub fn accepted(part: &str) -> Vec<Accepted> {
    match part {
        "part3" => short_pis!("The π in your rotations", "joints", P => functions::<ShortPi<P>>()),
        _ => Vec::new(),
    }
}

/// The misconceptions of one part.
pub fn misconceptions(part: &str) -> Vec<Misconception> {
    match part {
        "part1" => part1::misconceptions(),
        "part2" => part2::misconceptions(),
        "part3" => part3::misconceptions(),
        _ => Vec::new(),
    }
}
