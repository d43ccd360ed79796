//! When two answers are the same, and how they differ when they are not.

use std::fmt::Display;

use exam::keyframes::{Answer as KeyframesAnswer, Question as KeyframesQuestion};
use exam::{Answer, Question};

use crate::compare::{counted, not_comparable};
use crate::{Case, Difference};

/// An error or a cost is right when it is off by at most this, times the right one. Where 0 is right, only 0 is.
pub const ERROR_TOLERANCE: f64 = 1e-4;

/// So many columns of a list of keyframes are shown.
const LIST_WIDTH: usize = 56;

/// Compares answers to any question of the three parts.
pub(super) fn difference(case: &Case, expected: &Answer, got: &Answer) -> Option<Difference> {
    use KeyframesAnswer::{PoseError, Reduce, RemovalCost};
    let (Answer::Keyframes(expected), Answer::Keyframes(got)) = (expected, got) else {
        return not_comparable();
    };
    match (expected, got) {
        (PoseError(expected), PoseError(got)) | (RemovalCost(expected), RemovalCost(got)) => {
            between_numbers(*expected, *got)
        }
        (Reduce(expected), Reduce(got)) => between_keyframes(expected, got, frame_count(&case.question)),
        _ => not_comparable(),
    }
}

fn frame_count(question: &Question) -> usize {
    match question {
        Question::Keyframes(KeyframesQuestion::Reduce { frame_count, .. }) => *frame_count,
        Question::Keyframes(KeyframesQuestion::Chain { originals, .. }) => originals.len(),
        _ => 0,
    }
}

/// Whether two errors or costs are the same, and if not, how they differ.
pub(super) fn between_numbers(expected: f64, got: f64) -> Option<Difference> {
    let between = if !got.is_finite() {
        "yours is not a number (NaN) or infinite: look for a division by zero".to_owned()
    } else {
        let apart = (got - expected).abs();
        if apart <= ERROR_TOLERANCE * expected.abs() {
            return None;
        }
        let times = got / expected;
        if times != 0.0 && (0.001..1000.0).contains(&times.abs()) {
            format!("{} (yours is {times:.3} times the right one)", number(apart))
        } else {
            number(apart)
        }
    };
    Some(Difference { got: number(got), expected: number(expected), between })
}

/// Whether two lists of keyframes are the same, and if not, where they first differ. `frame_count` is that of the motion.
pub(super) fn between_keyframes(expected: &[usize], got: &[usize], frame_count: usize) -> Option<Difference> {
    if expected == got {
        return None;
    }
    let first = expected.iter().zip(got).take_while(|(expected, got)| expected == got).count();
    let unsorted = got.windows(2).find(|pair| pair[0] >= pair[1]);
    let between = if let Some(frame) = got.iter().find(|frame| **frame >= frame_count) {
        match frame_count.checked_sub(1) {
            Some(last) => format!("there is no frame {frame}: the last one is {last}"),
            None => format!("there is no frame {frame}: the motion has none"),
        }
    } else if let Some(&[before, after]) = unsorted {
        if before == after {
            format!("frame {before} is there twice")
        } else {
            format!("not in ascending order: {before} stands before {after}")
        }
    } else {
        let place = match (expected.get(first), got.get(first)) {
            (Some(expected), Some(got)) => format!("first different: {got} instead of {expected}"),
            (Some(expected), None) => format!("first different: {expected} is missing"),
            (None, Some(got)) => format!("first different: {got} is too many"),
            (None, None) => "none".to_owned(),
        };
        let lengths = (expected.len() != got.len())
            .then(|| format!("; {} instead of {}", counted(got.len(), "keyframe"), expected.len()));
        place + &lengths.unwrap_or_default()
    };
    Some(Difference { got: list(got, first), expected: list(expected, first), between })
}

/// A list in one line. Of a long one, the part around the place `at`.
pub(super) fn list<T: Display>(items: &[T], at: usize) -> String {
    if items.is_empty() {
        return "none".to_owned();
    }
    let at = at.min(items.len() - 1);
    let (mut from, mut to) = (at, at + 1);
    // A part of the list grows on both sides for as long as it fits.
    loop {
        let grows_left = from > 0 && fits(&part(items, from - 1, to));
        let grows_right = to < items.len() && fits(&part(items, from, to + 1));
        if grows_left && (!grows_right || at - from < to - at) {
            from -= 1;
        } else if grows_right {
            to += 1;
        } else {
            return part(items, from, to);
        }
    }
}

fn fits(text: &str) -> bool {
    text.chars().count() <= LIST_WIDTH
}

fn part(items: &[impl Display], from: usize, to: usize) -> String {
    let shown = joined(&items[from..to]);
    let (before, after) = (if from > 0 { "…, " } else { "" }, if to < items.len() { ", …" } else { "" });
    let is_whole = from == 0 && to == items.len();
    let all = if is_whole { String::new() } else { format!(" ({} in all)", items.len()) };
    format!("{before}{shown}{after}{all}")
}

fn joined(items: &[impl Display]) -> String {
    items.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")
}

/// With four decimals, or as a power of ten where these say nothing.
pub(super) fn number(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 || (0.01..1e9).contains(&size) { format!("{value:.4}") } else { format!("{value:.3e}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_differ_from_a_ten_thousandth_on() {
        for right in [0.003, 25.0, -4e6] {
            assert_eq!(between_numbers(right, right * 1.00009), None, "{right}");
            assert!(between_numbers(right, right * 1.00011).is_some(), "{right}");
            assert!(between_numbers(right, -right).is_some(), "{right}");
        }
        assert_eq!(between_numbers(0.0, -0.0), None);
        assert!(between_numbers(0.0, 1e-12).is_some());
    }

    #[test]
    fn what_is_not_a_number_is_never_right() {
        for right in [0.0, 1.0, f64::NAN, f64::INFINITY] {
            for got in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                let difference = between_numbers(right, got).unwrap();
                assert!(difference.between.starts_with("yours is not a number"), "{difference:?}");
            }
        }
    }

    #[test]
    fn a_factor_is_told() {
        let between = |expected, got| between_numbers(expected, got).unwrap().between;
        assert_eq!(between(14.0, 2.0), "12.0000 (yours is 0.143 times the right one)");
        assert_eq!(between(2.0, -2.0), "4.0000 (yours is -1.000 times the right one)");
        assert_eq!(between(0.0, 2.0), "2.0000");
        assert_eq!(between(2.0, 0.0), "2.0000");
    }

    #[test]
    fn the_first_different_keyframe_is_named() {
        let between = |expected: &[usize], got: &[usize]| {
            between_keyframes(expected, got, 10).map(|difference| difference.between)
        };
        assert_eq!(between(&[0, 4, 9], &[0, 4, 9]), None);
        assert_eq!(between(&[0, 4, 9], &[0, 3, 9]).unwrap(), "first different: 3 instead of 4");
        assert_eq!(
            between(&[0, 4, 9], &[0, 1, 4, 9]).unwrap(),
            "first different: 1 instead of 4; 4 keyframes instead of 3"
        );
        assert_eq!(
            between(&[0, 4, 9], &[0]).unwrap(),
            "first different: 4 is missing; 1 keyframe instead of 3"
        );
        assert_eq!(
            between(&[0, 4], &[0, 4, 9]).unwrap(),
            "first different: 9 is too many; 3 keyframes instead of 2"
        );
    }

    #[test]
    fn a_list_that_cannot_be_one_is_told_as_such() {
        let between = |got: &[usize], frames| between_keyframes(&[0, 4, 9], got, frames).unwrap().between;
        assert_eq!(between(&[0, 9, 4], 10), "not in ascending order: 9 stands before 4");
        assert_eq!(between(&[0, 4, 4, 9], 10), "frame 4 is there twice");
        assert_eq!(between(&[0, 4, 10], 10), "there is no frame 10: the last one is 9");
        assert_eq!(between(&[0], 0), "there is no frame 0: the motion has none");
    }

    #[test]
    fn a_long_list_is_shown_around_the_place_that_matters() {
        assert_eq!(list::<usize>(&[], 0), "none");
        assert_eq!(list(&[0, 7, 11], 2), "0, 7, 11");
        let long: Vec<usize> = (100..160).collect();
        for at in [0, 1, 30, 59, 60, 1000] {
            let text = list(&long, at);
            assert!(text.contains(&long[at.min(59)].to_string()), "{at}: {text}");
            assert!(text.ends_with(" (60 in all)") && fits(&text) && text.len() > 45, "{at}: {text}");
        }
        assert_eq!(list(&long, 0), "100, 101, 102, 103, 104, 105, 106, 107, … (60 in all)");
        assert_eq!(list(&long, 30), "…, 126, 127, 128, 129, 130, 131, 132, 133, … (60 in all)");
        let huge = [usize::MAX; 40];
        assert!(list(&huge, 20).len() < 100);
    }
}
