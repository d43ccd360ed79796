//! The three functions of the exercise on time warping, asked together.
#![allow(clippy::unwrap_used)] // Helpers of tests.

use std::time::Duration;

use exam::time_warp::{Answer, Question};
use exam::{Functions, InProcess, Subject};
use glam::Vec3;
use skeleton::acclaim::{Between, Posture, TimeWarpFunctions};

/// Some functions whose answers depend on all that they are given. Right answers have no place beside a worker.
const PLAIN: TimeWarpFunctions = TimeWarpFunctions {
    old_position: |new_frame, old_count, new_count| Between {
        before: new_frame % old_count,
        after: (new_frame + new_count) % old_count,
        t: 0.25,
    },
    blend: |from, to, t| Posture {
        angles: from.angles.iter().zip(&to.angles).map(|(a, b)| [a[0] + t, b[1], a[2] - b[2]]).collect(),
        translations: to.translations.clone(),
    },
    warp: |postures, new_count| (0..new_count).map(|frame| postures[frame % 2].clone()).collect(),
};

fn posture(number: f32) -> Posture {
    Posture {
        angles: vec![[number, 2.0 * number, -number], [0.5, number, 7.0]],
        translations: vec![Vec3::splat(number), Vec3::ZERO],
    }
}

fn motion(frames: u8) -> Vec<Posture> {
    (0..frames).map(|frame| posture(f32::from(frame))).collect()
}

fn warp(functions: &TimeWarpFunctions, frames: u8, new_count: usize) -> (Vec<Posture>, Option<Vec<Posture>>) {
    match (Question::Warp { postures: motion(frames), new_count }).ask(functions) {
        Answer::Warp { postures, by_parts } => (postures, by_parts),
        other => panic!("{other:?}"),
    }
}

#[test]
fn every_question_goes_to_its_function() {
    let position = Question::Position { new_frame: 5, old_count: 4, new_count: 6 };
    assert_eq!(position.ask(&PLAIN), Answer::Position(Between { before: 1, after: 3, t: 0.25 }));
    let blend = Question::Blend { from: posture(1.0), to: posture(2.0), t: 0.75 };
    assert_eq!(blend.ask(&PLAIN), Answer::Blend((PLAIN.blend)(&posture(1.0), &posture(2.0), 0.75)));
    let whole = Question::Motion { postures: motion(4), new_count: 3 };
    assert_eq!(whole.ask(&PLAIN), Answer::Motion(vec![posture(0.0), posture(1.0), posture(0.0)]));
}

#[test]
fn a_warp_comes_with_what_the_parts_make_of_it() {
    let (postures, by_parts) = warp(&PLAIN, 4, 6);
    assert_eq!(postures, (PLAIN.warp)(&motion(4), 6));
    let old = motion(4);
    let frame = |frame: usize| {
        let Between { before, after, t } = (PLAIN.old_position)(frame, 4, 6);
        (PLAIN.blend)(&old[before], &old[after], t)
    };
    assert_eq!(by_parts.unwrap(), (0..6).map(frame).collect::<Vec<_>>());
}

#[test]
fn questions_and_answers_come_through_as_they_are() {
    let questions = [
        Question::Position { new_frame: usize::MAX, old_count: 1, new_count: 0 },
        Question::Blend { from: posture(-1.5), to: posture(1e30), t: 0.1 },
        Question::Warp { postures: motion(3), new_count: 5 },
        Question::Warp { postures: Vec::new(), new_count: 0 },
        Question::Motion { postures: motion(2), new_count: 9 },
    ];
    let mut subject = InProcess(Functions::TimeWarp(PLAIN));
    for question in questions.map(exam::Question::TimeWarp) {
        let bytes = postcard::to_allocvec(&question).unwrap();
        assert_eq!(postcard::from_bytes::<exam::Question>(&bytes).unwrap(), question);
        let Ok(answer) = subject.ask(&question, Duration::ZERO) else { continue };
        let bytes = postcard::to_allocvec(&answer).unwrap();
        assert_eq!(postcard::from_bytes::<exam::Answer>(&bytes).unwrap(), answer);
    }
}

#[test]
fn a_part_1_that_leaves_the_motion_makes_none() {
    let absurd: [fn(usize, usize, usize) -> Between; 5] = [
        |_, old_count, _| Between { before: 0, after: old_count, t: 0.0 },
        |_, old_count, _| Between { before: old_count, after: 0, t: 1.0 },
        |_, _, _| Between { before: usize::MAX, after: usize::MAX, t: f32::NAN },
        |_, _, _| Between { before: usize::MAX, after: 0, t: 0.0 },
        // Only in one frame.
        |new_frame, _, _| Between { before: 0, after: if new_frame == 4 { 3 } else { 1 }, t: 0.0 },
    ];
    for (index, old_position) in absurd.into_iter().enumerate() {
        let (postures, by_parts) = warp(&TimeWarpFunctions { old_position, ..PLAIN }, 3, 5);
        assert_eq!((postures.len(), by_parts), (5, None), "{index}");
    }
}

/// As long as there are to be more frames than before.
const NEXT_FRAME: TimeWarpFunctions = TimeWarpFunctions {
    old_position: |new_frame, old_count, new_count| {
        let before = new_frame * old_count / new_count;
        Between { before, after: before + 1, t: 0.5 }
    },
    warp: |postures, new_count| {
        let frame = |frame| {
            let Between { before, after, t } = (NEXT_FRAME.old_position)(frame, postures.len(), new_count);
            (NEXT_FRAME.blend)(&postures[before], &postures[after], t)
        };
        (0..new_count).map(frame).collect()
    },
    ..PLAIN
};

#[test]
fn a_part_3_that_panics_where_part_1_leaves_the_motion_is_asked_for_fewer_frames() {
    let ask = |functions: TimeWarpFunctions, frames, new_count| {
        let question = Question::Warp { postures: motion(frames), new_count };
        InProcess(Functions::TimeWarp(functions))
            .ask(&exam::Question::TimeWarp(question), Duration::ZERO)
            .map_err(|failure| failure.to_string())
    };
    for (frames, new_count, fewer) in [(4, 6, 3), (4, 4, 3), (1, 1, 0), (1, 9, 0)] {
        let answer = ask(NEXT_FRAME, frames, new_count).unwrap();
        let exam::Answer::TimeWarp(Answer::Fewer { postures, by_parts }) = answer else {
            panic!("{answer:?}")
        };
        assert_eq!((postures.len(), &postures), (fewer, &by_parts), "{frames} {new_count}");
    }
    assert!(matches!(ask(NEXT_FRAME, 4, 3), Ok(exam::Answer::TimeWarp(Answer::Warp { .. }))));
    // A panic that has nothing to do with part 1, and a part 1 that always leaves the motion.
    let panics = TimeWarpFunctions { warp: |_, new_count| panic!("no {new_count} frames"), ..NEXT_FRAME };
    assert!(ask(panics, 4, 6).unwrap_err().contains("no 6 frames"));
    let old_position = |_, old_count, _| Between { before: 0, after: old_count, t: 0.5 };
    assert!(ask(TimeWarpFunctions { old_position, ..panics }, 4, 6).unwrap_err().contains("no 6 frames"));
}

#[test]
fn of_a_motion_without_frames_nothing_is_made() {
    let functions = TimeWarpFunctions {
        old_position: |_, _, _| panic!("there is no frame to be at"),
        warp: |_, _| Vec::new(),
        ..PLAIN
    };
    assert_eq!(warp(&functions, 0, 1000), (Vec::new(), Some(Vec::new())));
}

/// A count that no memory holds is asked for by nobody here. But what is made of the parts ends where they leave the motion,
/// and takes no memory before it is made.
#[test]
fn a_huge_count_is_given_up_at_the_first_frame_that_is_not_there() {
    let functions = TimeWarpFunctions {
        old_position: |new_frame, _, _| Between { before: new_frame, after: new_frame, t: 0.0 },
        warp: |postures, _| postures.to_vec(),
        ..PLAIN
    };
    let (postures, by_parts) = warp(&functions, 3, usize::MAX);
    assert_eq!((postures.len(), by_parts), (3, None));
}
