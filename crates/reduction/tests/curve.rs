//! How the error grows.
#![allow(clippy::unwrap_used)] // Helpers of tests.

mod support;

use std::ops::ControlFlow;

use proptest::prelude::*;
use reduction::{Curve, Errors, curve, greedy};
use skeleton::Representation;
use support::{both, dance, dance_with_a_pause, errors, go_on, motions};

#[test]
fn the_curve_of_the_dance_says_what_is_left_after_each_removal() {
    for frames in [dance(), dance_with_a_pause(100)] {
        for errors in both(&frames) {
            let curve = curve(&errors, 2, &mut go_on);
            says_what_is_left(&errors, &curve);
            assert_eq!(curve.removed.len(), frames.1.len() - 2);
        }
    }
}

#[test]
fn the_curve_of_the_dance_rises() {
    for errors in both(&dance()) {
        let curve = curve(&errors, 2, &mut go_on);
        let falls = curve.errors.windows(2).filter(|two| two[1] < two[0]).count();
        // Interpolating one more frame may bring others closer to where they were: a growth may be negative, once in
        // a while.
        assert!(falls <= 3, "{falls}");
        let quarters: Vec<f64> = curve.errors.iter().copied().step_by(139 / 4).collect();
        assert!(quarters.is_sorted_by(|a, b| a < b), "{quarters:?}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn any_curve_says_what_is_left_and_ends_at_the_greedy_keyframes(
        frames in motions(0..30),
        count in 0_usize..40,
        representation in prop::sample::select(&Representation::ALL[..]),
    ) {
        let errors = errors(&frames, representation);
        let curve = curve(&errors, count, &mut go_on);
        says_what_is_left(&errors, &curve);
        prop_assert_eq!(left(&errors, &curve.removed), greedy(&errors, count));
    }
}

#[test]
fn progress_is_told_of_every_removal_and_can_break() {
    let errors = &both(&dance())[0];
    let mut told = Vec::new();
    let whole = curve(errors, 20, &mut |done, all| {
        told.push((done, all));
        ControlFlow::Continue(())
    });
    assert_eq!(told, (1..=121).map(|done| (done, 121)).collect::<Vec<_>>());
    let broken = curve(errors, 20, &mut |done, _| {
        if done == 50 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    assert_eq!(broken.removed, whole.removed[..50]);
    assert_eq!(broken.errors, whole.errors[..51]);
}

fn says_what_is_left(errors: &Errors, curve: &Curve) {
    assert_eq!(curve.errors[0], 0.0);
    assert_eq!(curve.errors.len(), curve.removed.len() + 1);
    let largest = curve.errors.iter().copied().fold(0.0, f64::max);
    for (removed, error) in curve.errors.iter().enumerate() {
        let expected = errors.of_keyframes(&left(errors, &curve.removed[..removed]));
        assert!((error - expected).abs() <= 1e-12 * largest, "{removed}: {error} {expected}");
    }
}

fn left(errors: &Errors, removed: &[usize]) -> Vec<usize> {
    (0..errors.frame_count()).filter(|frame| !removed.contains(frame)).collect()
}
