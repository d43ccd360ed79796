//! Misconceptions about what it costs to remove a keyframe.

use super::{Cost, wrong_in_part2};
use crate::Misconception;
use crate::keyframes::variants::cost;

const ALL: &[&str] = &["first", "gap", "lower", "edges"];
/// Where there are other frames between the keyframes.
const GAPS: &[&str] = &["gap", "lower", "edges"];

pub(super) fn misconceptions() -> Vec<Misconception> {
    [about_the_old_errors(), about_the_frames()].into_iter().flatten().collect()
}

fn about_the_old_errors() -> Vec<Misconception> {
    vec![
        Misconception {
            id: "new_gap_only",
            title: "You give the error of the new gap and not the growth.",
            explanation: "Frames beside the removed one were interpolated before, too, and had errors then. The accumulated \
                          error grows only by what is added to these.",
            hint: "What is the accumulated error of these frames before the removal, and what is it after?",
            seen_in: GAPS,
            costs: GAPS,
            variants: vec![wrong_in_part2(cost::new_gap)],
        },
        Misconception {
            id: "one_old_gap",
            title: "You take the old errors away on one side only.",
            explanation: "A removal closes two gaps: the one before the keyframe and the one after it. The frames in both had \
                          errors up to now.",
            hint: "Between which two pairs of keyframes were frames interpolated before the removal?",
            seen_in: GAPS,
            costs: GAPS,
            variants: [cost::without_the_old_before as Cost, cost::without_the_old_after]
                .map(wrong_in_part2)
                .into(),
        },
        Misconception {
            id: "old_errors_added",
            title: "You add the old errors instead of taking them away.",
            explanation: "The old errors are part of the accumulated error before the removal. What grows is the difference of \
                          after and before.",
            hint: "If nothing at all changed by a removal, what should it cost, and what would your function say?",
            seen_in: GAPS,
            costs: GAPS,
            variants: vec![wrong_in_part2(cost::old_added)],
        },
        Misconception {
            id: "sign_reversed",
            title: "Your sign is reversed.",
            explanation: "A cost says by how much the error grows. You take the new errors from the old ones, so that a removal \
                          that does harm looks like a gain.",
            hint: "When all frames are keyframes no frame has an error. Can the first removal make that less?",
            seen_in: ALL,
            costs: ALL,
            variants: vec![wrong_in_part2(cost::reversed)],
        },
        Misconception {
            id: "never_negative",
            title: "You do not let a cost be negative.",
            explanation: "A keyframe that lies far from its surroundings pulls the frames beside it away from where they should \
                          be. Without it they can do better, and the accumulated error becomes less: the cost is below 0.",
            hint: "Look for an absolute value, or for a largest of 0 and something.",
            seen_in: &["gap", "lower"],
            costs: &["lower"],
            variants: [cost::absolute as Cost, cost::at_least_zero].map(wrong_in_part2).into(),
        },
    ]
}

fn about_the_frames() -> Vec<Misconception> {
    vec![
        Misconception {
            id: "removed_frame_only",
            title: "You look at the removed frame only.",
            explanation: "When a keyframe goes, all frames of the new gap are interpolated between other keyframes than before, \
                          and their errors change too.",
            hint: "Which frames lie between `before` and `after`, and between which keyframes was each interpolated up to now?",
            seen_in: GAPS,
            costs: GAPS,
            variants: vec![wrong_in_part2(cost::removed_frame)],
        },
        Misconception {
            id: "removed_frame_forgotten",
            title: "You leave the removed frame itself out.",
            explanation: "Up to now the frame was a keyframe and had no error. From now on it is interpolated like the others, \
                          and its error is part of the growth.",
            hint: "With nothing but `frame` between `before` and `after`, what does your function add up?",
            seen_in: ALL,
            costs: ALL,
            variants: vec![wrong_in_part2(cost::removed_frame_forgotten)],
        },
        Misconception {
            id: "gap_cut_short",
            title: "You leave out a frame at the end of a gap.",
            explanation: "Between the keyframes 2 and 5 lie the frames 3 and 4, and both count. In Rust `a..b` begins with `a` \
                          and ends just before `b`.",
            hint: "Write down which frames your loop visits when `before` is 2 and `after` is 4.",
            seen_in: ALL,
            costs: ALL,
            variants: [
                cost::gaps_cut::<true> as Cost,
                cost::gaps_cut::<false>,
                cost::new_gap_cut::<true>,
                cost::new_gap_cut::<false>,
            ]
            .map(wrong_in_part2)
            .into(),
        },
    ]
}
