//! Of the answers to a question about interpolation, what counts.

use exam::interpolation::{Answer as InterpolationAnswer, FrameAnswer, Question as InterpolationQuestion};
use exam::{Answer, Question};
use glam::Quat;
use skeleton::{Joint, RotationOrder, Skeleton};

use super::variants::quaternion;
use crate::compare::{
    NOT_A_NUMBER, ROTATION_TOLERANCE, between_positions, between_rotations, between_rotations_within,
    counted, not_comparable,
};
use crate::{Case, Difference};

/// Two angles are the same when they differ by at most this, in degrees, apart from full turns.
pub const ANGLE_TOLERANCE: f64 = 0.01;

/// The same for rotations that come of two which are all but the same. There the arc cosine of an `f32` is so far off: of
/// 1 − 0.0000002 it is 0.07 degrees of a joint's turn.
pub const CLOSE_TOLERANCE: f64 = 0.2;

/// Of part 1's answers, the directions of the three angles.
pub(super) fn angles(_: &Case, expected: &Answer, got: &Answer) -> Option<Difference> {
    let (
        Answer::Interpolation(InterpolationAnswer::Angles(expected)),
        Answer::Interpolation(InterpolationAnswer::Angles(got)),
    ) = (expected, got)
    else {
        return not_comparable();
    };
    let apart = |axis: usize| apart(expected[axis], got[axis]);
    let largest = (0..3).max_by(|&a, &b| apart(a).total_cmp(&apart(b)))?;
    if apart(largest) <= ANGLE_TOLERANCE {
        return None;
    }
    let which = ["first", "second", "third"][largest];
    let between = if got[largest].is_finite() {
        format!("the {which} angle is {:.2}° off", apart(largest))
    } else {
        format!("the {which} angle: {NOT_A_NUMBER}")
    };
    Some(Difference { got: in_degrees(got), expected: in_degrees(expected), between })
}

/// How far apart two directions are, in degrees, from 0 to 180. What is not a number is infinitely far off.
fn apart(a: f32, b: f32) -> f64 {
    let difference = (f64::from(a) - f64::from(b)).rem_euclid(360.0);
    if difference.is_nan() { f64::INFINITY } else { difference.min(360.0 - difference) }
}

/// Three angles with two decimals.
fn in_degrees(angles: &[f32; 3]) -> String {
    format!("({:.2}°, {:.2}°, {:.2}°)", angles[0], angles[1], angles[2])
}

/// Part 2's answer.
pub(super) fn rotation(_: &Case, expected: &Answer, got: &Answer) -> Option<Difference> {
    rotation_within(ROTATION_TOLERANCE, expected, got)
}

fn rotation_within(tolerance: f64, expected: &Answer, got: &Answer) -> Option<Difference> {
    match (expected, got) {
        (
            Answer::Interpolation(InterpolationAnswer::Slerp(expected)),
            Answer::Interpolation(InterpolationAnswer::Slerp(got)),
        ) => between_rotations_within(tolerance, *expected, *got),
        _ => not_comparable(),
    }
}

/// Part 2's answer, where a wrong one can be any number: two wrong ones are the same when both are numbers, or neither.
pub(super) fn in_kind(case: &Case, expected: &Answer, got: &Answer) -> Option<Difference> {
    if *expected == case.expected {
        return rotation(case, expected, got);
    }
    let kind = |answer: &Answer| (rotation(case, &case.expected, answer).is_none(), is_finite(answer));
    if kind(expected) == kind(got) { None } else { rotation(case, expected, got).or_else(not_comparable) }
}

fn is_finite(answer: &Answer) -> bool {
    matches!(answer, Answer::Interpolation(InterpolationAnswer::Slerp(q)) if q.is_finite())
}

/// Part 2's answer, where rounding decides whether a wrong function gives a wrong one, and how exact a right one is.
pub(super) fn where_rounding_decides(case: &Case, expected: &Answer, got: &Answer) -> Option<Difference> {
    if *expected == case.expected { rotation_within(CLOSE_TOLERANCE, expected, got) } else { None }
}

/// Of part 3's answers, the rotations of all joints. Right is also what comes of the student's own parts 1 and 2 when
/// they are put together as they should be, so that a mistake in them does not cost points again.
pub(super) fn rotations(case: &Case, expected: &Answer, got: &Answer) -> Option<Difference> {
    let (Some(skeleton), Some(right), Some(answer)) = (skeleton(case), frame(expected), frame(got)) else {
        return not_comparable();
    };
    let [right_count, count] = [right, answer].map(|frame| frame.local.rotations.len());
    if right_count != count {
        return other_count("rotation", right_count, count);
    }
    // Whoever asks whether these are a misconception's answers asks for those and no others.
    let own = if *expected == case.expected { own_rotations(skeleton, answer) } else { Vec::new() };
    let pairs = right.local.rotations.iter().zip(&answer.local.rotations);
    skeleton.joints().iter().zip(pairs).find_map(|(joint, (right, got))| {
        let difference = between_rotations(*right, *got)?;
        let own = own.get(joint.id.0).into_iter().flatten();
        let is_own = own.into_iter().any(|own| between_rotations(*own, *got).is_none());
        (!is_own).then(|| of_joint(skeleton, joint, difference))
    })
}

/// Of part 3's answers, the positions of all joints.
pub(super) fn positions(case: &Case, expected: &Answer, got: &Answer) -> Option<Difference> {
    let (Some(skeleton), Some(right), Some(answer)) = (skeleton(case), frame(expected), frame(got)) else {
        return not_comparable();
    };
    let [right_count, count] = [right, answer].map(|frame| frame.local.positions.len());
    if right_count != count {
        return other_count("position", right_count, count);
    }
    let pairs = right.local.positions.iter().zip(&answer.local.positions);
    skeleton.joints().iter().zip(pairs).find_map(|(joint, (right, got))| {
        Some(of_joint(skeleton, joint, between_positions(*right, *got, case.size)?))
    })
}

fn skeleton(case: &Case) -> Option<&Skeleton> {
    match &case.question {
        Question::Interpolation(InterpolationQuestion::Frame { skeleton, .. }) => Some(skeleton),
        _ => None,
    }
}

fn frame(answer: &Answer) -> Option<&FrameAnswer> {
    match answer {
        Answer::Interpolation(InterpolationAnswer::Frame(frame)) => Some(frame),
        _ => None,
    }
}

/// For every joint the rotations that the student's own part 1 or part 2 leads to. Nothing when all joints of a figure
/// would be turned alike: then there was nothing to be put together.
fn own_rotations(skeleton: &Skeleton, answer: &FrameAnswer) -> Vec<Vec<Quat>> {
    let (mut angles, mut rotations) = (answer.angles.iter(), answer.rotations.iter());
    let of = |joint: &Joint| {
        if joint.rotation_order == RotationOrder::None {
            return Vec::new();
        }
        // Only one of the two was asked about.
        let by_angles = angles.next().map(|angles| quaternion(joint, *angles));
        by_angles.into_iter().chain(rotations.next().into_iter().flatten().copied()).collect()
    };
    let own: Vec<Vec<Quat>> = skeleton.joints().iter().map(of).collect();
    let turned: Vec<Quat> = own.iter().filter_map(|rotations| rotations.first().copied()).collect();
    let are_alike = turned.iter().all(|other| between_rotations(turned[0], *other).is_none());
    if turned.len() > 1 && are_alike { Vec::new() } else { own }
}

/// `what` is the word for one of them.
fn other_count(what: &str, expected: usize, got: usize) -> Option<Difference> {
    let more_or_fewer = if got > expected { "too many" } else { "missing" };
    Some(Difference {
        got: counted(got, what),
        expected: format!("{}, one for every joint and End Site", counted(expected, what)),
        between: format!("{} {more_or_fewer}", counted(expected.abs_diff(got), what)),
    })
}

fn of_joint(skeleton: &Skeleton, joint: &Joint, difference: Difference) -> Difference {
    let name = skeleton.label(joint.id);
    let order = joint.rotation_order;
    let named = |text: String| format!("{name} ({order}): {text}");
    Difference { got: named(difference.got), expected: named(difference.expected), ..difference }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn full_turns_make_no_difference() {
        for turns in [-3.0, -1.0, 0.0, 1.0, 4.0] {
            for (a, b) in [(180.0, -180.0), (170.25, 170.25), (0.0, 360.0), (-0.004, 0.004)] {
                assert!(apart(a, b + 360.0 * turns) <= ANGLE_TOLERANCE, "{a} {b} {turns}");
            }
        }
    }

    #[test]
    fn angles_differ_from_a_hundredth_of_a_degree_on() {
        for angle in [-720.0, -180.0, 0.0, 90.0, 359.99] {
            assert!(apart(angle, angle + 0.009) <= ANGLE_TOLERANCE, "{angle}");
            assert!(apart(angle, angle - 0.011) > ANGLE_TOLERANCE, "{angle}");
        }
    }

    #[test]
    fn what_is_not_a_number_is_no_angle() {
        for angle in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
            assert!(apart(10.0, angle).is_infinite());
        }
    }
}
