//! The misconceptions of interpolation: what is said about each, what it costs, and how it is recognised.

mod part1;
mod part2;
mod part3;

use super::variants::{frame::ShortPi, functions};
use crate::fk::variants::{FourDecimals, Fraction, ThreeDecimals, ThreeRounded, TwoDecimals};
use crate::{Accepted, Misconception};

/// Ways to answer a part that get full points, with a remark.
pub fn accepted(part: &str) -> Vec<Accepted> {
    let remark = "The π in your rotations has only a few digits. This is accepted, but over several joints the error \
                  becomes visible. `f32::to_radians` is as exact as the type allows.";
    let short_pis = [
        functions::<ShortPi<TwoDecimals>>(),
        functions::<ShortPi<ThreeDecimals>>(),
        functions::<ShortPi<ThreeRounded>>(),
        functions::<ShortPi<FourDecimals>>(),
        functions::<ShortPi<Fraction>>(),
    ];
    match part {
        "part3" => short_pis.map(|functions| Accepted { remark, functions }).into(),
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
