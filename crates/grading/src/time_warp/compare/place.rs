//! Whether two answers name the same place of a motion.

use skeleton::acclaim::Between;

use crate::Difference;
use crate::compare::NOT_A_NUMBER;

/// Two places are the same when no frame's part in them differs by more than this.
pub const PLACE_TOLERANCE: f64 = 1e-4;

/// Compares two places of a motion of so many frames. A place is a part of the frame before and the rest of the frame
/// after. So the frame 3 is named by "3 and 3", whatever `t`, by "3 and 4, 0" and by "2 and 3, 1".
pub(super) fn difference(expected: Between, got: Between, count: usize) -> Option<Difference> {
    let are_there = |place: Between| place.before.max(place.after) < count;
    let between = if !got.t.is_finite() {
        NOT_A_NUMBER.to_owned()
    } else if are_there(got) != are_there(expected) {
        let far = got.before.max(got.after);
        format!("there is no frame {far}: the last one is {}", count.saturating_sub(1))
    } else if is_same(expected, got) {
        return None;
    } else {
        let apart = (along(got) - along(expected)).abs();
        let not_next = got.before.abs_diff(got.after) > 1;
        if not_next { "yours are not next to each other".to_owned() } else { frames(apart) }
    };
    Some(Difference { got: in_words(got), expected: in_words(expected), between })
}

fn is_same(a: Between, b: Between) -> bool {
    [a.before, a.after, b.before, b.after].into_iter().all(|frame| {
        let apart = (part(a, frame) - part(b, frame)).abs();
        apart <= PLACE_TOLERANCE
    })
}

/// Which part of a place the frame is.
fn part(place: Between, frame: usize) -> f64 {
    let t = f64::from(place.t);
    let before = if place.before == frame { 1.0 - t } else { 0.0 };
    let after = if place.after == frame { t } else { 0.0 };
    before + after
}

/// The place as one number.
fn along(place: Between) -> f64 {
    let (before, after) = (place.before as f64, place.after as f64);
    before + f64::from(place.t) * (after - before)
}

/// `0.2500 frames`.
fn frames(apart: f64) -> String {
    format!("{apart:.4} frame{}", if apart == 1.0 { "" } else { "s" })
}

fn in_words(Between { before, after, t }: Between) -> String {
    format!("before {before}, after {after}, t {t:.4}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn place(before: usize, after: usize, t: f32) -> Between {
        Between { before, after, t }
    }

    fn said(expected: Between, got: Between) -> Option<String> {
        difference(expected, got, 10).map(|difference| difference.between)
    }

    #[test]
    fn one_place_has_many_names() {
        let names =
            [place(3, 3, 0.0), place(3, 3, 0.7), place(3, 4, 0.0), place(2, 3, 1.0), place(3, 0, 0.0)];
        for a in names {
            assert!(names.iter().all(|b| said(a, *b).is_none()), "{a:?}");
        }
        assert_eq!(said(place(2, 3, 0.75), place(3, 2, 0.25)), None);
        assert_eq!(said(place(2, 3, 0.99996), place(3, 4, 0.00003)), None);
    }

    #[test]
    fn places_differ_from_a_ten_thousandth_of_a_frame_on() {
        for t in [0.0, 0.3, 0.75] {
            assert_eq!(said(place(2, 3, t), place(2, 3, t + 0.00009)), None, "{t}");
            assert!(said(place(2, 3, t), place(2, 3, t + 0.00012)).is_some(), "{t}");
        }
        assert!(said(place(2, 3, 0.99992), place(3, 4, 0.00011)).is_some());
        assert_eq!(said(place(2, 3, 0.5), place(3, 4, 0.5)).unwrap(), "1.0000 frame");
        assert_eq!(said(place(2, 3, 0.5), place(2, 3, 0.25)).unwrap(), "0.2500 frames");
    }

    #[test]
    fn what_is_half_way_between_distant_frames_is_no_place() {
        assert_eq!(said(place(2, 3, 0.5), place(1, 4, 0.5)).unwrap(), "yours are not next to each other");
    }

    #[test]
    fn a_frame_that_is_not_there_is_never_right() {
        for beyond in [place(9, 10, 0.0), place(9, 10, 0.5), place(10, 9, 1.0), place(usize::MAX, 9, 0.5)] {
            let said = said(place(9, 9, 0.5), beyond).unwrap();
            assert!(said.starts_with("there is no frame 1") && said.ends_with("the last one is 9"), "{said}");
        }
    }

    #[test]
    fn what_is_not_a_number_is_never_right() {
        for t in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
            assert_eq!(said(place(3, 3, 0.0), place(3, 3, t)).unwrap(), NOT_A_NUMBER);
        }
    }
}
