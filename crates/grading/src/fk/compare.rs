//! Of the answers to a question of forward kinematics, what counts.

use exam::Answer;
use exam::fk::Answer as FkAnswer;
use skeleton::RotationOrder;

use crate::compare::{between_positions, between_rotations, not_comparable};
use crate::{Case, Difference};

/// Of part 1's answers, the rotations.
pub(super) fn rotation_of_joint(_: &Case, expected: &Answer, got: &Answer) -> Option<Difference> {
    let (Answer::Fk(FkAnswer::LocalQuaternions(expected)), Answer::Fk(FkAnswer::LocalQuaternions(got))) =
        (expected, got)
    else {
        return not_comparable();
    };
    expected.iter().zip(got).find_map(|(expected, got)| between_rotations(expected.rotation, got.rotation))
}

/// Of part 1's answers, how many angles were taken, and that a joint without angles is not turned.
pub(super) fn cursor(case: &Case, expected: &Answer, got: &Answer) -> Option<Difference> {
    let (Answer::Fk(FkAnswer::LocalQuaternions(expected)), Answer::Fk(FkAnswer::LocalQuaternions(got))) =
        (expected, got)
    else {
        return not_comparable();
    };
    let exam::Question::Fk(exam::fk::Question::LocalQuaternions { joints, .. }) = &case.question else {
        return not_comparable();
    };
    joints.iter().zip(expected).zip(got).find_map(|((joint, expected), got)| {
        let (name, order) = (&joint.name, joint.rotation_order);
        if expected.taken != got.taken {
            return Some(Difference {
                got: format!("{name} ({order}) took {} angles", got.taken),
                expected: format!("{name} ({order}) takes {}", expected.taken),
                between: format!("{} angles", expected.taken.abs_diff(got.taken)),
            });
        }
        let turned = order == RotationOrder::None;
        turned.then(|| between_rotations(expected.rotation, got.rotation)).flatten().map(|difference| {
            Difference { got: format!("{name} ({order}) is turned by {}", difference.got), ..difference }
        })
    })
}

/// Of part 2's answers, the rotation.
pub(super) fn global_rotation(_: &Case, expected: &Answer, got: &Answer) -> Option<Difference> {
    match (expected, got) {
        (Answer::Fk(FkAnswer::GlobalQuaternion(expected)), Answer::Fk(FkAnswer::GlobalQuaternion(got))) => {
            between_rotations(*expected, *got)
        }
        _ => not_comparable(),
    }
}

/// Of part 3's answers, the position.
pub(super) fn global_position(case: &Case, expected: &Answer, got: &Answer) -> Option<Difference> {
    match (expected, got) {
        (Answer::Fk(FkAnswer::GlobalPosition(expected)), Answer::Fk(FkAnswer::GlobalPosition(got))) => {
            between_positions(*expected, *got, case.size)
        }
        _ => not_comparable(),
    }
}
