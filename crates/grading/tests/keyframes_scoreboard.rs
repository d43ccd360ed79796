//! The scoreboard of the exercise on keyframes, word for word. After a change,
//! `FK_LAB_BLESS=1 cargo test -p grading --test keyframes_scoreboard` writes the expected texts again: look at them before
//! you keep them.

#[path = "support/golden.rs"]
mod golden;

use exam::Functions;
use grading::keyframes;
use skeleton::{FrameErrors, KeyframesFunctions, Pose, RemovalCosts, Skeleton};

#[test]
fn not_started() {
    check("not_started", keyframes::TEMPLATE);
}

#[test]
fn all_right() {
    check("all_right", solutions::KEYFRAMES);
}

/// Three mistakes that are made often, one in each part.
#[test]
fn end_sites_only_new_gap_only_and_one_round() {
    fn end_sites(skeleton: &Skeleton, original: &Pose, interpolated: &Pose) -> f64 {
        let end_sites = skeleton.joints().iter().filter(|joint| joint.is_end_site);
        let squared = |a: &Pose, b: &Pose, id| f64::from(a[id].position.distance_squared(b[id].position));
        end_sites.map(|joint| squared(original, interpolated, joint.id)).sum()
    }
    fn new_gap(before: usize, _: usize, after: usize, errors: &FrameErrors) -> f64 {
        (before..after).map(|frame| errors.between(before, after, frame)).sum()
    }
    fn one_round(frame_count: usize, count: usize, costs: &RemovalCosts) -> Vec<usize> {
        let inner = 1..frame_count.saturating_sub(1);
        let mut by_cost: Vec<(f64, usize)> =
            inner.map(|frame| (costs.of(frame - 1, frame, frame + 1), frame)).collect();
        by_cost.sort_by(|a, b| a.0.total_cmp(&b.0));
        let kept = by_cost.iter().skip(frame_count.saturating_sub(count.max(2))).map(|(_, frame)| *frame);
        let mut kept: Vec<usize> = kept.chain([0, frame_count.saturating_sub(1)]).collect();
        kept.sort_unstable();
        kept.dedup();
        kept.truncate(frame_count);
        kept
    }
    check("often", KeyframesFunctions { pose_error: end_sites, removal_cost: new_gap, reduce: one_round });
}

#[test]
fn a_mistake_without_a_name_and_a_panic() {
    fn doubled(skeleton: &Skeleton, original: &Pose, interpolated: &Pose) -> f64 {
        2.0 * solutions::keyframes::pose_error(skeleton, original, interpolated)
    }
    fn panics(frame_count: usize, count: usize, costs: &RemovalCosts) -> Vec<usize> {
        assert!(count > 1, "how can {count} keyframes do?");
        let mut right = solutions::keyframes::reduce(frame_count, count, costs);
        right.reverse();
        right
    }
    let functions = KeyframesFunctions { pose_error: doubled, reduce: panics, ..solutions::KEYFRAMES };
    check("no_name_and_panic", functions);
}

fn check(name: &str, functions: KeyframesFunctions) {
    golden::check(&format!("keyframes_{name}"), Functions::keyframes(functions));
}
