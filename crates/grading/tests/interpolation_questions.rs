//! What the questions on interpolation are chosen for: the traps show in them, and no answer is a matter of taste. In a
//! motion in which everything moves a little from frame to frame, the traps would not show.
#![allow(clippy::unwrap_used)] // Helpers of tests.

use std::fs;

use exam::Question;
use exam::interpolation::Question as InterpolationQuestion;
use glam::Quat;
use grading::fk::{ROTATION_TOLERANCE, angle_between};
use grading::interpolation::exam;
use grading::{Case, Exam, PUBLIC_SEED, Solutions};
use skeleton::{Frame, FrameCursor, Motion, RotationOrder, Skeleton};
use solutions::fk::local_quaternion;
use solutions::interpolation::{interpolate_angles, slerp};

/// How often the traps would show, of how many joints that rotate.
#[derive(Debug, Default)]
struct Revealed {
    joints: usize,
    /// Angles that go straight from one number to the other.
    straight_angles: usize,
    /// Quaternions that are interpolated as they come.
    no_shorter_way: usize,
    /// Quaternions on a straight line.
    uneven_speed: usize,
}

impl Revealed {
    fn add(&mut self, skeleton: &Skeleton, from: &Frame, to: &Frame, t: f32) {
        let mut ends = [from, to].map(|frame| FrameCursor::new(&frame.angles));
        for joint in skeleton.joints().iter().filter(|joint| joint.rotation_order != RotationOrder::None) {
            let rotation = |angles: [f32; 3]| local_quaternion(joint, &mut FrameCursor::new(&angles));
            let [from, to] = ends.each_mut().map(FrameCursor::take3);
            let straight = std::array::from_fn(|axis| from[axis] + t * (to[axis] - from[axis]));
            let right = interpolate_angles(from, to, t);
            self.straight_angles += differ(rotation(straight), rotation(right));

            let [from, to] = [from, to].map(rotation);
            let right = slerp(from, to, t);
            self.no_shorter_way += differ(as_they_come(from, to, t), right);
            self.uneven_speed += differ(from.lerp(to, t), right);
            self.joints += 1;
        }
    }
}

fn differ(a: Quat, b: Quat) -> usize {
    usize::from(angle_between(a, b) > ROTATION_TOLERANCE)
}

/// The formula without a look at the dot product.
fn as_they_come(from: Quat, to: Quat, t: f32) -> Quat {
    let angle = from.dot(to).clamp(-1.0, 1.0).acos();
    if angle < 1e-3 {
        return from.lerp(to, t);
    }
    (from * ((1.0 - t) * angle).sin() + to * (t * angle).sin()) / angle.sin()
}

/// Between every frame of a motion and the frame `gap` later.
fn revealed_by_motion(name: &str, gap: usize) -> Revealed {
    let bytes = fs::read(format!("{}/../../data/{name}", env!("CARGO_MANIFEST_DIR"))).unwrap();
    let motion: Motion = parser::bvh::read(&*bytes).unwrap().motion;
    let mut revealed = Revealed::default();
    for frame in (0..motion.frame_count() - gap).step_by(gap) {
        revealed.add(motion.skeleton(), &motion.frame(frame), &motion.frame(frame + gap), 0.25);
    }
    revealed
}

fn revealed_by_exam(exam: &Exam) -> Revealed {
    let mut revealed = Revealed::default();
    for case in cases(exam, "part3") {
        if let Question::Interpolation(InterpolationQuestion::Frame { skeleton, from, to, t, .. }) =
            &case.question
        {
            revealed.add(skeleton, from, to, *t);
        }
    }
    revealed
}

fn cases<'a>(exam: &'a Exam, part: &str) -> impl Iterator<Item = &'a Case> {
    let part = exam.parts.iter().find(|paper| paper.rubric.id == part).unwrap();
    part.checks.iter().flat_map(|check| &check.cases)
}

fn exams() -> impl Iterator<Item = Exam> {
    [PUBLIC_SEED, 0, 1, 2, 3, 77, 1_000_003, u64::MAX].into_iter().map(|seed| exam(seed, &Solutions))
}

#[test]
fn a_run_does_not_reveal_the_traps_and_the_questions_do() {
    let run = revealed_by_motion("running.bvh", 1);
    assert!(run.joints > 30_000, "{run:?}");
    assert_eq!((run.straight_angles, run.no_shorter_way, run.uneven_speed), (0, 0, 0), "{run:?}");
    let four_frames = revealed_by_motion("running.bvh", 4);
    assert_eq!((four_frames.straight_angles, four_frames.no_shorter_way), (0, 0), "{four_frames:?}");
    for exam in exams() {
        let revealed = revealed_by_exam(&exam);
        let Revealed { joints, straight_angles, no_shorter_way, uneven_speed } = revealed;
        assert!(joints > 250 && 2 * straight_angles > joints, "{revealed:?}");
        assert!(4 * no_shorter_way > joints && 2 * uneven_speed > joints, "{revealed:?}");
    }
}

/// What dance.bvh is made for: an angle that jumps.
#[test]
fn a_dance_reveals_a_little() {
    let dance = revealed_by_motion("dance.bvh", 1);
    assert!(dance.straight_angles > 0 && dance.no_shorter_way > 0, "{dance:?}");
}

/// Half a turn has no shorter way.
#[test]
fn no_answer_is_a_matter_of_taste() {
    for exam in exams() {
        for case in cases(&exam, "part1") {
            let InterpolationQuestion::Angles { from, to, .. } = asked(case) else { panic!() };
            assert_no_half_turns(from, to);
        }
        for case in cases(&exam, "part2") {
            let InterpolationQuestion::Slerp { from, to, .. } = asked(case) else { panic!() };
            assert!(from.is_normalized() && to.is_normalized());
            assert!(from.dot(*to).abs() > 0.1, "{from} {to}");
        }
        for case in cases(&exam, "part3") {
            let InterpolationQuestion::Frame { from, to, ends: [q, p], .. } = asked(case) else { panic!() };
            assert_no_half_turns(&from.angles, &to.angles);
            assert!(q.iter().zip(p).all(|(q, p)| q.dot(*p).abs() > 0.19));
        }
    }
}

fn asked(case: &Case) -> &InterpolationQuestion {
    let Question::Interpolation(question) = &case.question else { panic!("{:?}", case.question) };
    question
}

fn assert_no_half_turns(from: &[f32], to: &[f32]) {
    assert_eq!(from.len(), to.len());
    for (from, to) in from.iter().zip(to) {
        let apart = (to - from).rem_euclid(360.0);
        assert!((apart - 180.0).abs() > 5.0, "from {from} to {to}");
        for angle in [from, to] {
            assert!(
                angle.to_string().split_once('.').is_none_or(|(_, decimals)| decimals.len() <= 2),
                "{angle}"
            );
        }
    }
}

#[test]
fn close_rotations_are_of_every_kind() {
    for exam in exams() {
        let close = exam.parts[1].checks.iter().find(|check| check.rubric.id == "close").unwrap();
        let dots: Vec<f32> = close
            .cases
            .iter()
            .map(|case| {
                let InterpolationQuestion::Slerp { from, to, .. } = asked(case) else { panic!() };
                from.dot(*to)
            })
            .collect();
        for (kind, is_of) in [
            ("exactly 1", (|dot| dot == 1.0) as fn(f32) -> bool),
            ("above 1 by rounding", |dot| dot > 1.0),
            ("exactly -1", |dot| dot == -1.0),
            ("below -1 by rounding", |dot| dot < -1.0),
            ("nearly 1", |dot| dot > 0.9999 && dot < 0.99999),
            ("nearly -1", |dot| dot < -0.9999 && dot > -0.99999),
        ] {
            assert!(dots.iter().any(|dot| is_of(*dot)), "{kind}: {dots:?}");
        }
    }
}

#[test]
fn frames_hold_what_a_motion_can_hold() {
    for exam in exams() {
        let figures = cases(&exam, "part3").filter_map(|case| match asked(case) {
            InterpolationQuestion::Frame { skeleton, from, to, .. } if skeleton.len() > 2 => {
                Some((skeleton, from, to))
            }
            _ => None,
        });
        for (skeleton, from, to) in figures {
            let has = |order| skeleton.joints().iter().any(|joint| joint.rotation_order == order);
            assert!(RotationOrder::ROTATING.into_iter().all(has) && has(RotationOrder::None));
            let joints = skeleton.joints();
            assert!(joints.iter().filter(|joint| joint.is_root()).count() > 1);
            let moves = |index: usize| from.local_positions[index] != to.local_positions[index];
            assert!(joints.iter().any(|joint| !joint.is_root() && moves(joint.id.0)));
            assert!(joints.iter().any(|joint| !moves(joint.id.0)));
            let far = |least: f32| {
                from.angles.iter().zip(&to.angles).filter(|(from, to)| (**to - **from).abs() > least).count()
            };
            assert!(far(180.0) > 20 && far(540.0) > 5, "{} {}", far(180.0), far(540.0));
        }
    }
}

#[test]
fn every_check_asks_something_and_other_seeds_ask_something_else() {
    let [first, again, other] = [1, 1, 2].map(|seed| exam(seed, &Solutions));
    for part in ["part1", "part2", "part3"] {
        let questions = |exam| cases(exam, part).map(|case| case.question.clone()).collect::<Vec<_>>();
        assert_eq!(questions(&first), questions(&again));
        assert_ne!(questions(&first), questions(&other));
    }
    for check in first.parts.iter().flat_map(|part| &part.checks) {
        assert!(check.cases.len() >= 5, "{} has {} cases", check.rubric.id, check.cases.len());
    }
}
