//! The misconceptions about keyframes: what is said about each, what it costs, and how it is recognised.

mod part1;
mod part2;
mod part3;

use exam::Functions;
use skeleton::{FrameErrors, KeyframesFunctions, Pose, RemovalCosts, Skeleton};

use crate::Misconception;

pub(super) use part3::BELOW_ZERO;

/// The misconceptions of one part.
pub fn misconceptions(part: &str) -> Vec<Misconception> {
    match part {
        "part1" => part1::misconceptions(),
        "part2" => part2::misconceptions(),
        "part3" => part3::misconceptions(),
        _ => Vec::new(),
    }
}

type PoseError = fn(&Skeleton, &Pose, &Pose) -> f64;
type Cost = fn(usize, usize, usize, &FrameErrors) -> f64;
type Reduce = fn(usize, usize, &RemovalCosts) -> Vec<usize>;

/// The right functions but for one.
fn wrong_in_part1(pose_error: PoseError) -> Functions {
    Functions::keyframes(KeyframesFunctions { pose_error, ..solutions::KEYFRAMES })
}

fn wrong_in_part2(removal_cost: Cost) -> Functions {
    Functions::keyframes(KeyframesFunctions { removal_cost, ..solutions::KEYFRAMES })
}

fn wrong_in_part3(reduce: Reduce) -> Functions {
    Functions::keyframes(KeyframesFunctions { reduce, ..solutions::KEYFRAMES })
}
