//! The misconceptions of time warping: what is said about each, what it costs, and how it is recognised.

mod part1;
mod part2;
mod part3;

use super::variants::{blend::ShortPi, functions};
use crate::fk::misconceptions::short_pis;
use crate::{Accepted, Misconception};

/// A list of functions, one for each way.
macro_rules! ways {
    ($($way:ty),* $(,)?) => { vec![$(crate::time_warp::variants::functions::<$way>()),*] };
}
use ways;

/// Ways to answer a part that get full points, with a remark.
pub fn accepted(part: &str) -> Vec<Accepted> {
    const REMARK: &str = "Your π has only a few digits. This is accepted, but angles that go through it come back a little \
                          wrong. `f32::to_radians` and `to_degrees` are as exact as the type allows.";
    match part {
        "part2" => [
            short_pis!(REMARK, P => functions::<ShortPi<P, true, true>>()),
            short_pis!(REMARK, P => functions::<ShortPi<P, true, false>>()),
            short_pis!(REMARK, P => functions::<ShortPi<P, false, true>>()),
        ]
        .into_iter()
        .flatten()
        .collect(),
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
