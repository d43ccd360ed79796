//! The exercise on time warping: what can be asked of its three functions.

use serde::{Deserialize, Serialize};
use skeleton::acclaim::{Between, Posture, TimeWarpFunctions};

/// A question to one of the three functions.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Question {
    /// Part 1.
    Position {
        /// The frame of the new motion, from 0.
        new_frame: usize,
        /// How many frames the old motion has.
        old_count: usize,
        /// How many frames the new motion is to have.
        new_count: usize,
    },
    /// Part 2.
    Blend {
        /// One posture.
        from: Posture,
        /// The other one.
        to: Posture,
        /// How far it is from the one to the other.
        t: f32,
    },
    /// Part 3, and what parts 1 and 2 make of the same motion: a mistake in them is not to cost points again.
    Warp {
        /// The old motion.
        postures: Vec<Posture>,
        /// How many frames the new one is to have.
        new_count: usize,
    },
    /// Part 3 by itself, for long motions.
    Motion {
        /// The old motion.
        postures: Vec<Posture>,
        /// How many frames the new one is to have.
        new_count: usize,
    },
}

/// The answer to a [`Question`] of the same name.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Answer {
    /// Between which old frames.
    Position(Between),
    /// The posture.
    Blend(Posture),
    /// The new motion.
    Warp {
        /// By part 3.
        postures: Vec<Posture>,
        /// Frame by frame by the student's own parts 1 and 2; nothing where part 1 names frames that are not there.
        by_parts: Option<Vec<Posture>>,
    },
    /// The new motion.
    Motion(Vec<Posture>),
}

impl Question {
    /// Asks `functions`, here and now. A panic of theirs goes through.
    pub fn ask(&self, functions: &TimeWarpFunctions) -> Answer {
        match self {
            Question::Position { new_frame, old_count, new_count } => {
                Answer::Position((functions.old_position)(*new_frame, *old_count, *new_count))
            }
            Question::Blend { from, to, t } => Answer::Blend((functions.blend)(from, to, *t)),
            Question::Warp { postures, new_count } => {
                let warped = (functions.warp)(postures, *new_count);
                Answer::Warp { postures: warped, by_parts: by_parts(functions, postures, *new_count) }
            }
            Question::Motion { postures, new_count } => {
                Answer::Motion((functions.warp)(postures, *new_count))
            }
        }
    }

    /// More bytes than any honest answer to this question takes on the wire.
    pub(crate) fn answer_limit(&self) -> usize {
        // Three angles and three translations of 4 bytes.
        const PER_BONE: usize = 24;
        let bones = |posture: &Posture| posture.angles.len().max(posture.translations.len()) + 1;
        let all = match self {
            Question::Position { .. } => 1,
            Question::Blend { from, to, .. } => bones(from).max(bones(to)),
            Question::Warp { postures, new_count } => {
                2 * new_count.saturating_mul(postures.first().map_or(1, bones))
            }
            Question::Motion { postures, new_count } => {
                new_count.saturating_mul(postures.first().map_or(1, bones))
            }
        };
        all.saturating_mul(PER_BONE).saturating_add(1024)
    }
}

/// The motion that the student's own parts 1 and 2 make.
fn by_parts(functions: &TimeWarpFunctions, postures: &[Posture], new_count: usize) -> Option<Vec<Posture>> {
    if postures.is_empty() {
        return Some(Vec::new());
    }
    let posture = |frame| {
        let Between { before, after, t } = (functions.old_position)(frame, postures.len(), new_count);
        Some((functions.blend)(postures.get(before)?, postures.get(after)?, t))
    };
    (0..new_count).map(posture).collect()
}
