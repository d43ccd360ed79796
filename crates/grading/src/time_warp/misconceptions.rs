//! The misconceptions of time warping: what is said about each, what it costs, and how it is recognised.

mod part1;
mod part2;
mod part3;

use crate::Misconception;

/// The misconceptions of one part.
pub fn misconceptions(part: &str) -> Vec<Misconception> {
    match part {
        "part1" => part1::misconceptions(),
        "part2" => part2::misconceptions(),
        "part3" => part3::misconceptions(),
        _ => Vec::new(),
    }
}

/// A list of functions, one for each way.
macro_rules! ways {
    ($($way:ty),* $(,)?) => { vec![$(crate::time_warp::variants::functions::<$way>()),*] };
}
use ways;
