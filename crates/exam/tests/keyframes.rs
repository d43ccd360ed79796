//! The three functions of the exercise on keyframes, asked together.
#![allow(clippy::unwrap_used)] // Helpers of tests.

use std::cell::{Cell, RefCell};

use exam::keyframes::{Answer, Question, Reduction};
use exam::{Functions, InProcess, Subject};
use glam::Vec3;
use skeleton::{Clip, Frame, FrameErrors, KeyframesFunctions, Pose, RemovalCosts, Representation, Skeleton};

/// How far the only joint is off, squared.
fn squared(_: &Skeleton, original: &Pose, interpolated: &Pose) -> f64 {
    let place = |pose: &Pose| pose.transforms()[0].position;
    f64::from(place(original).distance_squared(place(interpolated)))
}

fn growth(before: usize, frame: usize, after: usize, errors: &FrameErrors) -> f64 {
    let gap = |start, end| (start..=end).map(|i| errors.between(start, end, i)).sum::<f64>();
    gap(before, after) - gap(before, frame) - gap(frame, after)
}

/// Looks at all costs again and again.
fn greedy(frame_count: usize, count: usize, costs: &RemovalCosts) -> Vec<usize> {
    let mut keyframes: Vec<usize> = (0..frame_count).collect();
    while keyframes.len() > count.max(2) {
        let cost = |place: &usize| costs.of(keyframes[place - 1], keyframes[*place], keyframes[place + 1]);
        let best = (1..keyframes.len() - 1).min_by(|a, b| cost(a).total_cmp(&cost(b)));
        keyframes.remove(best.unwrap());
    }
    keyframes
}

type Reduce = fn(usize, usize, &RemovalCosts) -> Vec<usize>;

const RIGHT: KeyframesFunctions =
    KeyframesFunctions { pose_error: squared, removal_cost: growth, reduce: greedy };

/// Where the joint is in each frame.
const PLACES: [f32; 9] = [0.0, 1.0, 5.0, 6.0, 2.0, 4.5, -3.0, -2.5, 1.0];

/// Where it would be between two keyframes: on a straight line.
fn between(start: usize, end: usize, frame: usize) -> f32 {
    let t = (frame - start) as f32 / (end - start) as f32;
    PLACES[start] + t * (PLACES[end] - PLACES[start])
}

fn pose(place: f32) -> Pose {
    let mut pose = Pose::identity(1);
    pose[skeleton::JointId(0)].position = Vec3::new(place, 0.0, 0.0);
    pose
}

fn joint() -> Skeleton {
    let mut skeleton = Skeleton::new();
    skeleton.add_joint(None, "Hips", Vec3::ZERO, Vec::new()).unwrap();
    skeleton
}

/// All three functions over those places.
fn chain(count: usize) -> Question {
    let mut poses = Vec::new();
    for start in 0..PLACES.len() {
        for frame in start + 1..PLACES.len() {
            poses.extend((frame + 1..PLACES.len()).map(|end| pose(between(start, end, frame))));
        }
    }
    Question::Chain { skeleton: joint(), originals: PLACES.map(pose).into(), between: poses, count }
}

/// What the three give when they are put together by hand.
fn by_hand(functions: &KeyframesFunctions, count: usize) -> Vec<usize> {
    let error = |start, end, frame: usize| {
        (functions.pose_error)(&joint(), &pose(PLACES[frame]), &pose(between(start, end, frame)))
    };
    let errors = FrameErrors::new(&error);
    let cost = |before, frame, after| (functions.removal_cost)(before, frame, after, &errors);
    (functions.reduce)(PLACES.len(), count, &RemovalCosts::new(&cost))
}

#[test]
fn a_chain_is_what_the_three_functions_make_of_one_another() {
    let from_the_origin = |_: &Skeleton, original: &Pose, _: &Pose| squared(&joint(), original, &pose(0.0));
    let first = |before, frame, after, errors: &FrameErrors| errors.between(before, after, frame);
    let last = |frames: usize, count: usize, costs: &RemovalCosts| {
        let dear = (1..frames - 1).filter(|frame| costs.of(0, *frame, frames - 1) > 20.0);
        dear.take(count).collect()
    };
    let wrong: [KeyframesFunctions; 3] = [
        KeyframesFunctions { pose_error: from_the_origin, ..RIGHT },
        KeyframesFunctions { removal_cost: first, ..RIGHT },
        KeyframesFunctions { reduce: last, ..RIGHT },
    ];
    for count in 0..11 {
        for functions in [RIGHT].iter().chain(&wrong) {
            let expected = by_hand(functions, count);
            assert_eq!(chain(count).ask(functions, None), Answer::Reduce(expected), "{count}");
        }
    }
    // These would not be told apart if one of the three were not asked.
    let is_other = |functions| (3..8).any(|count| by_hand(functions, count) != by_hand(&RIGHT, count));
    assert!(wrong.iter().all(is_other));
}

/// A clip made of the frames' first local positions.
struct Places(Vec<f32>);

thread_local! {
    /// What clips were asked for: start, end, frame.
    static ASKED: RefCell<Vec<(usize, usize, usize)>> = const { RefCell::new(Vec::new()) };
}

impl Clip for Places {
    fn frame_count(&self) -> usize {
        self.0.len()
    }

    fn original(&self, frame: usize, into: &mut Pose) {
        *into = pose(self.0[frame]);
    }

    fn between(&self, start: usize, end: usize, frame: usize, into: &mut Pose) {
        ASKED.with_borrow_mut(|asked| asked.push((start, end, frame)));
        *into = pose(between(start, end, frame));
    }
}

fn places(_: &Skeleton, frames: &[Frame], _: Representation) -> Box<dyn Clip> {
    Box::new(Places(frames.iter().map(|frame| frame.local_positions[0].x).collect()))
}

fn motion(counts: &[usize]) -> Question {
    let frame = |place| Frame { angles: Vec::new(), local_positions: vec![Vec3::new(place, 0.0, 0.0)] };
    Question::Motion {
        skeleton: joint(),
        frames: PLACES.map(frame).into(),
        representation: Representation::Quaternion,
        counts: counts.into(),
    }
}

fn reductions(functions: &KeyframesFunctions, counts: &[usize]) -> Vec<Reduction> {
    match motion(counts).ask(functions, Some(places)) {
        Answer::Motion(reductions) => reductions,
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_motion_is_reduced_once_for_each_number() {
    let counts = [9, 4, 2, 20];
    let reductions = reductions(&RIGHT, &counts);
    assert_eq!(reductions.len(), counts.len());
    for (count, reduction) in counts.into_iter().zip(&reductions) {
        assert_eq!(reduction.keyframes, by_hand(&RIGHT, count));
        let gaps = reduction.keyframes.windows(2);
        let error = |start, end, frame: usize| f64::from(between(start, end, frame) - PLACES[frame]).powi(2);
        let errors = gaps.flat_map(|gap| (gap[0] + 1..gap[1]).map(|frame| error(gap[0], gap[1], frame)));
        assert!((reduction.error - errors.sum::<f64>()).abs() < 1e-5, "{count}: {reduction:?}");
    }
    assert_eq!(reductions[0].error, 0.0);
    assert!(reductions[2].error > reductions[1].error && reductions[1].error > 0.0);
}

/// An algorithm that looks at all costs again and again wants the same errors each time.
#[test]
fn the_error_of_a_frame_in_a_gap_is_asked_for_once() {
    thread_local! {
        static ERRORS: Cell<usize> = const { Cell::new(0) };
        static COSTS: Cell<usize> = const { Cell::new(0) };
    }
    fn counted_error(skeleton: &Skeleton, original: &Pose, interpolated: &Pose) -> f64 {
        ERRORS.set(ERRORS.get() + 1);
        squared(skeleton, original, interpolated)
    }
    fn counted_cost(before: usize, frame: usize, after: usize, errors: &FrameErrors) -> f64 {
        COSTS.set(COSTS.get() + 1);
        growth(before, frame, after, errors)
    }
    let counted = KeyframesFunctions { pose_error: counted_error, removal_cost: counted_cost, ..RIGHT };
    reductions(&counted, &[2, 3, 4]);
    let mut asked = ASKED.take();
    asked.sort_unstable();
    assert!(asked.windows(2).all(|pair| pair[0] != pair[1]), "{asked:?}");
    assert_eq!(ERRORS.get(), asked.len());
    assert!(COSTS.get() > 2 * asked.len(), "{} costs, {} errors", COSTS.get(), asked.len());
}

#[test]
fn what_is_no_list_of_keyframes_has_no_error() {
    let wrong: [Reduce; 6] = [
        |_, _, _| Vec::new(),
        |frames, _, _| (1..frames).collect(),
        |frames, _, _| (0..frames - 1).collect(),
        |frames, _, _| vec![0, 3, 3, frames - 1],
        |frames, _, _| vec![0, 5, 3, frames - 1],
        |frames, _, _| vec![0, frames, frames - 1],
    ];
    for (index, reduce) in wrong.into_iter().enumerate() {
        let reductions = reductions(&KeyframesFunctions { reduce, ..RIGHT }, &[4]);
        assert!(reductions[0].error.is_nan(), "{index}: {reductions:?}");
    }
}

#[test]
fn errors_of_frames_that_are_not_there_are_no_numbers() {
    let beyond = |frames: usize, _: usize, costs: &RemovalCosts| {
        let cost = costs.of(frames - 1, frames, frames + 7);
        if cost.is_nan() { vec![0, frames - 1] } else { Vec::new() }
    };
    let reductions = reductions(&KeyframesFunctions { reduce: beyond, ..RIGHT }, &[2]);
    assert_eq!(reductions[0].keyframes, [0, 8]);
}

/// A process that marks has no clips: it is not asked about whole motions.
#[test]
fn without_clips_a_motion_has_no_reductions() {
    assert_eq!(motion(&[2, 3]).ask(&RIGHT, None), Answer::Motion(Vec::new()));
    let mut subject = InProcess(Functions::keyframes(RIGHT).with_clips(places));
    let question = exam::Question::Keyframes(motion(&[2, 3]));
    let answer = subject.ask(&question, std::time::Duration::ZERO);
    assert_eq!(answer, Ok(exam::Answer::Keyframes(Answer::Motion(reductions(&RIGHT, &[2, 3])))));
}
