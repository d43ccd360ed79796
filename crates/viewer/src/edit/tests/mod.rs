//! What is made of a wish, here and now and on the engine's thread.

mod engine;

use std::ops::ControlFlow;
use std::sync::Arc;

use exam::Failure;
use exam::keyframes::Reduction;
use glam::Vec3;
use proptest::prelude::*;
use skeleton::{LocalPose, Motion, Pose, PositionChannels, Representation, Skeleton};

use super::*;
use crate::motion::stage::{Stage, tips};
use crate::samples;

fn stage(frames: usize) -> Arc<Stage> {
    Arc::new(Stage::new(samples::chain(frames, 1.0), PositionChannels::Replace))
}

fn wish(keys: Keys) -> Wish {
    Wish { representation: Representation::Euler, keys, curves: false }
}

fn go_on(_: usize, _: usize) -> ControlFlow<()> {
    ControlFlow::Continue(())
}

fn edited(stage: &Stage, wish: &Wish) -> Edited {
    perform(&mut ReferenceHand::default(), stage, wish, &mut go_on).unwrap()
}

fn reduced(hand: &mut ReferenceHand, stage: &Stage, count: usize) -> Reduction {
    hand.reduce(stage, Representation::Euler, &[count], &mut go_on).unwrap().remove(0)
}

/// The sum of the squared distances of the tips of two poses.
fn error(stage: &Stage, a: &Pose, b: &Pose) -> f64 {
    let place = |pose: &Pose, tip: usize| pose.transforms()[tip].position;
    let tips = tips(stage.motion().skeleton().joints());
    tips.into_iter().map(|tip| f64::from(place(a, tip).distance_squared(place(b, tip)))).sum()
}

#[test]
fn of_a_stretch_the_frames_between_its_ends_are_interpolated_and_no_others() {
    let stage = stage(30);
    for representation in Representation::ALL {
        let wish = Wish { representation, ..wish(Keys::Ends(5, 20)) };
        let edited = edited(&stage, &wish);
        assert_eq!((&edited.wish, &edited.keyframes[..], edited.interpolated), (&wish, &[5, 20][..], 14));
        let mut sum = 0.0;
        for frame in 0..30 {
            let between = (6..20).contains(&frame);
            assert_eq!(edited.pose(frame).is_some(), between, "{frame}");
            let own = edited.pose(frame).map_or(0.0, |pose| error(&stage, pose, &stage.reference(frame)));
            assert_eq!(edited.error_of(frame), own);
            sum += own;
        }
        assert!(edited.error > 0.0 && (edited.error / sum - 1.0).abs() < 1e-9);
        // Two tips in 16 frames, the keyframes among them.
        assert!((edited.distance.powi(2) * 32.0 / sum - 1.0).abs() < 1e-9);
        assert!(edited.curves.is_none());
    }
}

#[test]
fn halfway_of_a_stretch_the_root_is_halfway() {
    let stage = stage(11);
    let edited = edited(&stage, &wish(Keys::Ends(0, 10)));
    let root = |pose: &Pose| pose.transforms()[0].position;
    let middle = root(&stage.reference(0)).midpoint(root(&stage.reference(10)));
    assert!(root(edited.pose(5).unwrap()).distance(middle) < 1e-6);
}

#[test]
fn automatic_keyframes_are_as_many_as_were_wanted_and_those_of_the_reference() {
    let stage = stage(40);
    for count in [2, 3, 7, 39, 40] {
        let edited = edited(&stage, &wish(Keys::Automatic(count)));
        assert_eq!((edited.keyframes.len(), edited.interpolated), (count, 40 - count));
        let reduction = reduced(&mut ReferenceHand::default(), &stage, count);
        assert_eq!(edited.keyframes, reduction.keyframes);
        assert!((edited.error - reduction.error).abs() <= 1e-5 * (1.0 + reduction.error), "{count}");
    }
}

#[test]
fn what_is_no_number_has_no_root_and_what_rounding_brings_below_0_has() {
    assert_eq!(
        [(18.0, 2), (-1e-9, 3), (0.0, 0)].map(|(error, places)| root_mean_square(error, places)),
        [3.0, 0.0, 0.0]
    );
    assert!(root_mean_square(f64::NAN, 3).is_nan());
}

#[test]
fn short_motions_and_odd_wishes_give_the_obvious() {
    for frames in 0..4 {
        let stage = stage(frames);
        let all = [0, 1, 2, 3, 20, usize::MAX].map(Keys::Automatic);
        let stretches = [(0, 0), (2, 2), (2, 0), (0, 9), (7, 9), (usize::MAX, usize::MAX)];
        for keys in all.into_iter().chain(stretches.map(|(start, end)| Keys::Ends(start, end))) {
            let edited = edited(&stage, &Wish { curves: true, ..wish(keys) });
            assert!(edited.keyframes.iter().all(|frame| *frame < frames), "{keys:?} of {frames}");
            let most = frames.saturating_sub(2);
            assert!(edited.interpolated <= most && edited.error >= 0.0 && edited.distance.is_finite());
            assert_eq!(edited.curves.unwrap().errors(Representation::Euler).len(), most + 1);
            assert!(
                edited.frames.poses.iter().filter(|pose| !pose.is_empty()).count() == edited.interpolated
            );
        }
    }
}

#[test]
fn curves_begin_with_no_error_and_lead_to_the_present_one() {
    let stage = stage(40);
    let mut hand = ReferenceHand::default();
    for representation in Representation::ALL {
        let wish = Wish { representation, keys: Keys::Automatic(10), curves: true };
        let edited = perform(&mut hand, &stage, &wish, &mut go_on).unwrap();
        let errors = edited.curves.as_ref().unwrap().errors(representation);
        assert_eq!((errors[0], errors.len()), (0.0, 39));
        assert!((errors[30] - edited.error).abs() <= 1e-5 * (1.0 + edited.error));
    }
}

#[test]
fn another_motion_is_not_taken_for_the_one_before() {
    let mut hand = ReferenceHand::default();
    for (frames, scale) in [(30, 1.0), (30, 2.0), (20, 2.0)] {
        let stage = Stage::new(samples::chain(frames, scale), PositionChannels::Replace);
        let used = reduced(&mut hand, &stage, 6);
        let fresh = reduced(&mut ReferenceHand::default(), &stage, 6);
        assert_eq!(used, fresh);
    }
}

#[test]
fn a_motion_with_too_many_poses_says_so_and_a_stretch_of_it_is_edited() {
    let mut skeleton = Skeleton::new();
    for _ in 0..4_000 {
        skeleton.add_joint(None, "j", Vec3::Y, []).unwrap();
    }
    let motion = Motion::new(skeleton, 1_500, 0.1, Vec::new()).unwrap();
    let stage = Stage::new(motion, PositionChannels::Replace);
    let perform = |wish: &Wish| perform(&mut ReferenceHand::default(), &stage, wish, &mut go_on);
    for keys in [Keys::Automatic(20), Keys::Ends(0, 1_499)] {
        let refused = perform(&wish(keys)).unwrap_err();
        assert_eq!(refused, NotEdited::TooLong { frames: 1_500, joints: 4_000 });
        let words = refused.to_string();
        assert!(
            words.contains("1500 frames of 4000 joints") && words.contains("at most 1000 frames"),
            "{words}"
        );
    }
    let stretch = perform(&Wish { curves: true, ..wish(Keys::Ends(100, 110)) }).unwrap();
    assert_eq!((stretch.interpolated, stretch.error, stretch.curves.is_none()), (9, 0.0, true));
}

/// Gives what it was made with, whatever it is asked.
struct Says(Vec<Reduction>, Vec<LocalPose>);

impl Hand for Says {
    fn reduce(
        &mut self,
        _: &Stage,
        _: Representation,
        _: &[usize],
        _: Progress,
    ) -> Result<Vec<Reduction>, Failure> {
        Ok(self.0.clone())
    }

    fn between(
        &mut self,
        _: &Stage,
        _: Representation,
        _: usize,
        _: usize,
        _: Progress,
    ) -> Result<Vec<LocalPose>, Failure> {
        match self.1.is_empty() {
            true => Err(Failure::Panicked { message: "not today".into(), location: None }),
            false => Ok(self.1.clone()),
        }
    }
}

#[test]
fn answers_that_are_none_are_told() {
    let stage = stage(5);
    let says = |keyframes: &[usize], locals: Vec<LocalPose>| {
        let reduction = Reduction { keyframes: keyframes.to_vec(), error: 0.0 };
        let mut hand = Says(vec![reduction], locals);
        perform(&mut hand, &stage, &wish(Keys::Automatic(3)), &mut go_on).unwrap_err().to_string()
    };
    for keyframes in [&[0, 3, 2, 4][..], &[0, 2], &[1, 4], &[], &[0, 2, 2, 4], &[0, 2, 9]] {
        let words = says(keyframes, Vec::new());
        assert!(words.contains("no keyframes from frame 0 to frame 4"), "{words}");
        assert!(words.contains(&format!("{keyframes:?}")), "{words}");
    }
    let local =
        |joints| LocalPose { rotations: vec![glam::Quat::NAN; joints], positions: vec![Vec3::Y; joints] };
    assert!(says(&[0, 2, 4], Vec::new()).contains("not today"));
    assert!(says(&[0, 2, 4], vec![local(5); 2]).contains("2 frames came back instead of 1"));
    assert!(
        says(&[0, 2, 4], vec![local(3)]).contains("3 rotations and 3 positions: the skeleton has 5 joints")
    );
    let mut none = Says(Vec::new(), Vec::new());
    assert!(perform(&mut none, &stage, &wish(Keys::Automatic(3)), &mut go_on).is_err());
    let odd = perform(&mut Says(Vec::new(), vec![local(5); 3]), &stage, &wish(Keys::Ends(0, 4)), &mut go_on);
    assert!(odd.unwrap().error.is_nan());
}

#[test]
fn work_that_is_broken_off_gives_nothing() {
    let stage = stage(20);
    for keys in [Keys::Automatic(5), Keys::Ends(0, 19)] {
        let wanted = Wish { curves: true, ..wish(keys) };
        let mut steps = 0;
        let mut count = |_, _| {
            steps += 1;
            ControlFlow::Continue(())
        };
        perform(&mut ReferenceHand::default(), &stage, &wanted, &mut count).unwrap();
        for left in [0, 1, steps / 2, steps - 1] {
            let mut left = left;
            let mut stop = |_, _| match left {
                0 => ControlFlow::Break(()),
                _ => {
                    left -= 1;
                    ControlFlow::Continue(())
                }
            };
            let result = perform(&mut ReferenceHand::default(), &stage, &wanted, &mut stop);
            assert_eq!(result.unwrap_err(), NotEdited::BrokenOff);
        }
    }
}

proptest! {
    #[test]
    fn a_flash_lasts_its_span_from_each_keyframe_on(
        mut keyframes in prop::collection::btree_set(0usize..60, 0..8), span in 0usize..9, frame in 0usize..70,
        last in 0usize..60,
    ) {
        keyframes.insert(last);
        let edited = Edited { keyframes: keyframes.iter().copied().collect(), ..edited(&stage(3), &wish(Keys::Automatic(2))) };
        let passed = |ahead: bool| keyframes.iter().any(|keyframe| {
            let since = if ahead { keyframe.checked_sub(frame) } else { frame.checked_sub(*keyframe) };
            since.is_some_and(|since| since < span.max(1))
        });
        prop_assert_eq!(edited.is_at_keyframe(frame, span, false), passed(false));
        prop_assert_eq!(edited.is_at_keyframe(frame, span, true), passed(true));
    }
}
