//! When two answers are the same, and how they differ when they are not.

mod place;
mod postures;

pub use place::PLACE_TOLERANCE;
pub use postures::TRANSLATION_TOLERANCE;

use exam::time_warp::{Answer as TimeWarpAnswer, Question as TimeWarpQuestion};
use exam::{Answer, Question};
use skeleton::acclaim::Posture;

use crate::compare::not_comparable;
use crate::{Case, Difference};
pub(super) use postures::{Off, first_off, in_degrees};

/// Part 1's answer.
pub(super) fn places(case: &Case, expected: &Answer, got: &Answer) -> Option<Difference> {
    let Question::TimeWarp(TimeWarpQuestion::Position { old_count, .. }) = case.question else {
        return not_comparable();
    };
    match (time_warp(expected), time_warp(got)) {
        (Some(TimeWarpAnswer::Position(expected)), Some(TimeWarpAnswer::Position(got))) => {
            place::difference(*expected, *got, old_count)
        }
        _ => not_comparable(),
    }
}

/// Of part 2's answer, the rotations.
pub(super) fn rotations(_: &Case, expected: &Answer, got: &Answer) -> Option<Difference> {
    match (time_warp(expected), time_warp(got)) {
        (Some(TimeWarpAnswer::Blend(expected)), Some(TimeWarpAnswer::Blend(got))) => {
            postures::rotations_off(expected, got).map(|off| off.difference)
        }
        _ => not_comparable(),
    }
}

/// Of part 2's answer, the translations.
pub(super) fn translations(_: &Case, expected: &Answer, got: &Answer) -> Option<Difference> {
    match (time_warp(expected), time_warp(got)) {
        (Some(TimeWarpAnswer::Blend(expected)), Some(TimeWarpAnswer::Blend(got))) => {
            postures::translations_off(expected, got).map(|off| off.difference)
        }
        _ => not_comparable(),
    }
}

/// Part 3's answer. Right is also what comes of the student's own parts 1 and 2 when they are put together as they should
/// be, so that a mistake in them does not cost points again: not even one that gives what is not a number.
pub(super) fn motions(case: &Case, expected: &Answer, got: &Answer) -> Option<Difference> {
    // Whoever asks whether these are a misconception's answers asks for those and no others.
    let is_right = *expected == case.expected;
    let (right, postures, own) = match (time_warp(expected), time_warp(got)) {
        (
            Some(TimeWarpAnswer::Warp { postures: right, .. }),
            Some(TimeWarpAnswer::Warp { postures, by_parts }),
        ) => (right, postures, by_parts.as_ref().filter(|_| is_right)),
        (_, Some(TimeWarpAnswer::Fewer { postures, by_parts })) if is_right => {
            return fewer_frames(by_parts, postures);
        }
        _ => return not_comparable(),
    };
    if right.len() != postures.len() {
        return postures::other_count(right.len(), postures.len());
    }
    let mut frames = right.iter().zip(postures).enumerate();
    frames.find_map(|(frame, (right, got))| {
        let off = first_off(right, got)?;
        let is_own = own.and_then(|own| own.get(frame)).is_some_and(|own| postures::is_own(own, got));
        (!is_own).then(|| in_frame(frame, off))
    })
}

/// What part 3 makes of fewer frames than were asked for, because with so many its part 1 leaves the motion. It can only be
/// compared with what the student's own parts make.
fn fewer_frames(own: &[Posture], got: &[Posture]) -> Option<Difference> {
    let difference = if own.len() == got.len() {
        let mut frames = own.iter().zip(got).enumerate();
        frames.find_map(|(frame, (own, got))| {
            if postures::is_own(own, got) { None } else { Some(in_frame(frame, first_off(own, got)?)) }
        })
    } else {
        postures::other_count(own.len(), got.len())
    };
    let Difference { got, expected, between } = difference?;
    let of_fewer = |text: String| format!("of {} frames: {text}", own.len());
    let why = "your part 1 names a frame that is not there, so that fewer were asked for";
    Some(Difference {
        got: of_fewer(got),
        expected: of_fewer(expected),
        between: format!("{between}; {why}"),
    })
}

fn in_frame(frame: usize, off: Off) -> Difference {
    let named = |text: String| format!("frame {frame}, {text}");
    let Difference { got, expected, between } = off.difference;
    Difference { got: named(got), expected: named(expected), between }
}

fn time_warp(answer: &Answer) -> Option<&TimeWarpAnswer> {
    match answer {
        Answer::TimeWarp(answer) => Some(answer),
        _ => None,
    }
}
