//! The heap leaves the keyframes that an algorithm leaves which looks at everything again and again.
#![allow(clippy::unwrap_used)] // Helpers of tests.

mod support;

use proptest::prelude::*;
use reduction::{Errors, greedy};
use skeleton::{FrameErrors, Pose, RemovalCosts, Representation};
use solutions::KEYFRAMES;
use support::{both, dance, dance_with_a_pause, errors, motions, naive, noisy, posed_cost, still};

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    #[test]
    fn the_heap_agrees_with_the_naive_algorithm_on_any_motion(
        frames in motions(0..40),
        count in 0_usize..20,
        representation in prop::sample::select(&Representation::ALL[..]),
    ) {
        let errors = errors(&frames, representation);
        prop_assert_eq!(greedy(&errors, count), naive(frames.1.len(), count, posed_cost(&errors)));
    }
}

#[test]
fn the_heap_agrees_with_the_naive_algorithm_on_the_dance() {
    for errors in both(&dance()) {
        let keyframes = greedy(&errors, 20);
        assert_eq!(keyframes.len(), 20);
        assert_eq!(keyframes, naive(141, 20, posed_cost(&errors)));
    }
}

#[test]
fn right_functions_of_a_student_leave_the_same_keyframes() {
    let (skeleton, frames) = dance();
    for representation in Representation::ALL {
        let clip = inbetween::clip(&skeleton, &frames, representation);
        let (mut original, mut interpolated) = (Pose::default(), Pose::default());
        let errors = Errors::new(&skeleton, &frames, representation);
        for (start, end) in [(0, 140), (3, 9), (70, 72), (100, 130)] {
            for frame in start..=end {
                clip.original(frame, &mut original);
                clip.between(start, end, frame, &mut interpolated);
                let error = (KEYFRAMES.pose_error)(&skeleton, &original, &interpolated);
                // To the last bit, so that nothing is left to chance.
                assert_eq!(
                    error,
                    errors.of_frame(start, end, frame),
                    "{representation} {start} {end} {frame}"
                );
            }
        }
        let error = |start, end, frame| {
            let (mut original, mut interpolated) = (Pose::default(), Pose::default());
            clip.original(frame, &mut original);
            clip.between(start, end, frame, &mut interpolated);
            (KEYFRAMES.pose_error)(&skeleton, &original, &interpolated)
        };
        let frame_errors = FrameErrors::new(&error);
        let cost = |before, frame, after| (KEYFRAMES.removal_cost)(before, frame, after, &frame_errors);
        let keyframes = (KEYFRAMES.reduce)(frames.len(), 20, &RemovalCosts::new(&cost));
        assert_eq!(keyframes, greedy(&errors, 20));
    }
}

#[test]
fn the_earliest_frames_of_a_still_motion_go_first() {
    let (skeleton, frames) = dance();
    for frames in [still(&frames[60], 5_508), noisy(&frames[60], 5_508)] {
        for errors in both(&(skeleton.clone(), frames)) {
            let keyframes = greedy(&errors, 20);
            let expected: Vec<usize> = [0].into_iter().chain(5_508 - 19..5_508).collect();
            assert_eq!(keyframes, expected);
            assert_eq!(errors.of_keyframes(&keyframes), 0.0);
        }
    }
}

#[test]
fn the_naive_algorithm_leaves_the_same_frames_of_a_still_motion() {
    let (skeleton, frames) = dance();
    for frames in [still(&frames[60], 5_508), noisy(&frames[60], 5_508)] {
        for errors in both(&(skeleton.clone(), frames)) {
            let cost = |before, frame, after| errors.cost(before, frame, after);
            assert_eq!(greedy(&errors, 20), naive(5_508, 20, cost));
        }
    }
}

#[test]
fn a_pause_in_a_motion_keeps_its_first_and_its_last_frame_for_longest() {
    for errors in both(&dance_with_a_pause(1_000)) {
        let keyframes = greedy(&errors, 100);
        let cost = |before, frame, after| errors.cost(before, frame, after);
        assert_eq!(keyframes, naive(1_140, 100, cost));
        let inside: Vec<&usize> = keyframes.iter().filter(|frame| (60..1_060).contains(*frame)).collect();
        assert_eq!(inside, [&60, &1_059]);
    }
}

#[test]
fn a_pause_without_memory_leaves_the_same_keyframes() {
    for errors in both(&dance_with_a_pause(60)) {
        assert_eq!(greedy(&errors, 20), naive(200, 20, posed_cost(&errors)));
    }
}
