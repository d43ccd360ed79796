//! What counts as right in the exercise on keyframes, and what is said when something is not.

#[path = "support/marks.rs"]
mod marks;

use std::cmp::Ordering;

use exam::Functions;
use grading::{CheckState, Exam, PUBLIC_SEED, PartReport, PartState, Solutions, Trouble, keyframes};
use skeleton::{FrameErrors, JointId, KeyframesFunctions, Pose, RemovalCosts, Skeleton};

fn public() -> Exam {
    keyframes::exam(PUBLIC_SEED, &Solutions)
}

fn report(exam: &Exam, part: usize, functions: KeyframesFunctions) -> PartReport {
    marks::report(exam, part, Functions::keyframes(functions))
}

fn trouble(exam: &Exam, functions: KeyframesFunctions) -> Option<Trouble> {
    marks::whole(exam, Functions::keyframes(functions)).trouble
}

/// Everything in `f32`, and all costs looked at again for each removal: as a student may well write it.
mod plain {
    use super::*;

    pub const FUNCTIONS: KeyframesFunctions = KeyframesFunctions { pose_error, removal_cost, reduce };

    fn pose_error(skeleton: &Skeleton, original: &Pose, interpolated: &Pose) -> f64 {
        let mut sum = 0.0_f32;
        for joint in skeleton.joints() {
            let has_children = skeleton.joints().iter().any(|other| other.parent == Some(joint.id));
            if joint.is_end_site || !has_children {
                let off = interpolated[joint.id].position - original[joint.id].position;
                sum += off.length().powi(2);
            }
        }
        f64::from(sum)
    }

    fn removal_cost(before: usize, frame: usize, after: usize, errors: &FrameErrors) -> f64 {
        let mut cost = 0.0_f32;
        for i in before..=after {
            let old = if i < frame {
                errors.between(before, frame, i) as f32
            } else {
                errors.between(frame, after, i) as f32
            };
            cost += errors.between(before, after, i) as f32 - old;
        }
        f64::from(cost)
    }

    fn reduce(frame_count: usize, count: usize, costs: &RemovalCosts) -> Vec<usize> {
        let mut keyframes: Vec<usize> = (0..frame_count).collect();
        while keyframes.len() > count && keyframes.len() > 2 {
            let mut best = 1;
            let mut least = f32::MAX;
            for place in 1..keyframes.len() - 1 {
                let cost = costs.of(keyframes[place - 1], keyframes[place], keyframes[place + 1]) as f32;
                if cost < least {
                    (best, least) = (place, cost);
                }
            }
            keyframes.remove(best);
        }
        keyframes
    }
}

/// With parents in a set, gaps that are remembered, and costs in a sorted set beside a linked list.
mod sorted {
    use std::collections::{BTreeSet, HashMap, HashSet};

    use super::*;

    pub const FUNCTIONS: KeyframesFunctions = KeyframesFunctions { pose_error, removal_cost, reduce };

    fn pose_error(skeleton: &Skeleton, original: &Pose, interpolated: &Pose) -> f64 {
        let parents: HashSet<JointId> = skeleton.joints().iter().filter_map(|joint| joint.parent).collect();
        let tips = skeleton.joints().iter().map(|joint| joint.id).filter(|id| !parents.contains(id));
        let coordinates = |pose: &Pose, id| pose[id].position.to_array().map(f64::from);
        tips.map(|id| {
            let (a, b) = (coordinates(original, id), coordinates(interpolated, id));
            (0..3).map(|axis| (a[axis] - b[axis]).powi(2)).sum::<f64>()
        })
        .sum()
    }

    fn removal_cost(before: usize, frame: usize, after: usize, errors: &FrameErrors) -> f64 {
        let mut known = HashMap::new();
        let mut gap = |start, end| {
            let error = || (start..=end).rev().map(|i| errors.between(start, end, i)).sum::<f64>();
            *known.entry((start, end)).or_insert_with(error)
        };
        gap(before, after) - (gap(before, frame) + gap(frame, after))
    }

    fn reduce(frame_count: usize, count: usize, costs: &RemovalCosts) -> Vec<usize> {
        let mut before: Vec<usize> = (0..frame_count).map(|frame| frame.saturating_sub(1)).collect();
        let mut after: Vec<usize> = (1..=frame_count).collect();
        let mut kept: BTreeSet<usize> = (0..frame_count).collect();
        let is_inner = |frame: usize| frame > 0 && frame + 1 < frame_count;
        let mut known = vec![Cost(0.0); frame_count];
        let mut order = BTreeSet::new();
        for frame in (0..frame_count).filter(|frame| is_inner(*frame)) {
            known[frame] = Cost(costs.of(frame - 1, frame, frame + 1));
            order.insert((known[frame], frame));
        }
        while kept.len() > count {
            let Some((_, frame)) = order.pop_first() else { break };
            kept.remove(&frame);
            let (left, right) = (before[frame], after[frame]);
            (after[left], before[right]) = (right, left);
            for neighbour in [left, right].into_iter().filter(|frame| is_inner(*frame)) {
                order.remove(&(known[neighbour], neighbour));
                known[neighbour] = Cost(costs.of(before[neighbour], neighbour, after[neighbour]));
                order.insert((known[neighbour], neighbour));
            }
        }
        kept.into_iter().collect()
    }

    #[derive(Clone, Copy, PartialEq)]
    struct Cost(f64);

    impl Eq for Cost {}

    impl PartialOrd for Cost {
        fn partial_cmp(&self, other: &Cost) -> Option<Ordering> {
            Some(self.cmp(other))
        }
    }

    impl Ord for Cost {
        fn cmp(&self, other: &Cost) -> Ordering {
            self.0.total_cmp(&other.0)
        }
    }
}

#[test]
fn single_precision_slow_loops_and_other_collections_are_right() {
    for seed in (0..40).map(|n| n * 3001 + PUBLIC_SEED) {
        let exam = keyframes::exam(seed, &Solutions);
        for functions in [plain::FUNCTIONS, sorted::FUNCTIONS] {
            for part in 0..3 {
                assert_eq!(report(&exam, part, functions).state, PartState::Right, "seed {seed}");
            }
            assert!(trouble(&exam, functions).is_none(), "seed {seed}");
        }
    }
}

/// In every step one removal is clearly the best, so that nobody's keyframes hang on the last digits of a cost. Where costs
/// are the same on purpose, they are small whole numbers.
#[test]
fn what_is_lost_in_sums_decides_nothing() {
    /// Between −1 and 1, different for each three frames.
    fn noise(before: usize, frame: usize, after: usize) -> f64 {
        ((before * 7919 + frame * 104_729 + after * 1_299_709) % 2001) as f64 / 1000.0 - 1.0
    }
    fn by_noisy_costs(frame_count: usize, count: usize, costs: &RemovalCosts) -> Vec<usize> {
        let noisy = |before, frame, after| {
            costs.of(before, frame, after) * (1.0 + 0.0024 * noise(before, frame, after))
        };
        solutions::keyframes::reduce(frame_count, count, &RemovalCosts::new(&noisy))
    }
    fn by_noisy_errors(before: usize, frame: usize, after: usize, errors: &FrameErrors) -> f64 {
        let noisy =
            |start, end, frame| errors.between(start, end, frame) * (1.0 + 0.0012 * noise(start, frame, end));
        solutions::keyframes::removal_cost(before, frame, after, &FrameErrors::new(&noisy))
    }
    let noisy_costs = KeyframesFunctions { reduce: by_noisy_costs, ..solutions::KEYFRAMES };
    let noisy_errors = KeyframesFunctions { removal_cost: by_noisy_errors, ..solutions::KEYFRAMES };
    for seed in (0..100).map(|n| n * 3001 + PUBLIC_SEED) {
        let exam = keyframes::exam(seed, &Solutions);
        for check in &report(&exam, 2, noisy_costs).checks[..2] {
            assert!(matches!(check.state, CheckState::Right), "seed {seed}: {check:?}");
        }
        assert!(trouble(&exam, noisy_errors).is_none(), "seed {seed}");
    }
}

#[test]
fn every_check_asks_something_and_the_same_seed_asks_the_same() {
    let questions = |exam: &Exam| -> Vec<exam::Question> {
        let cases = exam.parts.iter().flat_map(|part| &part.checks).flat_map(|check| &check.cases);
        cases.map(|case| case.question.clone()).chain([exam.whole_motion.question.clone()]).collect()
    };
    let exam = public();
    for check in exam.parts.iter().flat_map(|part| &part.checks) {
        assert!(check.cases.len() >= 3, "{} has {} cases", check.rubric.id, check.cases.len());
        let lines = check.cases.iter().flat_map(|case| &case.inputs);
        assert!(lines.clone().all(|(name, value)| name.len() <= 32 && value.chars().count() <= 64));
    }
    assert_eq!(questions(&exam), questions(&public()));
    assert_ne!(questions(&exam), questions(&keyframes::exam(PUBLIC_SEED + 1, &Solutions)));
}

#[test]
fn what_is_not_a_number_is_never_right() {
    let nan = KeyframesFunctions {
        pose_error: |_, _, _| f64::NAN,
        removal_cost: |_, _, _, _| f64::NAN,
        ..solutions::KEYFRAMES
    };
    let exam = public();
    for part in 0..2 {
        let report = report(&exam, part, nan);
        assert_eq!((report.state, report.points(), report.named.len()), (PartState::Wrong, 0, 0));
        let CheckState::Wrong(first) = &report.checks[2].state else { panic!("{report:?}") };
        assert!(first.difference.between.contains("not a number"), "{first:?}");
    }
    assert!(trouble(&exam, nan).is_some());
}

/// What is said about the first wrong case of the check about many removals.
fn said(reduce: fn(usize, usize, &RemovalCosts) -> Vec<usize>) -> String {
    let report = report(&public(), 2, KeyframesFunctions { reduce, ..solutions::KEYFRAMES });
    let CheckState::Wrong(first) = &report.checks[1].state else { panic!("{report:?}") };
    first.difference.between.clone()
}

#[test]
fn a_list_that_is_no_list_of_keyframes_is_told_as_such() {
    let backwards = said(|frames, count, costs| {
        let right = solutions::keyframes::reduce(frames, count, costs);
        right.into_iter().rev().collect()
    });
    assert!(backwards.starts_with("not in ascending order: 9 stands before "), "{backwards}");
    let from_one = said(|frames, count, costs| {
        let right = solutions::keyframes::reduce(frames, count, costs);
        right.into_iter().map(|frame| frame + 1).collect()
    });
    assert_eq!(from_one, "there is no frame 10: the last one is 9");
    assert_eq!(said(|_, _, _| vec![0, 0, 9]), "frame 0 is there twice");
    assert_eq!(said(|_, _, _| Vec::new()), "first different: 0 is missing; 0 keyframes instead of 6");
}

#[test]
fn wrong_cases_of_one_kind_are_pointed_out() {
    fn no_care_below_two(frame_count: usize, count: usize, costs: &RemovalCosts) -> Vec<usize> {
        if count == 1 { vec![0] } else { solutions::keyframes::reduce(frame_count, count, costs) }
    }
    let functions = KeyframesFunctions { reduce: no_care_below_two, ..solutions::KEYFRAMES };
    let report = report(&public(), 2, functions);
    let CheckState::Wrong(first) = &report.checks[3].state else { panic!("{report:?}") };
    assert_eq!(first.groups, ["fewer than two keyframes wanted"]);
}

#[test]
fn the_whole_motion_says_which_keyframes_came_and_which_should_have() {
    let exam = public();
    let functions = KeyframesFunctions { reduce: |frames, _, _| vec![0, frames - 1], ..solutions::KEYFRAMES };
    let Some(Trouble::Different { summary, details }) = trouble(&exam, functions) else { panic!() };
    assert!(!summary.contains(|c: char| c.is_ascii_digit()), "{summary}");
    assert_eq!(details[0], "Yours: 0, 19.");
    assert!(details[1].starts_with("Expected: 0, "), "{details:?}");
    assert!(details[2].starts_with("Difference: first different: 19 instead of "), "{details:?}");
    assert!(details[2].ends_with("; 2 keyframes instead of 6."), "{details:?}");
}

/// One misconception of each part shows in the whole motion, whatever the seed.
#[test]
fn the_whole_motion_is_no_easy_one() {
    for seed in (0..20).map(|n| n * 7919 + 1).chain([PUBLIC_SEED]) {
        let exam = keyframes::exam(seed, &Solutions);
        let ids = [("part1", "end_sites_only"), ("part2", "new_gap_only"), ("part3", "never_refreshed")];
        for (part, id) in ids {
            let all = keyframes::misconceptions(part);
            let wrong = &all.iter().find(|misconception| misconception.id == id).unwrap().variants[0];
            let report = marks::whole(&exam, *wrong);
            assert!(matches!(report.trouble, Some(Trouble::Different { .. })), "seed {seed}, {id}");
        }
    }
}
