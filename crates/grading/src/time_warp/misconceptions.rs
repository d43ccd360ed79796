//! The misconceptions of time warping: what is said about each, what it costs, and how it is recognised.

mod part1;
mod part2;
mod part3;

use super::variants::blend::ShortPi;
use crate::fk::variants::{FourDecimals, Fraction, ThreeDecimals, ThreeRounded, TwoDecimals};
use crate::{Accepted, Misconception};

/// A list of functions, one for each way.
macro_rules! ways {
    ($($way:ty),* $(,)?) => { vec![$(crate::time_warp::variants::functions::<$way>()),*] };
}
use ways;

/// Ways to answer a part that get full points, with a remark.
pub fn accepted(part: &str) -> Vec<Accepted> {
    let remark = "Your π has only a few digits. This is accepted, but angles that go through it come back a little wrong. \
                  `f32::to_radians` and `to_degrees` are as exact as the type allows.";
    /// One for each such π, on these ways.
    macro_rules! short_pis {
        ($into:literal, $out:literal) => {
            ways![
                ShortPi<TwoDecimals, $into, $out>,
                ShortPi<ThreeDecimals, $into, $out>,
                ShortPi<ThreeRounded, $into, $out>,
                ShortPi<FourDecimals, $into, $out>,
                ShortPi<Fraction, $into, $out>,
            ]
        };
    }
    match part {
        "part2" => {
            let all = [short_pis!(true, true), short_pis!(true, false), short_pis!(false, true)];
            all.into_iter().flatten().map(|functions| Accepted { remark, functions }).collect()
        }
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
