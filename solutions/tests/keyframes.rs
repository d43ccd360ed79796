//! The reference solution of keyframes: the examples of its own text, and what holds for any costs.
#![allow(clippy::unwrap_used)] // Helpers of tests.

use std::hash::{DefaultHasher, Hash, Hasher};

use glam::Vec3;
use proptest::prelude::*;
use skeleton::{FrameErrors, JointId, Pose, RemovalCosts, Skeleton};
use solutions::keyframes::{Removals, pose_error, reduce, removal_cost};

mod errors_of_poses {
    use super::*;

    #[test]
    fn of_the_example_are_25() {
        let (skeleton, pose) = two_tips();
        let mut other = pose.clone();
        other[JointId(2)].position += Vec3::new(3.0, 4.0, 0.0);
        assert_eq!(pose_error(&skeleton, &pose, &other), 25.0);
        assert_eq!(pose_error(&skeleton, &other, &pose), 25.0);
    }

    #[test]
    fn count_tips_alone_and_all_of_them() {
        let (skeleton, pose) = two_tips();
        let error = |joint: usize| {
            let mut other = pose.clone();
            other[JointId(joint)].position.z += 2.0;
            pose_error(&skeleton, &pose, &other)
        };
        // The root; a joint with an End Site; the End Site; a joint that no other joint hangs on.
        assert_eq!([0, 1, 2, 3].map(error), [0.0, 0.0, 4.0, 4.0]);
        assert_eq!(pose_error(&Skeleton::new(), &Pose::default(), &Pose::default()), 0.0);
    }

    fn two_tips() -> (Skeleton, Pose) {
        let mut skeleton = Skeleton::new();
        let root = skeleton.add_joint(None, "root", Vec3::ZERO, []).unwrap();
        let arm = skeleton.add_joint(Some(root), "arm", Vec3::X, []).unwrap();
        skeleton.add_end_site(arm, "End Site", Vec3::X).unwrap();
        skeleton.add_joint(Some(root), "tail", Vec3::Z, []).unwrap();
        let pose = Pose::identity(skeleton.len());
        (skeleton, pose)
    }
}

mod costs {
    use super::*;

    #[test]
    fn of_the_examples_are_those_they_say() {
        let error = |start: usize, end: usize, frame: usize| (100 * start + 10 * end + frame) as f64;
        let errors = FrameErrors::new(&error);
        let between = |start, end, frame| errors.between(start, end, frame);
        assert_eq!(removal_cost(2, 3, 4, &errors), between(2, 4, 3));
        assert_eq!(removal_cost(2, 4, 5, &errors), between(2, 5, 3) + between(2, 5, 4) - between(2, 4, 3));
    }

    proptest! {
        /// Added up, they are the error that is left.
        #[test]
        fn add_up_to_the_accumulated_error(seed in any::<u64>(), frame_count in 2_usize..20) {
            let error = |start, end, frame| (random(seed, [start, end, frame]) % 1_000) as f64;
            let errors = FrameErrors::new(&error);
            let cost = |before, frame, after| removal_cost(before, frame, after, &errors);
            let costs: f64 = Removals::new(frame_count, &RemovalCosts::new(&cost)).map(|removal| removal.cost).sum();
            let left: f64 = (1..frame_count - 1).map(|frame| error(0, frame_count - 1, frame)).sum();
            prop_assert_eq!(costs, left);
        }
    }
}

mod reductions {
    use super::*;

    #[test]
    fn of_the_example_are_those_it_says() {
        let cost = |before: usize, frame: usize, after: usize| match (before, frame, after) {
            (0, 1, 2) => 4.0,
            (1, 2, 3) => 1.0,
            (2, 3, 4) => 2.0,
            (0, 1, 3) => 6.0,
            (1, 3, 4) => 7.0,
            (0, 3, 4) => 9.0,
            other => panic!("{other:?} is not in the example"),
        };
        assert_eq!(reduce(5, 3, &RemovalCosts::new(&cost)), [0, 3, 4]);
    }

    #[test]
    fn keep_the_first_and_the_last_frame_and_no_more_than_there_are() {
        let costs = RemovalCosts::new(&|_, _, _| 1.0);
        for (frame_count, count, expected) in [
            (0, 0, &[][..]),
            (0, 9, &[]),
            (1, 0, &[0]),
            (2, 0, &[0, 1]),
            (3, 0, &[0, 2]),
            (3, 1, &[0, 2]),
            (3, 3, &[0, 1, 2]),
            (3, usize::MAX, &[0, 1, 2]),
            // Of those that cost the same, the earliest goes.
            (6, 4, &[0, 3, 4, 5]),
        ] {
            assert_eq!(reduce(frame_count, count, &costs), expected, "{frame_count} {count}");
        }
    }

    #[test]
    fn take_minus_zero_for_zero() {
        for zeros in [[0.0, -0.0], [-0.0, 0.0]] {
            let cost = |_, frame: usize, _| zeros[frame % 2];
            assert_eq!(reduce(6, 3, &RemovalCosts::new(&cost)), [0, 4, 5]);
        }
    }

    #[test]
    fn remove_last_what_costs_no_number() {
        // Not a number, as it comes out of a calculation, and with the other sign.
        let infinity = std::hint::black_box(f64::INFINITY);
        for odd in [infinity - infinity, infinity * 0.0, f64::NAN, -f64::NAN] {
            let order = [odd, f64::INFINITY, 1.0, f64::NEG_INFINITY, -1.0];
            let cost = |_, frame: usize, _| order[frame - 1];
            let costs = RemovalCosts::new(&cost);
            let removed: Vec<usize> = Removals::new(7, &costs).map(|removal| removal.frame).collect();
            assert_eq!(removed, [4, 5, 3, 2, 1]);
        }
    }

    proptest! {
        /// Few different costs, so that many tie.
        #[test]
        fn are_those_of_looking_at_all_costs_again(
            seed in any::<u64>(),
            different in prop_oneof![1_u64..6, Just(u64::MAX)],
            frame_count in 0_usize..40,
            count in 0_usize..40,
        ) {
            let cost = |before, frame, after| (random(seed, [before, frame, after]) % different) as f64 - 1.0;
            let reduced = reduce(frame_count, count, &RemovalCosts::new(&cost));
            prop_assert_eq!(&reduced, &naive(frame_count, count, cost));
            prop_assert_eq!(reduced.len(), count.max(2).min(frame_count));
            prop_assert!(reduced.is_sorted_by(|a, b| a < b));
        }

        #[test]
        fn bear_any_cost(
            seed in any::<u64>(),
            odd in prop::collection::vec(prop::num::f64::ANY, 1..5),
            frame_count in 0_usize..40,
            count in 0_usize..10,
        ) {
            let special = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -0.0, 0.0, f64::MAX, f64::MIN_POSITIVE];
            let all: Vec<f64> = special.into_iter().chain(odd).collect();
            let cost = |before, frame, after| all[random(seed, [before, frame, after]) as usize % all.len()];
            let reduced = reduce(frame_count, count, &RemovalCosts::new(&cost));
            prop_assert_eq!(&reduced, &naive(frame_count, count, cost));
            prop_assert_eq!(reduced.len(), count.max(2).min(frame_count));
        }

        #[test]
        fn go_on_until_two_frames_are_left(seed in any::<u64>(), frame_count in 0_usize..40) {
            let cost = |before, frame, after| random(seed, [before, frame, after]) as f64;
            let mut removed: Vec<usize> =
                Removals::new(frame_count, &RemovalCosts::new(&cost)).map(|removal| removal.frame).collect();
            removed.sort_unstable();
            prop_assert_eq!(removed, (1..frame_count.saturating_sub(1)).collect::<Vec<_>>());
        }
    }

    /// As the assignment says it: what is no number is not less than anything.
    fn naive(frame_count: usize, count: usize, cost: impl Fn(usize, usize, usize) -> f64) -> Vec<usize> {
        let mut keyframes: Vec<usize> = (0..frame_count).collect();
        while keyframes.len() > count.max(2) {
            let costs: Vec<f64> =
                keyframes.windows(3).map(|three| cost(three[0], three[1], three[2])).collect();
            let mut least = 0;
            for (index, cost) in costs.iter().enumerate() {
                if *cost < costs[least] || costs[least].is_nan() && !cost.is_nan() {
                    least = index;
                }
            }
            keyframes.remove(least + 1);
        }
        keyframes
    }
}

/// A number that only depends on these.
fn random(seed: u64, numbers: [usize; 3]) -> u64 {
    let mut hasher = DefaultHasher::new();
    (seed, numbers).hash(&mut hasher);
    hasher.finish()
}
