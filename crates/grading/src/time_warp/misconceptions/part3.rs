//! Misconceptions about the whole motion.

use super::ways;
use crate::Misconception;
use crate::time_warp::variants::blend::{
    AsTheyCome, Backwards, OnlyTheRootMoves, PackedAndUnpacked, ShorterAngles, StraightAngles, StraightLine,
    TranslationsStay,
};
use crate::time_warp::variants::place::{
    BothEndsKept, FromAfter, OneOffNew, OneOffOld, UpsideDown, WholeRatio,
};
use crate::time_warp::variants::warp::{
    CutOff, CutOrFilled, CutOrRepeated, FromOne, FromOneOneLess, HalfAndHalf, LastKept, OldCount, OneLess,
    OneMore, OneOldFrame, OnlyInWarp, WarpedToOneLess, WarpedToOneMore,
};

const ALL: &[&str] = &["longer", "shorter", "same", "few"];

/// Where places between old frames come up.
const BETWEEN: &[&str] = &["longer", "shorter"];

/// Motions that have several frames.
const SEVERAL: &[&str] = &["longer", "shorter", "same"];

pub(super) fn misconceptions() -> Vec<Misconception> {
    [about_how_many(), about_what_is_between()].into_iter().flatten().collect()
}

fn about_how_many() -> Vec<Misconception> {
    vec![
        Misconception {
            id: "one_off",
            title: "Your number of frames is off by one.",
            explanation: "The new motion has `new_count` frames, numbered from 0 to `new_count` − 1.",
            hint: "How often does your loop go round when `new_count` is 1? In Rust `0..n` ends before `n`, and `0..=n` with it.",
            // With few frames, what one too many is depends on part 1.
            seen_in: SEVERAL,
            costs: ALL,
            variants: ways![OneMore, OneLess, WarpedToOneMore, WarpedToOneLess],
        },
        Misconception {
            id: "begins_at_1",
            title: "You begin with the new frame number 1.",
            explanation: "Frames are counted from 0. Yours leave the first one out, so that the motion begins too late.",
            hint: "Which posture of the old motion should the first new one be, and which is yours?",
            seen_in: SEVERAL,
            costs: ALL,
            variants: ways![FromOne, FromOneOneLess],
        },
        Misconception {
            id: "old_count",
            title: "You make as many frames as the old motion has.",
            explanation: "The new motion has `new_count` frames, whatever the old one has. Yours breaks off when it is to have more, \
                          and stands still at its end when it is to have fewer.",
            hint: "Which frames does your loop go through, the new ones or the old ones?",
            seen_in: SEVERAL,
            costs: ALL,
            variants: ways![OldCount],
        },
        Misconception {
            id: "last_kept",
            title: "You let the new motion end with the last old frame.",
            explanation: "With fewer frames than before, the last new one lies before the last old one, as part 1 says. Who puts \
                          the last old frame there all the same lets the motion jump at its end.",
            hint: "Part 1 knows the place of the last new frame, too. Does it need another treatment than the others?",
            seen_in: BETWEEN,
            costs: &["shorter", "few"],
            variants: ways![LastKept],
        },
        Misconception {
            id: "cut_off",
            title: "You cut the motion off.",
            explanation: "The new frames are to be spread over the whole old motion: with more of them it becomes slower, and with \
                          fewer faster. Yours goes as fast as before, and never has more frames than before.",
            hint: "Which function of yours says where a new frame is in the old motion?",
            seen_in: SEVERAL,
            costs: ALL,
            variants: ways![CutOff],
        },
        Misconception {
            id: "cut_or_filled",
            title: "You cut the motion off, or fill it up with frames from the old one.",
            explanation: "The new frames are to be spread over the whole old motion: with more of them it becomes slower, and with \
                          fewer faster. Yours goes as fast as before, and ends too early or stands still.",
            hint: "Which function of yours says where a new frame is in the old motion?",
            seen_in: SEVERAL,
            costs: SEVERAL,
            variants: ways![CutOrFilled, CutOrRepeated],
        },
    ]
}

fn about_what_is_between() -> Vec<Misconception> {
    vec![
        Misconception {
            id: "not_blended",
            title: "You take one old frame for each new one, without blending.",
            explanation: "Between two old frames the new one has something of both. With one of them alone the motion jerks.",
            hint: "Part 1 gives two frames and a `t`. What have you got that makes one posture of these?",
            seen_in: SEVERAL,
            costs: BETWEEN,
            variants: ways![
                OnlyInWarp<OneOldFrame<0>>,
                OnlyInWarp<OneOldFrame<1>>,
                OnlyInWarp<OneOldFrame<2>>,
                OnlyInWarp<OneOldFrame<3>>,
            ],
        },
        Misconception {
            id: "half_and_half",
            title: "You blend half of one frame with half of the other, wherever the new frame is.",
            explanation: "That is right half-way between two old frames. The nearer a new frame is to one of them, the more it has of \
                          that one.",
            hint: "Part 1 gives two frames and a `t`. Where do you use the `t`?",
            seen_in: SEVERAL,
            costs: BETWEEN,
            variants: ways![OnlyInWarp<HalfAndHalf>],
        },
        Misconception {
            id: "warp_backwards",
            title: "You hand the two postures over in the wrong order.",
            explanation: "`t` counts from the frame before. With the frame after in its place, each new frame is mirrored between \
                          the two, and the motion goes forwards and backwards in turns.",
            hint: "In which order does part 2 take the two postures?",
            seen_in: SEVERAL,
            costs: BETWEEN,
            variants: ways![OnlyInWarp<FromAfter>, OnlyInWarp<Backwards<true, true>>],
        },
        Misconception {
            id: "warp_ratio_cut",
            title: "You divide the two counts as whole numbers.",
            explanation: "Both are `usize`, so that 4 / 8 is 0 and 8 / 3 is 2. What is behind the point is gone before \
                          you multiply. Your part 1 does better.",
            hint: "Which function of yours already knows where a new frame is?",
            seen_in: SEVERAL,
            costs: BETWEEN,
            variants: ways![OnlyInWarp<WholeRatio>],
        },
        Misconception {
            id: "other_places",
            title: "You look for the new frames in other places than your part 1 does.",
            explanation: "Part 1 says where a new frame is in the old motion. Here they are spread over it in another way, so that \
                          twice as many frames and back do not give the motion that there was.",
            hint: "Which function of yours already knows where a new frame is?",
            seen_in: SEVERAL,
            costs: SEVERAL,
            variants: ways![
                OnlyInWarp<BothEndsKept>,
                OnlyInWarp<OneOffOld>,
                OnlyInWarp<OneOffNew>,
                OnlyInWarp<UpsideDown>,
            ],
        },
        Misconception {
            id: "other_blend",
            title: "You blend postures otherwise than your part 2 does.",
            explanation: "Part 2 turns every bone the shorter way round, about one axis and at an even speed, and moves it on a \
                          straight line. Here one of these is different.",
            hint: "Which function of yours already knows what is between two postures?",
            seen_in: SEVERAL,
            costs: BETWEEN,
            variants: ways![
                OnlyInWarp<StraightAngles>,
                OnlyInWarp<ShorterAngles>,
                OnlyInWarp<StraightLine>,
                OnlyInWarp<AsTheyCome>,
                OnlyInWarp<PackedAndUnpacked<0, false, false, true>>,
                OnlyInWarp<TranslationsStay<0>>,
                OnlyInWarp<OnlyTheRootMoves<0>>,
            ],
        },
    ]
}
