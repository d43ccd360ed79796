//! Answers that come and cannot be used.

use exam::interpolation::Answer as InterpolationAnswer;
use exam::keyframes::Answer as KeyframesAnswer;

use super::*;
use crate::live::sister::ask::Wrong;

/// Answers everything with this.
struct Fixed(Answer);

impl Subject for Fixed {
    fn ask(&mut self, _: &Question, _: Duration) -> Result<Answer, Failure> {
        Ok(self.0.clone())
    }
}

/// What is wrong with these poses, as the frames 1 and 2 between 0 and 3 of a motion with 5 joints.
fn wrong_poses(poses: Vec<LocalPose>) -> Result<(), Wrong> {
    let mut subject = Fixed(Answer::Interpolation(InterpolationAnswer::Between(poses)));
    ask::between(&mut subject, &stage(9), Representation::Euler, (0, 3), &mut go_on, || {}).map(|_| ())
}

fn pose(joints: usize) -> LocalPose {
    LocalPose { rotations: vec![Quat::IDENTITY; joints], positions: vec![Vec3::ONE; joints] }
}

#[test]
fn poses_with_the_wrong_number_of_joints_or_without_numbers_are_told_and_not_used() {
    wrong_poses(vec![pose(5), pose(5)]).unwrap();
    let wrong = wrong_poses(vec![pose(5), pose(4)]).unwrap_err().trouble;
    assert_eq!(wrong.headline, "your interpolate_frame gives 4 rotations and 4 positions, for 5 joints");
    assert_eq!(wrong.details[0], "in frame 2, t = 0.667, between the keyframes 0 and 3, with Euler angles");
    let short = LocalPose { positions: vec![Vec3::ONE; 4], ..pose(5) };
    assert!(wrong_poses(vec![short, pose(5)]).is_err());
    let mut odd = pose(5);
    odd.rotations[1].w = f32::NAN;
    let wrong = wrong_poses(vec![odd, pose(5)]).unwrap_err().trouble;
    assert_eq!(
        wrong.headline,
        "your interpolate_frame gives NaN or infinity as the rotation of joint LeftLeg"
    );
    assert!(wrong.details[0].starts_with("in frame 1,"), "{wrong:?}");
    let mut odd = pose(5);
    odd.positions[2].z = f32::INFINITY;
    let wrong = wrong_poses(vec![odd, pose(5)]).unwrap_err().trouble;
    assert!(wrong.headline.contains("as the position of joint"), "{wrong:?}");
    for count in [0, 1, 3] {
        let wrong = wrong_poses(vec![pose(5); count]).unwrap_err();
        assert!(wrong.trouble.headline.contains("does not fit the question"), "{wrong:?}");
    }
}

#[test]
fn rotations_that_are_no_unit_quaternions_are_shown_as_they_are() {
    let mut long = pose(5);
    long.rotations[1] = Quat::from_xyzw(0.0, 0.0, 0.0, 2.0);
    wrong_poses(vec![long, pose(5)]).unwrap();
}

#[test]
fn a_stretch_without_frames_between_asks_nothing() {
    let mut subject = Fixed(Answer::NotMine);
    let poses =
        ask::between(&mut subject, &stage(9), Representation::Euler, (3, 4), &mut go_on, || {}).unwrap();
    assert!(poses.is_empty());
}

#[test]
fn a_long_stretch_is_asked_in_pieces_and_every_frame_is_as_far_as_it_should_be() {
    struct Counting(usize);
    impl Subject for Counting {
        fn ask(&mut self, question: &Question, limit: Duration) -> Result<Answer, Failure> {
            self.0 += 1;
            if let Question::Interpolation(exam::interpolation::Question::Between { ts, .. }) = question {
                assert!(ts.len() * 5 <= 8_000);
            }
            Lifted(0.0).ask(question, limit)
        }
    }
    let (stage, mut subject) = (stage(5_000), Counting(0));
    let mut told = Vec::new();
    let mut progress = |done, of| {
        told.push((done, of));
        ControlFlow::Continue(())
    };
    let all = (100, 4_900);
    let poses = ask::between(&mut subject, &stage, Representation::Euler, all, &mut progress, || {}).unwrap();
    assert_eq!(told, [(1_600, 4_799), (3_200, 4_799), (4_799, 4_799)]);
    assert_eq!((poses.len(), subject.0), (4_799, 3));
    for (index, pose) in poses.iter().enumerate().step_by(479) {
        let t = (index + 1) as f32 / 4_800.0;
        let x = |frame: usize| stage.frame(frame).local_positions[0].x;
        assert!((pose.positions[0].x - (x(100) + t * (x(4_900) - x(100)))).abs() < 1e-2);
    }
}

/// Gives poses without joints, and counts how often it is asked.
struct Empty(usize);

impl Subject for Empty {
    fn ask(&mut self, question: &Question, _: Duration) -> Result<Answer, Failure> {
        self.0 += 1;
        let Question::Interpolation(exam::interpolation::Question::Between { ts, .. }) = question else {
            panic!("not frames")
        };
        Ok(Answer::Interpolation(InterpolationAnswer::Between(vec![LocalPose::default(); ts.len()])))
    }
}

#[test]
fn nothing_more_is_asked_behind_an_answer_that_cannot_be_used_nor_when_something_else_is_wanted() {
    let (stage, mut empty) = (stage(5_000), Empty(0));
    let all = (100, 4_900);
    let wrong = ask::between(&mut empty, &stage, Representation::Euler, all, &mut go_on, || {}).unwrap_err();
    assert!(wrong.trouble.headline.contains("gives 0 rotations"), "{wrong:?}");
    assert_eq!(empty.0, 1);
    let mut stop = |_, _| ControlFlow::Break(());
    let poses = ask::between(&mut Lifted(0.0), &stage, Representation::Euler, all, &mut stop, || {});
    assert_eq!(poses.unwrap().len(), 1_600);
}

/// What is wrong with this reduction of 9 frames to 3.
fn wrong_reduction(keyframes: &[usize], error: f64) -> Option<Trouble> {
    let reduction = Reduction { keyframes: keyframes.to_vec(), error };
    let mut subject = Fixed(Answer::Keyframes(KeyframesAnswer::Motion(vec![reduction])));
    let reduced = ask::reduce(&mut subject, &stage(9), Representation::Quaternion, &[3]);
    reduced.err().map(|wrong| wrong.trouble)
}

#[test]
fn keyframes_that_make_no_sense_are_told_and_not_used() {
    assert_eq!(wrong_reduction(&[0, 4, 8], 1.5), None);
    // As many as they like: what was not asked for is seen.
    assert_eq!(wrong_reduction(&[0, 1, 2, 3, 4, 5, 6, 7, 8], 0.0), None);
    for (keyframes, error, headline) in [
        (&[][..], 0.0, "your reduce keeps no keyframes at all"),
        (&[0, 8, 9], 0.0, "your reduce keeps frame 9, which the motion does not have"),
        (&[0, 5, 4, 8], 0.0, "your reduce gives 5 and after it 4"),
        (&[0, 4, 4, 8], 0.0, "your reduce gives 4 and after it 4"),
        (&[1, 8], 0.0, "your reduce removes the first frame: it begins with 1"),
        (&[0, 7], 0.0, "your reduce removes the last frame: it ends with 7"),
        (&[0, 8], f64::NAN, "your pose_error gives NaN or infinity: all errors together are NaN"),
    ] {
        let trouble = wrong_reduction(keyframes, error).unwrap();
        assert_eq!(trouble.headline, headline);
        assert_eq!(trouble.details[0], "9 frames to 3 keyframes, with quaternions");
        assert_eq!(trouble.details.len(), 2);
    }
}

#[test]
fn a_reduction_that_takes_too_long_is_told_with_what_was_wanted() {
    struct Slow;
    impl Subject for Slow {
        fn ask(&mut self, _: &Question, limit: Duration) -> Result<Answer, Failure> {
            Err(Failure::TimedOut { limit })
        }
    }
    let wrong = ask::reduce(&mut Slow, &stage(9), Representation::Euler, &[3, 5]).unwrap_err();
    assert!(wrong.trouble.headline.contains("did not finish within 10 seconds"), "{wrong:?}");
    assert_eq!(wrong.trouble.details[0], "9 frames to 3, 5 keyframes, with Euler angles");
    assert!(wrong.trouble.details[1].contains("only slow"));
}
