//! Misconceptions about where a new frame is in the old motion.

use super::ways;
use crate::Misconception;
use crate::time_warp::variants::place::{
    BothEndsKept, FewDigits, FromAfter, FromNext, GoesOn, LessAfter, MiddleOfFrames, NextPastTheEnd,
    OneOffNew, OneOffOld, PastTheEnd, Remainder, RemainderToNext, RoundAgain, Rounded, RoundedDown,
    RoundedTiesDown, RoundedUp, Share, ShareToNext, UpsideDown, UpsideDownHalfBound, UpsideDownUnbound,
    WholePlace, WholePlaceToNext, WholeRatio,
};

const ALL: &[&str] = &["slower", "faster", "last", "long"];

/// Where the frames on both sides are there. What is wrong at the end can be another mistake, and so can what is wrong with
/// large numbers.
const MIDDLE: &[&str] = &["slower", "faster"];

const LAST: &[&str] = &["last"];

pub(super) fn misconceptions() -> Vec<Misconception> {
    [about_the_mapping(), about_t(), about_the_end(), about_digits()].into_iter().flatten().collect()
}

fn about_the_mapping() -> Vec<Misconception> {
    vec![
        Misconception {
            id: "both_ends_kept",
            title: "Your mapping keeps both ends. It is a good one, but not the one that is asked for here.",
            explanation: "With (old count − 1) / (new count − 1) the last new frame is the last old one. Warped to twice as \
                          many frames and back, only the first and the last frame are what they were. Here a frame lasts \
                          as long as any other, the last one too, and all of them come back.",
            hint: "Warp 4 frames to 8 by hand, with both mappings. Which of the old frames are in the new motion?",
            seen_in: MIDDLE,
            costs: ALL,
            variants: ways![BothEndsKept],
        },
        Misconception {
            id: "middle_of_frames",
            title: "Your mapping takes frames by their middle. It is a good one, but not the one that is asked for here.",
            explanation: "Half a frame more before you multiply and half a frame less afterwards is how pictures are scaled, from \
                          the middle of a pixel to the middle of another. Warped to twice as many frames, none of the old ones \
                          would be in the new motion. Here a frame counts from where it begins.",
            hint: "Where is the new frame 0 in the old motion, with your mapping and with the one in the text?",
            seen_in: MIDDLE,
            costs: ALL,
            variants: ways![MiddleOfFrames],
        },
        Misconception {
            id: "one_count_less_one",
            title: "You take 1 off only one of the two counts.",
            explanation: "From the first frame to the last there is one step less than there are frames. A ratio of steps to \
                          frames is neither the one nor the other, and the motion gets a little too slow or too fast.",
            hint: "Warp a motion to as many frames as it has. Is each new frame the old one of the same number?",
            seen_in: MIDDLE,
            costs: ALL,
            variants: ways![OneOffOld, OneOffNew],
        },
        Misconception {
            id: "upside_down",
            title: "Your ratio is upside down.",
            explanation: "With more new frames than old ones, one step in the new motion is less than one step in the old. Yours \
                          is more: the motion gets faster where it should get slower.",
            hint: "From 4 frames to 8, how far does the place move from one new frame to the next?",
            seen_in: MIDDLE,
            costs: ALL,
            variants: ways![UpsideDown, UpsideDownUnbound, UpsideDownHalfBound],
        },
        Misconception {
            id: "ratio_cut",
            title: "You divide the two counts as whole numbers.",
            explanation: "Both are `usize`, so that 4 / 8 is 0 and 8 / 3 is 2. What is behind the point is gone before \
                          you multiply.",
            hint: "Of which type are the two numbers when you divide them?",
            seen_in: MIDDLE,
            costs: ALL,
            variants: ways![WholeRatio],
        },
    ]
}

fn about_t() -> Vec<Misconception> {
    vec![
        Misconception {
            id: "t_from_the_frame_after",
            title: "You count `t` from the wrong frame.",
            explanation: "`t` is how far the place is from the frame before. When it is close to that frame, `t` is close to 0.",
            hint: "At 2.25, which of the frames 2 and 3 is nearer? What is your `t` there?",
            seen_in: MIDDLE,
            costs: ALL,
            variants: ways![FromAfter, FromNext, LessAfter],
        },
        Misconception {
            id: "t_not_within_a_frame",
            title: "Your `t` does not go from 0 to 1 between one old frame and the next.",
            explanation: "At the frame before `t` is 0, and at the frame after it is 1, between any two old frames. So it begins \
                          anew at each of them, and is never above 1.",
            hint: "At 2.25, the frame before is 2. How far is it from there, and what is your `t`?",
            seen_in: MIDDLE,
            costs: ALL,
            variants: ways![WholePlace, WholePlaceToNext, Remainder, RemainderToNext, Share, ShareToNext,],
        },
        Misconception {
            id: "whole_frames_only",
            title: "You take one old frame whole.",
            explanation: "A place between two frames has something of both. With one of them alone the motion jerks: in slow \
                          motion every old frame stands for a while, and then the next one jumps in.",
            hint: "What is left of the place when you have taken the frame before off? Is it in your `t`?",
            seen_in: MIDDLE,
            costs: ALL,
            variants: ways![RoundedDown, Rounded, RoundedTiesDown, RoundedUp],
        },
    ]
}

fn about_the_end() -> Vec<Misconception> {
    vec![
        Misconception {
            id: "past_the_end",
            title: "Your frame after can be one that is not there.",
            explanation: "The last frame of 4 is number 3. A place after it has no frame after, and with the index 4 the \
                          program panics.",
            hint: "What does your function give for the last frame when a motion becomes twice as long?",
            seen_in: LAST,
            costs: LAST,
            variants: ways![PastTheEnd, NextPastTheEnd],
        },
        Misconception {
            id: "round_again",
            title: "After the last frame you go on with the first.",
            explanation: "That would be right for a motion that repeats itself. Here it stops: the figure would move half-way back \
                          to where it began, in the last moment.",
            hint: "What does the `%` do to the frame after the last one?",
            seen_in: LAST,
            costs: LAST,
            variants: ways![RoundAgain],
        },
        Misconception {
            id: "goes_on",
            title: "After the last frame you go on as between the two frames before.",
            explanation: "Your `t` is above 1 there, and a figure that goes on for longer than it was recorded goes where nobody \
                          has seen it. Where there is no frame after, the last frame stays.",
            hint: "What is your frame before, when the place is after the last one?",
            seen_in: LAST,
            costs: LAST,
            variants: ways![GoesOn],
        },
    ]
}

fn about_digits() -> Vec<Misconception> {
    const LONG: &[&str] = &["long"];
    vec![Misconception {
        id: "few_digits",
        title: "Your place has too few digits for long motions.",
        explanation: "An `f32` has about seven digits. A place of several millions needs them all in front of the point: hardly \
                      anything is left behind it, and the motion jerks.",
        hint: "Which type has more digits? Whole numbers lose none at all: what do `/` and `%` give for them?",
        seen_in: LONG,
        costs: LONG,
        variants: ways![FewDigits<0>, FewDigits<1>, FewDigits<2>, FewDigits<3>, FewDigits<4>],
    }]
}
