//! Part 2: rotations that are far apart, nearly the same, or written with quaternions that point apart.

use exam::interpolation::Question as InterpolationQuestion;
use glam::Quat;

use super::{BETWEEN, Compare, ENDS, Writer, input, sign};
use crate::Case;
use crate::compare::{angle_between, quaternion};
use crate::dice::Dice;
use crate::interpolation::compare;

/// By how many degrees the joint turns from one to the other. From 25 degrees on, a straight line is more uneven than is
/// tolerated, at each `t` of these but half-way; the last stay away from half a turn, where both ways are equally long.
const APART: [(f32, f32); 6] =
    [(40.0, 80.0), (80.0, 130.0), (25.0, 35.0), (130.0, 165.0), (60.0, 120.0), (90.0, 165.0)];

/// A quarter turn about Z.
const QUARTER: [f32; 4] = [0.0, 0.0, std::f32::consts::FRAC_1_SQRT_2, std::f32::consts::FRAC_1_SQRT_2];

/// From no rotation to a quarter turn, and then from any rotation to any other.
pub(super) fn near(writer: &Writer, dice: &mut Dice) -> Vec<Case> {
    let easy = ask(writer, Quat::IDENTITY, Quat::from_array(QUARTER), 0.25);
    let pairs = BETWEEN.into_iter().zip(APART).map(|(t, (low, high))| {
        let (from, to) = pair(dice, low, high);
        ask(writer, from, to, t)
    });
    [easy].into_iter().chain(pairs).collect()
}

/// The same with one of the two negated.
pub(super) fn shorter_way(writer: &Writer, dice: &mut Dice) -> Vec<Case> {
    let [x, y, z, w] = QUARTER;
    let easy = ask(writer, Quat::IDENTITY, Quat::from_xyzw(x, y, -z, -w), 0.25);
    let pairs = BETWEEN.into_iter().zip(APART).enumerate().map(|(number, (t, (low, high)))| {
        let (from, to) = pair(dice, low, high);
        let sign = sign(number);
        ask(writer, from * -sign, to * sign, t)
    });
    [easy].into_iter().chain(pairs).collect()
}

/// Twice the same, *q* and −*q*, and so little apart that the formula divides by nearly nothing.
pub(super) fn close(writer: &Writer, dice: &mut Dice) -> Vec<Case> {
    let mut cases = vec![ask_close(writer, Quat::IDENTITY, Quat::IDENTITY, 0.5)];
    for (rounds_up, sign) in [(false, 1.0), (true, 1.0), (false, -1.0), (true, -1.0)] {
        let q = with_square(dice, rounds_up);
        cases.push(ask_close(writer, q, q * sign, 0.3));
    }
    for (low, high, sign, t) in
        [(0.8, 1.0, 1.0, 0.25), (0.3, 0.5, 1.0, 0.7), (0.8, 1.0, -1.0, 0.3), (0.3, 0.5, -1.0, 0.75)]
    {
        let (from, to) = pair(dice, low, high);
        cases.push(ask_close(writer, from, to * sign, t));
    }
    // So close that their dot product can round to 1, the first itself is near enough.
    for (degrees, sign, t) in
        [(0.02, 1.0, 0.4), (0.02, -1.0, 0.3), (0.01, 1.0, 0.7), (0.001, -1.0, 0.9), (0.0, 1.0, 0.6)]
    {
        let from = dice.rotation();
        let to = from * about_any_axis(dice, degrees);
        cases.push(ask_as(compare::where_rounding_decides, writer, from, to * sign, t));
    }
    cases
}

/// So near that four times the way is no full turn.
pub(super) fn ends(writer: &Writer, dice: &mut Dice) -> Vec<Case> {
    let case = |t| {
        let (from, to) = pair(dice, 40.0, 80.0);
        ask(writer, from, to, t)
    };
    ENDS.into_iter().map(case).collect()
}

/// Two rotations with so many degrees from one to the other, whose quaternions point the same way.
fn pair(dice: &mut Dice, low: f32, high: f32) -> (Quat, Quat) {
    let (from, degrees) = (dice.rotation(), dice.angle(low, high));
    (from, (from * about_any_axis(dice, degrees)).normalize())
}

fn about_any_axis(dice: &mut Dice, degrees: f32) -> Quat {
    Quat::from_axis_angle(dice.vector(0.4, 1.0).normalize(), degrees.to_radians())
}

/// A unit quaternion whose dot product with itself is exactly 1, or comes out a little larger because computers round. It
/// has only two numbers that are not 0, so that this holds in whichever order they are added up.
fn with_square(dice: &mut Dice, rounds_up: bool) -> Quat {
    let turn = |_| {
        let sine = dice.between(0.1, 0.95);
        Quat::from_xyzw(sine, 0.0, 0.0, (1.0 - sine * sine).sqrt())
    };
    let fits = |q: &Quat| {
        let square = q.x * q.x + q.w * q.w;
        if rounds_up { square > 1.0 } else { square == 1.0 }
    };
    // Every 16th rounds up, and three of four are exact.
    (0..10_000).map(turn).find(fits).unwrap_or(Quat::IDENTITY)
}

fn ask(writer: &Writer, from: Quat, to: Quat, t: f32) -> Case {
    ask_as(compare::rotation, writer, from, to, t)
}

fn ask_close(writer: &Writer, from: Quat, to: Quat, t: f32) -> Case {
    ask_as(compare::in_kind, writer, from, to, t)
}

fn ask_as(difference: Compare, writer: &Writer, from: Quat, to: Quat, t: f32) -> Case {
    let inputs = vec![
        input("from (x, y, z, w)", quaternion(from)),
        input("to (x, y, z, w)", quaternion(to)),
        input("between them", format!("{:.3}°, dot product {:.6}", angle_between(from, to), from.dot(to))),
        input("t", t.to_string()),
    ];
    writer.case(InterpolationQuestion::Slerp { from, to, t }, inputs, difference)
}
