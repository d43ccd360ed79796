//! What an algorithm that chooses keyframes is told.

use std::cell::RefCell;
use std::panic::catch_unwind;

use skeleton::{FrameErrors, RemovalCosts};

#[test]
fn a_keyframe_has_no_error_and_is_not_asked_about() {
    let asked = RefCell::new(Vec::new());
    let error = |start, end, frame| {
        asked.borrow_mut().push((start, end, frame));
        7.0
    };
    let errors = FrameErrors::new(&error);
    assert_eq!([errors.between(2, 5, 2), errors.between(2, 5, 4), errors.between(2, 5, 5)], [0.0, 7.0, 0.0]);
    assert_eq!(asked.into_inner(), [(2, 5, 4)]);
}

#[test]
fn a_frame_that_is_not_between_is_named() {
    let question = || FrameErrors::new(&|_, _, _| 1.0).between(2, 5, 6);
    let words = catch_unwind(question).unwrap_err();
    let words = words.downcast_ref::<String>().unwrap();
    assert_eq!(words, "errors.between(2, 5, 6): frame 6 is not between 2 and 5");
}

#[test]
fn a_removal_needs_a_keyframe_on_either_side() {
    assert_eq!(RemovalCosts::new(&|a, b, c| (100 * a + 10 * b + c) as f64).of(1, 2, 4), 124.0);
    for (before, frame, after) in [(2, 2, 4), (1, 4, 4), (4, 3, 5)] {
        let question = || RemovalCosts::new(&|_, _, _| 1.0).of(before, frame, after);
        let words = catch_unwind(question).unwrap_err();
        let words = words.downcast_ref::<String>().unwrap();
        assert!(words.starts_with(&format!("costs.of({before}, {frame}, {after})")), "{words}");
    }
}
