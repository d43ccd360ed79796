//! Motions of few frames, and numbers that fit no motion.
#![allow(clippy::unwrap_used)] // Helpers of tests.

mod support;

use reduction::{Errors, curve, greedy, local_moves, optimum};
use skeleton::{Representation, Skeleton};
use support::{both, dance, go_on};

#[test]
fn motions_of_no_to_three_frames_keep_what_they_must() {
    let (skeleton, frames) = dance();
    // The frames, how many are wanted, and those that stay.
    let cases: [(usize, usize, &[usize]); 9] = [
        (0, 0, &[]),
        (0, 5, &[]),
        (1, 0, &[0]),
        (1, 5, &[0]),
        (2, 0, &[0, 1]),
        (2, 5, &[0, 1]),
        (3, 1, &[0, 2]),
        (3, 2, &[0, 2]),
        (3, 9, &[0, 1, 2]),
    ];
    for (frame_count, count, expected) in cases {
        for errors in both(&(skeleton.clone(), frames[..frame_count].to_vec())) {
            let keyframes = greedy(&errors, count);
            assert_eq!(keyframes, expected);
            assert_eq!(local_moves(&errors, &keyframes, &mut go_on), expected);
            let best = optimum(&errors, count, None, &mut go_on).unwrap();
            assert_eq!(best.keyframes, expected);
            assert_eq!(best.error, errors.of_keyframes(expected));
            let curve = curve(&errors, count, &mut go_on);
            assert_eq!(curve.removed.len(), frame_count - expected.len());
            assert_eq!(curve.errors.len(), curve.removed.len() + 1);
            assert_eq!(*curve.errors.last().unwrap(), errors.of_keyframes(expected));
        }
    }
}

#[test]
fn counts_below_two_are_two_and_large_ones_keep_all() {
    let (skeleton, frames) = dance();
    for errors in both(&(skeleton, frames[..30].to_vec())) {
        for count in [0, 1, 2] {
            assert_eq!(greedy(&errors, count), [0, 29]);
            assert_eq!(optimum(&errors, count, None, &mut go_on).unwrap().keyframes, [0, 29]);
            assert_eq!(curve(&errors, count, &mut go_on).removed.len(), 28);
        }
        let all: Vec<usize> = (0..30).collect();
        for count in [30, 31, usize::MAX] {
            assert_eq!(greedy(&errors, count), all);
            let best = optimum(&errors, count, None, &mut go_on).unwrap();
            assert_eq!((best.keyframes, best.error), (all.clone(), 0.0));
            assert_eq!(curve(&errors, count, &mut go_on).errors, [0.0]);
        }
    }
}

#[test]
fn keyframes_that_are_none_are_put_right_before_they_are_moved() {
    let (skeleton, frames) = dance();
    let errors = &both(&(skeleton, frames[..30].to_vec()))[0];
    let right = local_moves(errors, &[0, 10, 20, 29], &mut go_on);
    assert_eq!(right.len(), 4);
    for odd in [&[20, 10][..], &[10, 20, 20, 10], &[0, 10, 20, 30, usize::MAX], &[29, 20, 10, 0]] {
        assert_eq!(local_moves(errors, odd, &mut go_on), right, "{odd:?}");
    }
    assert_eq!(local_moves(errors, &[], &mut go_on), [0, 29]);
}

#[test]
fn errors_of_what_a_motion_does_not_have_are_not_a_number() {
    let (skeleton, frames) = dance();
    let errors = &both(&(skeleton, frames[..30].to_vec()))[1];
    for (start, end, frame) in [(5, 3, 4), (3, 5, 2), (3, 5, 6), (3, 30, 4), (30, 30, 30), (0, usize::MAX, 9)]
    {
        assert!(errors.of_frame(start, end, frame).is_nan(), "{start} {end} {frame}");
    }
    for (start, end) in [(5, 3), (3, 30), (usize::MAX, usize::MAX)] {
        assert!(errors.of_gap(start, end).is_nan(), "{start} {end}");
    }
    for keyframes in [&[][..], &[0], &[0, 28], &[1, 29], &[0, 29, 29], &[0, 9, 5, 29], &[0, 29, 30]] {
        assert!(errors.of_keyframes(keyframes).is_nan(), "{keyframes:?}");
    }
    assert!(errors.cost(0, 5, 40).is_nan());
    assert_eq!(errors.of_gap(3, 3), 0.0);
    assert_eq!(errors.of_frame(3, 5, 5), 0.0);
}

#[test]
fn a_skeleton_without_joints_has_no_error() {
    let errors = Errors::new(&Skeleton::new(), &vec![skeleton::Frame::default(); 9], Representation::Euler);
    assert_eq!(greedy(&errors, 3), [0, 7, 8]);
    assert_eq!(errors.of_gap(0, 8), 0.0);
}

#[test]
fn errors_can_be_sent_to_another_thread() {
    let errors = both(&dance())[0].of_gap(0, 140);
    let [sent, _] = both(&dance());
    assert_eq!(std::thread::spawn(move || sent.of_gap(0, 140)).join().unwrap(), errors);
}
