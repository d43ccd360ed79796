//! Part 1: angles that are near, on both sides of ±180 degrees, or full turns apart.

use exam::interpolation::Question as InterpolationQuestion;

use super::{BETWEEN, ENDS, Writer, input, sign};
use crate::Case;
use crate::dice::{Dice, two_decimals};
use crate::interpolation::compare;

/// Less than half a turn, away from ±180 degrees. The first angle passes 0, up and down in turns.
pub(super) fn near(writer: &Writer, dice: &mut Dice) -> Vec<Case> {
    let case = |(number, t)| {
        let sign = sign(number);
        let first = (sign * dice.between(10.0, 40.0), -sign * dice.between(40.0, 90.0));
        let mut other = || (dice.angle(5.0, 80.0), dice.angle(20.0, 90.0));
        ask(writer, [first, other(), other()], t)
    };
    BETWEEN.into_iter().enumerate().map(case).collect()
}

/// The shorter way leads over ±180 degrees, for all three angles, up and down in turns.
pub(super) fn across(writer: &Writer, dice: &mut Dice) -> Vec<Case> {
    let case = |(number, t)| {
        let legs = std::array::from_fn(|axis| {
            let sign = sign(number + axis);
            let (from, to) = (dice.between(100.0, 170.0), dice.between(100.0, 170.0));
            (sign * from, -sign * (from + to))
        });
        ask(writer, legs, t)
    };
    BETWEEN.into_iter().enumerate().map(case).collect()
}

/// One to three full turns beside the shorter way, which leads over 0, over ±180 degrees, and over neither.
pub(super) fn turns(writer: &Writer, dice: &mut Dice) -> Vec<Case> {
    let case = |(number, t)| {
        let sign = sign(number);
        let turns = 360.0 * (1 + number % 3) as f32;
        let mut some_turns = || if dice.below(2) == 0 { turns } else { -turns };
        let [second, third] = [some_turns(), some_turns()];
        // The turns of the first angle lead away from the shorter way: what is left without them is the longer one.
        let first = (sign * dice.between(10.0, 60.0), sign * turns - sign * dice.between(80.0, 140.0));
        let second = (sign * dice.between(130.0, 170.0), second + sign * dice.between(60.0, 120.0));
        let third = (sign * dice.between(20.0, 60.0), third + sign * dice.between(20.0, 80.0));
        // In the later half, the first frame has turned already.
        let before = if number < 3 { 0.0 } else { sign * 360.0 };
        ask(writer, [first, second, third].map(|(from, way)| (from + before, way)), t)
    };
    BETWEEN.into_iter().enumerate().map(case).collect()
}

/// So near that four times the way is no full turn.
pub(super) fn ends(writer: &Writer, dice: &mut Dice) -> Vec<Case> {
    let mut leg = |_| (dice.angle(5.0, 80.0), dice.angle(20.0, 80.0));
    ENDS.into_iter().map(|t| ask(writer, std::array::from_fn(&mut leg), t)).collect()
}

/// From each first number on by the second one.
fn ask(writer: &Writer, legs: [(f32, f32); 3], t: f32) -> Case {
    let from = legs.map(|(from, _)| two_decimals(from));
    let to = legs.map(|(from, way)| two_decimals(from + way));
    let listed = |[a, b, c]: [f32; 3]| format!("({a}°, {b}°, {c}°)");
    let inputs = vec![input("from", listed(from)), input("to", listed(to)), input("t", t.to_string())];
    writer.case(InterpolationQuestion::Angles { from, to, t }, inputs, compare::angles)
}
