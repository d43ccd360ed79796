//! Postures from dice, for motions in which everything changes.

use glam::Vec3;
use skeleton::acclaim::Posture;

use super::paper::until;
use super::variants::quaternion;
use crate::dice::{Dice, two_decimals};

/// The rotations between two postures keep so far away from a middle angle (about Y) of ±90 degrees. There the other two
/// turn about one axis, and angles that are made of a quaternion become inexact: within 0.2 degrees of it, single precision
/// is off by more than is tolerated, and here by a hundredth of that.
const FROM_GIMBAL_LOCK: f32 = 15.0;

/// The angles of a bone.
pub(super) fn angles(dice: &mut Dice) -> [f32; 3] {
    [dice.angle(10.0, 170.0), dice.angle(5.0, 70.0), dice.angle(10.0, 170.0)]
}

/// Other angles, which all differ by enough to be seen, and by less than half a turn. As in a recording, they are within ±180
/// degrees.
pub(super) fn next_angles(dice: &mut Dice, from: [f32; 3]) -> [f32; 3] {
    let within = |angle: f32| two_decimals((angle + 180.0).rem_euclid(360.0) - 180.0);
    let throw = || {
        let [x, z] = [from[0], from[2]].map(|angle| within(angle + dice.angle(25.0, 70.0)));
        [x, dice.angle(5.0, 70.0), z]
    };
    until(throw, |to| (to[1] - from[1]).abs() > 20.0 && is_clear(from, *to))
}

/// Whether there is one shorter way, a visible one, and no gimbal lock on it.
fn is_clear(from: [f32; 3], to: [f32; 3]) -> bool {
    let [from, to] = [from, to].map(quaternion);
    let is_free = |step: u8| {
        let rotation = from.slerp(to, f32::from(step) / 16.0);
        // The sine of the middle angle: where the bone's X axis points to, along Z.
        let sine = (rotation * Vec3::X).z.abs();
        sine < (90.0 - FROM_GIMBAL_LOCK).to_radians().sin()
    };
    (0.25..0.97).contains(&from.dot(to).abs()) && (0..=16).all(is_free)
}

/// A motion of so many frames, in which all bones turn, the first one moves, and every third one is moved a little.
pub(super) fn motion(dice: &mut Dice, frames: usize, bones: usize) -> Vec<Posture> {
    let mut angles: Vec<[f32; 3]> = (0..bones).map(|_| angles(dice)).collect();
    let mut at = dice.vector(5.0, 30.0);
    let frame = |_| {
        let translation = |bone: usize| match bone {
            0 => at,
            _ if bone.is_multiple_of(3) => dice.vector(1.0, 4.0),
            _ => Vec3::ZERO,
        };
        let translations = (0..bones).map(translation).collect();
        let posture = Posture { angles: angles.clone(), translations };
        at += dice.vector(1.0, 6.0);
        angles.iter_mut().for_each(|angles| *angles = next_angles(dice, *angles));
        posture
    };
    (0..frames).map(frame).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_way_is_clear_unless_it_is_long_or_short_or_comes_near_gimbal_lock() {
        assert!(is_clear([30.0, 20.0, -60.0], [-20.0, 50.0, 10.0]));
        // Over ±180 degrees it is no longer.
        assert!(is_clear([170.0, 20.0, -60.0], [-130.0, 50.0, 10.0]));
        assert!(!is_clear([0.0, 0.0, 0.0], [175.0, 0.0, 0.0]));
        assert!(!is_clear([0.0, 10.0, 0.0], [5.0, 12.0, 0.0]));
        // Both ends are away from it, and half-way the middle angle is nearly 80 degrees.
        assert!(!is_clear([-60.0, 70.0, -60.0], [60.0, 70.0, 60.0]));
        assert!(!is_clear([0.0, 80.0, 0.0], [60.0, 40.0, 0.0]));
    }
}
