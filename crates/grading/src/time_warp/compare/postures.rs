//! Whether two postures are the same.

use glam::Vec3;
use skeleton::acclaim::Posture;

use crate::Difference;
use crate::compare::{between_positions, between_rotations, counted};
use crate::time_warp::variants::quaternion;

/// Two translations are the same when their distance is at most this, in the file's unit.
pub const TRANSLATION_TOLERANCE: f32 = 1e-3;

/// Where one posture differs from another.
pub(in crate::time_warp) struct Off {
    /// The bone, by its number; nothing where there are not as many bones.
    pub bone: Option<usize>,
    /// How the two differ.
    pub difference: Difference,
}

/// The first bone that is off, in its rotation or else in its translation.
pub(in crate::time_warp) fn first_off(expected: &Posture, got: &Posture) -> Option<Off> {
    let all = rotations_off(expected, got).into_iter().chain(translations_off(expected, got));
    all.min_by_key(|off| off.bone)
}

/// Whether a posture is the one that somebody's own functions give. Where both are not numbers, they are the same: whoever
/// divided by zero has lost the points for it elsewhere.
pub(super) fn is_own(own: &Posture, got: &Posture) -> bool {
    let (mut own, mut got) = (own.clone(), got.clone());
    for (own, got) in own.angles.iter_mut().zip(&mut got.angles) {
        if [&*own, &*got].iter().all(|angles| angles.iter().any(|angle| !angle.is_finite())) {
            (*own, *got) = ([0.0; 3], [0.0; 3]);
        }
    }
    for (own, got) in own.translations.iter_mut().zip(&mut got.translations) {
        if !own.is_finite() && !got.is_finite() {
            (*own, *got) = (Vec3::ZERO, Vec3::ZERO);
        }
    }
    first_off(&own, &got).is_none()
}

/// The first bone whose angles stand for another rotation.
pub(super) fn rotations_off(expected: &Posture, got: &Posture) -> Option<Off> {
    first("angles", &expected.angles, &got.angles, |expected, got| {
        let [right, rotation] = [expected, got].map(|angles| quaternion(*angles));
        let Difference { between, .. } = between_rotations(right, rotation)?;
        Some(Difference { got: in_degrees(got), expected: in_degrees(expected), between })
    })
}

/// The first bone whose translation is another one.
pub(super) fn translations_off(expected: &Posture, got: &Posture) -> Option<Off> {
    /// `between_positions` has a tolerance of 1/10,000 of this.
    const SIZE: f32 = TRANSLATION_TOLERANCE * 1e4;
    first("translations", &expected.translations, &got.translations, |expected: &Vec3, got| {
        between_positions(*expected, *got, SIZE)
    })
}

/// Compares two lists, bone by bone.
fn first<T>(
    list: &str,
    expected: &[T],
    got: &[T],
    difference: impl Fn(&T, &T) -> Option<Difference>,
) -> Option<Off> {
    if expected.len() != got.len() {
        let difference = Difference {
            got: format!("{} {list}", got.len()),
            expected: format!("{} {list}, one for every bone", expected.len()),
            between: format!("{} {list}", expected.len().abs_diff(got.len())),
        };
        return Some(Off { bone: None, difference });
    }
    let mut pairs = expected.iter().zip(got).enumerate();
    pairs.find_map(|(bone, (expected, got))| {
        let Difference { got, expected, between } = difference(expected, got)?;
        let named = |text: String| format!("{list}[{bone}] {text}");
        let difference = Difference { got: named(got), expected: named(expected), between };
        Some(Off { bone: Some(bone), difference })
    })
}

/// The motions do not have as many frames.
pub(super) fn other_count(expected: usize, got: usize) -> Option<Difference> {
    let frames = |count| counted(count, "frame");
    let apart = if got > expected { "too many" } else { "missing" };
    Some(Difference {
        got: frames(got),
        expected: frames(expected),
        between: format!("{} {apart}", frames(expected.abs_diff(got))),
    })
}

/// Three angles with two decimals.
pub(in crate::time_warp) fn in_degrees(angles: &[f32; 3]) -> String {
    // A zero without a sign.
    let [x, y, z] = angles.map(|angle| (angle * 100.0).round() / 100.0 + 0.0);
    format!("({x:.2}°, {y:.2}°, {z:.2}°)")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn posture(angles: &[[f32; 3]], translations: &[[f32; 3]]) -> Posture {
        let translations = translations.iter().map(|translation| Vec3::from(*translation)).collect();
        Posture { angles: angles.to_vec(), translations }
    }

    fn said(expected: &Posture, got: &Posture) -> Option<(Option<usize>, String)> {
        first_off(expected, got).map(|off| (off.bone, off.difference.between))
    }

    #[test]
    fn the_same_rotation_may_have_other_angles() {
        let same = [[10.0, 20.0, 30.0], [190.0, 160.0, 210.0], [370.0, 20.0, -330.0]];
        for a in same {
            for b in same {
                assert_eq!(said(&posture(&[a], &[]), &posture(&[b], &[])), None, "{a:?} {b:?}");
            }
        }
    }

    #[test]
    fn the_first_bone_that_is_off_is_told_with_what_is_off() {
        let right = posture(&[[10.0, 20.0, 30.0]; 3], &[[1.0, 2.0, 3.0]; 3]);
        let mut got = right.clone();
        assert_eq!(said(&right, &got), None);
        got.angles[2][0] += 5.0;
        assert_eq!(said(&right, &got).unwrap(), (Some(2), "5.00°".to_owned()));
        got.translations[1].y += 0.25;
        assert_eq!(said(&right, &got).unwrap(), (Some(1), "0.250 (file's unit)".to_owned()));
        got.angles[1][2] -= 0.5;
        let (bone, between) = said(&right, &got).unwrap();
        assert!(bone == Some(1) && between.ends_with('°'), "{between}");
        got.translations.pop();
        assert_eq!(said(&right, &got).unwrap(), (None, "1 translations".to_owned()));
    }

    #[test]
    fn what_is_not_a_number_can_be_ones_own() {
        let number = posture(&[[10.0, 20.0, 30.0]; 2], &[[1.0, 2.0, 3.0]; 2]);
        let mut odd = number.clone();
        odd.angles[1][0] = f32::NAN;
        odd.translations[0] = Vec3::INFINITY;
        assert!(is_own(&odd, &odd) && is_own(&number, &number));
        assert!(!is_own(&number, &odd) && !is_own(&odd, &number));
        let mut other = odd.clone();
        other.angles[0][0] += 1.0;
        assert!(!is_own(&odd, &other));
        other.angles.pop();
        assert!(!is_own(&odd, &other));
    }

    #[test]
    fn what_is_not_a_number_is_never_right() {
        let right = posture(&[[0.0; 3]], &[[0.0; 3]]);
        for odd in [f32::NAN, f32::INFINITY] {
            for got in [posture(&[[0.0, odd, 0.0]], &[[0.0; 3]]), posture(&[[0.0; 3]], &[[odd, 0.0, 0.0]])] {
                assert!(said(&right, &got).unwrap().1.contains("not a number"));
            }
        }
    }
}
