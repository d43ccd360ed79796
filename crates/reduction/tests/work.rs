//! How much is done for a reduction: poses and costs are counted, and no time is measured.
#![allow(clippy::unwrap_used)] // Helpers of tests.

mod support;

use std::cell::Cell;

use glam::Vec3;
use reduction::{Errors, greedy, local_moves, optimum};
use skeleton::{Axis, Channel, Frame, RemovalCosts, Representation, Skeleton};
use solutions::keyframes::{Removals, reduce};
use support::{both, dance, dance_with_a_pause, go_on, noisy, posed_gap, running, still};

#[test]
fn the_runner_takes_at_most_thirty_thousand_poses() {
    for errors in both(&running()) {
        assert_eq!(errors.frame_count(), 1_377);
        assert_eq!(greedy(&errors, 20).len(), 20);
        let poses = errors.poses();
        // Each frame is posed at least once, when its own removal is looked at first.
        assert!((1_375..=30_000).contains(&poses), "{poses}");
    }
}

#[test]
fn a_still_motion_takes_no_pose() {
    let (skeleton, frames) = dance();
    for frames in [still(&frames[60], 5_508), noisy(&frames[60], 5_508)] {
        for errors in both(&(skeleton.clone(), frames)) {
            greedy(&errors, 2);
            assert_eq!(errors.of_frame(0, 5_507, 100), 0.0);
            assert_eq!(errors.poses(), 0);
        }
    }
}

#[test]
fn standing_still_takes_few_poses_wherever_a_motion_does_it() {
    const PAUSE: usize = 5_000;
    let (skeleton, frames) = dance();
    let [mut begins, mut ends] = [frames.clone(), frames.clone()];
    begins.splice(0..1, noisy(&frames[0], PAUSE));
    ends.splice(140..141, noisy(&frames[140], PAUSE));
    let within = dance_with_a_pause(PAUSE).1;
    for (place, paused) in [("first", begins), ("within", within), ("last", ends)] {
        for (errors, without) in both(&(skeleton.clone(), paused)).into_iter().zip(both(&dance())) {
            greedy(&errors, 40);
            greedy(&without, 40);
            // The pause itself is removed for nothing, or for a look at the frame before it each time. After that, a
            // few gaps over all of it are posed. Posing the gap before it again and again would take 12 million
            // poses.
            let more = errors.poses() - without.poses();
            assert!(more < 5 * PAUSE as u64, "{place}: {more}");
        }
    }
}

#[test]
fn a_removal_asks_for_two_costs() {
    for (name, errors) in motions_of_all_kinds() {
        let asked = Cell::new(0);
        let cost = |before, frame, after| {
            asked.set(asked.get() + 1);
            errors.cost(before, frame, after)
        };
        let frames = errors.frame_count();
        assert_eq!(Removals::new(frames, &RemovalCosts::new(&cost)).count(), frames - 2);
        // One for each frame at first, and those of both neighbours, as far as these can be removed, after each
        // removal. A heap of so many does about n log n steps.
        assert!((frames..=3 * frames).contains(&asked.get()), "{name}: {} {frames}", asked.get());
    }
}

#[test]
fn nothing_that_is_remembered_is_posed_again() {
    for (name, errors) in motions_of_all_kinds() {
        let cost = |before, frame, after| errors.cost(before, frame, after);
        let keyframes = reduce(errors.frame_count(), 20, &RemovalCosts::new(&cost));
        let poses = errors.poses();
        assert_eq!(reduce(errors.frame_count(), 20, &RemovalCosts::new(&cost)), keyframes);
        errors.of_keyframes(&keyframes);
        assert_eq!(errors.poses(), poses, "{name}");
        // Looking first at what costs nothing changes no keyframe.
        assert_eq!(greedy(&errors, 20), keyframes, "{name}");
    }
}

#[test]
fn nothing_is_posed_when_all_frames_stay() {
    for errors in both(&dance()) {
        greedy(&errors, 141);
        assert_eq!(errors.poses(), 0);
    }
}

#[test]
fn exact_costs_are_not_posed_when_enough_goes_for_nothing() {
    for errors in both(&dance_with_a_pause(1_000)) {
        assert_eq!(greedy(&errors, 1_000).len(), 1_000);
        // One for each frame that moves, and one for the frame before the pause after each removal.
        assert!(errors.poses() <= 140 + 140 + 4, "{}", errors.poses());
    }
}

#[test]
fn what_is_remembered_does_not_depend_on_why_it_was_posed() {
    for errors in both(&dance()) {
        let moved = local_moves(&errors, &[20, 40, 60, 100], &mut go_on);
        optimum(&errors, 10, None, &mut go_on);
        for start in 0..140 {
            for end in start + 1..141.min(start + 25) {
                assert_eq!(errors.of_gap(start, end), posed_gap(&errors, start, end), "{start} {end}");
            }
        }
        assert_eq!(
            errors.of_keyframes(&moved),
            moved.windows(2).fold(0.0, |sum, gap| sum + posed_gap(&errors, gap[0], gap[1]))
        );
    }
}

#[test]
fn what_is_remembered_is_bounded() {
    let mut skeleton = Skeleton::new();
    let root = skeleton.add_joint(None, "root", Vec3::ZERO, [Channel::Rotation(Axis::X)]).unwrap();
    skeleton.add_end_site(root, "End Site", Vec3::Y).unwrap();
    let frame = |index: u32| Frame {
        angles: vec![(index.pow(2) % 977) as f32, 0.0, 0.0],
        local_positions: vec![Vec3::ZERO, Vec3::Y],
    };
    let frames: Vec<Frame> = (0..60_000).map(frame).collect();
    let errors = Errors::new(&skeleton, &frames, Representation::Quaternion);
    let again = |start, end| {
        let poses = errors.poses();
        (errors.of_gap(start, end), errors.poses() - poses)
    };
    let first = errors.of_gap(0, 2);
    assert_eq!(again(0, 2), (first, 0));
    for start in 0..59_980 {
        for length in 2..11 {
            errors.of_gap(start, start + length);
        }
    }
    // Half a million gaps later this one is forgotten, and is what it was.
    assert_eq!(again(0, 2), (first, 1));
    assert_eq!(again(0, 2), (first, 0));
}

fn motions_of_all_kinds() -> Vec<(&'static str, Errors)> {
    let (skeleton, frames) = dance();
    let still = (skeleton.clone(), still(&frames[0], 1_000));
    let noisy = (skeleton, noisy(&frames[0], 1_000));
    let all = [("dance", dance()), ("pause", dance_with_a_pause(300)), ("still", still), ("noisy", noisy)];
    all.into_iter().flat_map(|(name, frames)| both(&frames).map(|errors| (name, errors))).collect()
}
