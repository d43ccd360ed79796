//! The best that can be done, and how close one comes to it.
#![allow(clippy::unwrap_used)] // Helpers of tests.

mod support;

use std::ops::ControlFlow;

use proptest::prelude::*;
use reduction::{Errors, Optimum, greedy, local_moves, optimum};
use skeleton::Representation;
use support::{both, dance, errors, go_on, motions};

/// What rounding may do.
const ROUNDING: f64 = 1.0 + 1e-9;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    #[test]
    fn nothing_is_better_than_the_optimum(
        frames in motions(0..10),
        count in 0_usize..11,
        cap in prop::option::of(0_usize..10),
        representation in prop::sample::select(&Representation::ALL[..]),
    ) {
        let errors = errors(&frames, representation);
        let least = every_reduction(errors.frame_count(), count)
            .filter(|keyframes| fits(keyframes, cap))
            .map(|keyframes| errors.of_keyframes(&keyframes))
            .min_by(f64::total_cmp);
        let best = optimum(&errors, count, cap, &mut go_on);
        prop_assert_eq!(best.is_some(), least.is_some());
        if let Some((best, least)) = best.zip(least) {
            prop_assert!(best.error <= least * ROUNDING && least <= best.error, "{} {least}", best.error);
            prop_assert_eq!(errors.of_keyframes(&best.keyframes), best.error);
            prop_assert!(fits(&best.keyframes, cap));
            prop_assert_eq!(best.keyframes.len(), count.max(2).min(errors.frame_count()));
            prop_assert_eq!(best.cap, cap);
        }
    }

    #[test]
    fn leaving_out_what_is_too_much_changes_nothing(
        frames in motions(2..40),
        count in 0_usize..20,
        cap in prop::option::of(1_usize..30),
        representation in prop::sample::select(&Representation::ALL[..]),
    ) {
        let errors = errors(&frames, representation);
        let best = optimum(&errors, count, cap, &mut go_on).map(|best| best.error);
        // Posed anew, so that none is known from before.
        let errors = support::errors(&frames, representation);
        let expected = least_error(&errors, count, cap);
        prop_assert_eq!(best.is_some(), expected.is_some());
        let (best, expected) = (best.unwrap_or(0.0), expected.unwrap_or(0.0));
        prop_assert!((best - expected).abs() <= 1e-9 * expected, "{best} {expected}");
    }

    #[test]
    fn moves_are_no_worse_than_greedy_and_the_optimum_is_no_worse_than_these(
        frames in motions(2..40),
        count in 0_usize..20,
        representation in prop::sample::select(&Representation::ALL[..]),
    ) {
        let errors = errors(&frames, representation);
        let greedy = greedy(&errors, count);
        let moved = local_moves(&errors, &greedy, &mut go_on);
        let best = optimum(&errors, count, None, &mut go_on).unwrap();
        prop_assert_eq!(moved.len(), greedy.len());
        let [greedy, moved] = [greedy, moved].map(|keyframes| errors.of_keyframes(&keyframes));
        prop_assert!(best.error <= moved * ROUNDING && moved <= greedy * ROUNDING, "{} {moved} {greedy}", best.error);
    }

    #[test]
    fn after_the_moves_no_move_helps(
        frames in motions(2..20),
        choice in any::<prop::sample::Index>(),
        representation in prop::sample::select(&Representation::ALL[..]),
    ) {
        let errors = errors(&frames, representation);
        let all: Vec<usize> = (0..errors.frame_count()).collect();
        let some: Vec<usize> = all.iter().copied().filter(|frame| (choice.index(usize::MAX) >> frame) & 1 == 1).collect();
        let moved = local_moves(&errors, &some, &mut go_on);
        let error = errors.of_keyframes(&moved);
        prop_assert!(!error.is_nan(), "{moved:?}");
        for index in 1..moved.len() - 1 {
            for place in moved[index - 1] + 1..moved[index + 1] {
                let mut other = moved.clone();
                other[index] = place;
                prop_assert!(errors.of_keyframes(&other) >= error / ROUNDING / ROUNDING, "{moved:?} {other:?}");
            }
        }
    }
}

#[test]
fn the_dance_comes_as_close_to_the_optimum_as_real_motions_do() {
    for errors in both(&dance()) {
        let keyframes = greedy(&errors, 20);
        let moved = local_moves(&errors, &keyframes, &mut go_on);
        let best = optimum(&errors, 20, None, &mut go_on).unwrap();
        let [greedy, moved] =
            [keyframes, moved].map(|keyframes| errors.of_keyframes(&keyframes) / best.error);
        println!("{}: greedy {greedy:.3}, moved {moved:.3}", errors.clip().representation());
        assert!((1.45..1.8).contains(&greedy), "{greedy}");
        assert!((1.0..1.25).contains(&moved), "{moved}");
    }
}

#[test]
fn the_optimum_of_the_dance_is_that_of_all_gaps() {
    for all in both(&dance()) {
        for cap in [None, Some(8), Some(12)] {
            // None of them remembers what another one posed.
            let errors = errors(&dance(), all.clip().representation());
            let best = optimum(&errors, 20, cap, &mut go_on).unwrap().error;
            let expected = least_error(&all, 20, cap).unwrap();
            assert!((best - expected).abs() <= 1e-9 * expected, "{cap:?}: {best} {expected}");
        }
    }
}

#[test]
fn a_cap_that_the_optimum_keeps_to_changes_nothing() {
    for errors in both(&dance()) {
        let free = optimum(&errors, 20, None, &mut go_on).unwrap();
        let longest = free.keyframes.windows(2).map(|gap| gap[1] - gap[0]).max().unwrap();
        let capped = optimum(&errors, 20, Some(longest), &mut go_on).unwrap();
        assert_eq!(capped, Optimum { cap: Some(longest), ..free.clone() });
        // One less, and the best reduction is another one.
        let tighter = optimum(&errors, 20, Some(longest - 1), &mut go_on).unwrap();
        assert!(tighter.error > free.error && fits(&tighter.keyframes, Some(longest - 1)));
        // 19 gaps of 7 frames do not reach over 140.
        assert_eq!(optimum(&errors, 20, Some(7), &mut go_on), None);
        assert!(optimum(&errors, 20, Some(8), &mut go_on).is_some());
    }
}

#[test]
fn the_optimum_spares_most_of_the_work() {
    for errors in both(&dance()) {
        optimum(&errors, 20, None, &mut go_on).unwrap();
        // All gaps of all lengths together have so many frames.
        let all: u64 = (2..141).map(|length| (141 - length) * (length - 1)).sum();
        assert!(errors.poses() < all / 20, "{} {all}", errors.poses());
    }
}

#[test]
fn progress_can_break_off_the_optimum_at_any_time() {
    let errors = &both(&dance())[1];
    let mut told = Vec::new();
    optimum(errors, 20, None, &mut |done, all| {
        told.push((done, all));
        ControlFlow::Continue(())
    });
    assert!(told.is_sorted() && told.iter().all(|(_, all)| *all == 140) && told.ends_with(&[(140, 140)]));
    for last in [1, 5, told.len() / 2, told.len()] {
        let mut calls = 0;
        let broken = optimum(errors, 20, None, &mut |_, _| {
            calls += 1;
            if calls == last { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
        assert_eq!((broken, calls), (None, last));
    }
}

#[test]
fn moves_that_are_broken_off_leave_whole_keyframes() {
    let errors = &both(&dance())[0];
    let start = greedy(errors, 20);
    let finished = errors.of_keyframes(&local_moves(errors, &start, &mut go_on));
    let mut calls = 0;
    let broken = local_moves(errors, &start, &mut |settled, all| {
        calls += 1;
        assert!(settled <= all && all == 18);
        if calls == 10 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    let broken = errors.of_keyframes(&broken);
    assert_eq!(calls, 10);
    assert!(finished < broken && broken < errors.of_keyframes(&start), "{finished} {broken}");
}

/// By dynamic programming without any short cut.
fn least_error(errors: &Errors, count: usize, cap: Option<usize>) -> Option<f64> {
    let frames = errors.frame_count();
    let mut least: Vec<f64> = (0..frames).map(|frame| if frame == 0 { 0.0 } else { f64::INFINITY }).collect();
    for _ in 1..count.max(2).min(frames) {
        let best = |end: usize| {
            let starts = end.saturating_sub(cap.unwrap_or(frames))..end;
            starts.map(|start| least[start] + errors.of_gap(start, end)).fold(f64::INFINITY, f64::min)
        };
        least = (0..frames).map(best).collect();
    }
    least.last().copied().filter(|least| *least < f64::INFINITY)
}

fn fits(keyframes: &[usize], cap: Option<usize>) -> bool {
    keyframes.windows(2).all(|gap| cap.is_none_or(|cap| gap[1] - gap[0] <= cap))
}

/// All ways to choose keyframes from the first frame to the last.
fn every_reduction(frame_count: usize, count: usize) -> impl Iterator<Item = Vec<usize>> {
    let count = count.max(2).min(frame_count);
    let choices = (0_usize..1 << frame_count).filter(move |choice| choice.count_ones() as usize == count);
    choices.map(move |choice| (0..frame_count).filter(|frame| choice >> frame & 1 == 1).collect()).filter(
        move |keyframes: &Vec<usize>| {
            frame_count == 0 || keyframes.starts_with(&[0]) && keyframes.ends_with(&[frame_count - 1])
        },
    )
}

/// An error that is not a number is that of a motion, and not of the program.
#[test]
fn frames_that_are_no_numbers_have_an_optimum_all_the_same() {
    let (skeleton, mut frames) = dance();
    frames.truncate(30);
    frames[12].angles[3] = f32::NAN;
    frames[20].angles[0] = f32::INFINITY;
    for representation in Representation::ALL {
        let errors = Errors::new(&skeleton, &frames, representation);
        // The only eight that leave both out of all gaps.
        let best = optimum(&errors, 8, None, &mut go_on).unwrap();
        assert_eq!(best.keyframes, [0, 11, 12, 13, 19, 20, 21, 29]);
        assert!(best.error.is_finite());
        // With fewer, no error is a number.
        for cap in [None, Some(8)] {
            let best = optimum(&errors, 5, cap, &mut go_on).unwrap();
            assert_eq!(best.keyframes.len(), 5);
            assert!(best.keyframes.is_sorted_by(|a, b| a < b) && best.error.is_nan());
            assert!(fits(&best.keyframes, cap));
        }
        assert_eq!(local_moves(&errors, &greedy(&errors, 5), &mut go_on).len(), 5);
    }
}
