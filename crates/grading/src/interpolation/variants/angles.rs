//! Part 1.

use std::f32::consts::{PI, TAU};

use super::Way;

/// Goes evenly from `start` by `way` degrees, both of which `legs` gives for one angle at both ends.
fn each(from: [f32; 3], to: [f32; 3], t: f32, legs: impl Fn(f32, f32) -> (f32, f32)) -> [f32; 3] {
    std::array::from_fn(|axis| {
        let (start, way) = legs(from[axis], to[axis]);
        start + t * way
    })
}

/// Where each begins, and how far it goes.
macro_rules! ways {
    ($($(#[$doc:meta])* $name:ident($from:ident, $to:ident) = $legs:expr;)*) => {
        $(
            $(#[$doc])*
            pub struct $name;

            impl Way for $name {
                fn angles(from: [f32; 3], to: [f32; 3], t: f32) -> [f32; 3] {
                    each(from, to, t.clamp(0.0, 1.0), |$from, $to| $legs)
                }
            }
        )*
    };
}

ways! {
    /// Takes the difference as it is.
    Straight(from, to) = (from, to - from);
    /// Takes one full turn off, or adds one, and leaves further ones.
    CorrectedOnce(from, to) = (from, within(to - from, 360.0));
    /// Corrects a difference above 180 degrees only.
    OnlyDown(from, to) = (from, down(to - from));
    /// The same for any number of turns.
    OnlyDownRemainder(from, to) = (from, down((to - from) % 360.0));
    /// Corrects a difference below −180 degrees only.
    OnlyUp(from, to) = (from, up(to - from));
    /// The same for any number of turns.
    OnlyUpRemainder(from, to) = (from, up((to - from) % 360.0));
    /// Takes full turns off the difference.
    DifferenceWrapped(from, to) = (from, (to - from) % 360.0);
    /// Takes full turns off both angles.
    BothWrapped(from, to) = (from % 360.0, to % 360.0 - from % 360.0);
    /// Brings both angles to between −180 and 180 degrees.
    BothWithinHalfTurns(from, to) = (half_turn(from), half_turn(to) - half_turn(from));
    /// Brings both angles to between 0 and 360 degrees.
    BothPositive(from, to) = (from.rem_euclid(360.0), to.rem_euclid(360.0) - from.rem_euclid(360.0));
    /// Always goes up.
    AlwaysUp(from, to) = (from, (to - from).rem_euclid(360.0));
    /// Compares degrees with π.
    ComparedWithPi(from, to) = (from, within(to - from, TAU));
    /// The same for any number of turns.
    ComparedWithPiRemainder(from, to) = (from, within((to - from) % TAU, TAU));
}

/// Takes one `turn` off a difference of more than half of it, or adds one.
fn within(difference: f32, turn: f32) -> f32 {
    if difference > turn / 2.0 {
        difference - turn
    } else if difference < -turn / 2.0 {
        difference + turn
    } else {
        difference
    }
}

fn down(difference: f32) -> f32 {
    if difference > 180.0 { difference - 360.0 } else { difference }
}

fn up(difference: f32) -> f32 {
    if difference < -180.0 { difference + 360.0 } else { difference }
}

/// The same direction, within ±180 degrees.
pub fn half_turn(angle: f32) -> f32 {
    within(angle % 360.0, 360.0)
}

/// Works in radians, and does not return to degrees.
pub struct InRadians;

impl Way for InRadians {
    fn angles(from: [f32; 3], to: [f32; 3], t: f32) -> [f32; 3] {
        let [from, to] = [from, to].map(|angles| angles.map(f32::to_radians));
        each(from, to, t.clamp(0.0, 1.0), |from, to| (from, within((to - from) % TAU, 2.0 * PI)))
    }
}

/// Goes on before the first and beyond the second.
pub struct GoesOn;

impl Way for GoesOn {
    fn angles(from: [f32; 3], to: [f32; 3], t: f32) -> [f32; 3] {
        each(from, to, t, |from, to| (from, half_turn(to - from)))
    }
}

/// Counts from the second to the first.
pub struct Backwards;

impl Way for Backwards {
    fn angles(from: [f32; 3], to: [f32; 3], t: f32) -> [f32; 3] {
        solutions::interpolation::interpolate_angles(to, from, t)
    }
}
