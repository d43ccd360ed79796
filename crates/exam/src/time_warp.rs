//! The exercise on time warping: what can be asked of its three functions.

use std::mem;
use std::panic::{AssertUnwindSafe, catch_unwind};

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
    /// Part 3 by itself, for long motions. The answer is as long as is asked for: whoever asks chooses how much memory it
    /// takes, and [`Question::Warp`] takes twice as much.
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
        /// Frame by frame by the student's own parts 1 and 2; nothing where part 1 names a frame that is not there.
        by_parts: Option<Vec<Posture>>,
    },
    /// The new motion.
    Motion(Vec<Posture>),
    /// To a [`Question::Warp`] too: where part 1 names a frame that is not there, part 3 has panicked, and was asked for
    /// fewer frames, with which part 1 stays within the motion.
    Fewer {
        /// By part 3, of fewer frames than the old motion has.
        postures: Vec<Posture>,
        /// As many, frame by frame by the student's own parts 1 and 2.
        by_parts: Vec<Posture>,
    },
}

impl Question {
    /// Asks `functions`, here and now. A panic of theirs goes through.
    pub fn ask(&self, functions: &TimeWarpFunctions) -> Answer {
        match self {
            Question::Position { new_frame, old_count, new_count } => {
                Answer::Position((functions.old_position)(*new_frame, *old_count, *new_count))
            }
            Question::Blend { from, to, t } => Answer::Blend((functions.blend)(from, to, *t)),
            Question::Warp { postures, new_count } => warp(functions, postures, *new_count),
            Question::Motion { postures, new_count } => {
                Answer::Motion((functions.warp)(postures, *new_count))
            }
        }
    }

    /// More bytes than any honest answer to this question takes on the wire, or the largest number.
    pub(crate) fn answer_limit(&self) -> usize {
        // Three angles and three translations of 4 bytes.
        const PER_BONE: usize = 24;
        let bones = |posture: &Posture| posture.angles.len().max(posture.translations.len()) + 1;
        let motion = |postures: &[Posture], new_count: usize| {
            new_count.saturating_mul(postures.iter().map(bones).max().unwrap_or(1))
        };
        let all = match self {
            Question::Position { .. } => 1,
            Question::Blend { from, to, .. } => bones(from).max(bones(to)),
            Question::Warp { postures, new_count } => motion(postures, *new_count).saturating_mul(2),
            Question::Motion { postures, new_count } => motion(postures, *new_count),
        };
        all.saturating_mul(PER_BONE).saturating_add(1024)
    }
}

fn warp(functions: &TimeWarpFunctions, postures: &[Posture], new_count: usize) -> Answer {
    let to = |count: usize| (functions.warp)(postures, count);
    let by_parts = by_parts(functions, postures, new_count);
    if by_parts.is_some() {
        return Answer::Warp { postures: to(new_count), by_parts };
    }
    if let Some(postures) = caught(|| to(new_count)) {
        return Answer::Warp { postures, by_parts };
    }
    warp_to_fewer(functions, postures, new_count).unwrap_or_else(|| {
        // It panics once more: of several panics the last one is told.
        Answer::Warp { postures: to(new_count), by_parts }
    })
}

/// With one frame less than before, each of them is between two old ones: if part 1 says so, and part 3 does not panic
/// there too.
fn warp_to_fewer(functions: &TimeWarpFunctions, postures: &[Posture], new_count: usize) -> Option<Answer> {
    let fewer = new_count.min(postures.len()).saturating_sub(1);
    let by_parts = by_parts(functions, postures, fewer)?;
    let postures = caught(|| (functions.warp)(postures, fewer))?;
    Some(Answer::Fewer { postures, by_parts })
}

/// What a function gives; nothing if it panics.
fn caught<T>(function: impl FnOnce() -> T) -> Option<T> {
    // The payload can be anything, and dropping it can panic again.
    catch_unwind(AssertUnwindSafe(function)).map_err(mem::forget).ok()
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

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::*;
    use crate::wire::{self, Reply};

    /// The largest numbers that travel, and the smallest counts beside them.
    fn posture(bones: usize) -> Posture {
        Posture { angles: vec![[f32::MIN; 3]; bones], translations: vec![Vec3::MAX; bones] }
    }

    /// As much as can be answered: a list for every list that was sent.
    const FULL: TimeWarpFunctions = TimeWarpFunctions {
        old_position: |_, old_count, _| Between { before: old_count - 1, after: old_count - 1, t: -1e-30 },
        blend: |from, to, _| if from.angles.len() > to.angles.len() { from.clone() } else { to.clone() },
        warp: |postures, new_count| (0..new_count).map(|_| postures[postures.len() - 1].clone()).collect(),
    };

    #[test]
    fn no_honest_answer_is_too_long() {
        let mut questions = vec![Question::Position { new_frame: 0, old_count: usize::MAX, new_count: 1 }];
        for bones in [0, 1, 40, 200] {
            questions.push(Question::Blend { from: posture(bones), to: posture(bones / 2), t: 0.5 });
            for new_count in [0, 1, 300] {
                let postures = vec![posture(bones); 3];
                questions.push(Question::Warp { postures: postures.clone(), new_count });
                questions.push(Question::Motion { postures, new_count });
            }
        }
        for question in questions {
            let answer = crate::Answer::TimeWarp(question.ask(&FULL));
            let bytes = wire::to_bytes(&Reply::Answered(answer)).unwrap().len();
            let limit = question.answer_limit();
            assert!(bytes <= limit, "{bytes} bytes, at most {limit}");
        }
    }
}
