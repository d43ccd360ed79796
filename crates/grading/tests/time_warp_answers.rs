//! What is asked about time warping, and what is said when something is not right.
#![allow(clippy::unwrap_used)] // Helpers of tests.

#[path = "support/marks.rs"]
mod marks;

use exam::time_warp::Question as TimeWarpQuestion;
use exam::{Functions, Question};
use glam::{EulerRot, Mat3, Quat, Vec3};
use grading::time_warp::exam;
use grading::{CheckState, Exam, PUBLIC_SEED, PartReport, PartState, Solutions, Trouble, WholeReport};
use skeleton::acclaim::{Between, Posture, TimeWarpFunctions};
use solutions::TIME_WARP;

use marks::{first_case, names};

fn public() -> Exam {
    exam(PUBLIC_SEED, &Solutions)
}

fn report(functions: TimeWarpFunctions, part: usize) -> PartReport {
    marks::report(&public(), part, Functions::TimeWarp(functions))
}

fn whole(functions: TimeWarpFunctions) -> WholeReport {
    marks::whole(&public(), Functions::TimeWarp(functions))
}

fn questions(exam: &Exam) -> Vec<Question> {
    let cases = exam.parts.iter().flat_map(|part| &part.checks).flat_map(|check| &check.cases);
    cases.map(|case| case.question.clone()).chain([exam.whole_motion.question.clone()]).collect()
}

#[test]
fn every_check_asks_something_and_the_same_seed_asks_the_same() {
    let exam = public();
    for check in exam.parts.iter().flat_map(|part| &part.checks) {
        assert!(check.cases.len() >= 4, "{} has {} cases", check.rubric.id, check.cases.len());
        let lines = check.cases.iter().flat_map(|case| &case.inputs);
        assert!(lines.clone().all(|(name, value)| name.len() <= 32 && value.chars().count() <= 64));
    }
    assert_eq!(questions(&exam), questions(&public()));
    assert_ne!(questions(&exam), questions(&grading::time_warp::exam(PUBLIC_SEED + 1, &Solutions)));
}

/// Where single precision cannot keep the tolerance, nobody is asked: near a middle angle of ±90 degrees.
#[test]
fn no_rotation_that_is_asked_for_is_near_gimbal_lock() {
    for seed in (0..200).map(|n| n * 7919 + 1).chain([PUBLIC_SEED]) {
        let exam = exam(seed, &Solutions);
        for question in questions(&exam) {
            let Question::TimeWarp(question) = question else { panic!() };
            let postures = match question.ask(&TIME_WARP) {
                exam::time_warp::Answer::Position(_) => continue,
                exam::time_warp::Answer::Blend(posture) => vec![posture],
                exam::time_warp::Answer::Warp { postures, .. }
                | exam::time_warp::Answer::Fewer { postures, .. }
                | exam::time_warp::Answer::Motion(postures) => postures,
            };
            for [x, y, z] in postures.into_iter().flat_map(|posture| posture.angles) {
                assert!(y.abs() < 75.5, "seed {seed}: ({x}, {y}, {z})");
            }
        }
    }
}

/// Why: what becomes of angles that are made into a quaternion and back.
#[test]
fn angles_near_gimbal_lock_come_back_inexact() {
    let off = |from_lock: f32| {
        let mut worst: f64 = 0.0;
        for step in 0..2000 {
            let (x, z) = (step as f32 * 0.179 - 170.0, step as f32 * 0.123 - 120.0);
            let q = quaternion([x, 90.0 - from_lock, z]);
            let (z, y, x) = q.to_euler(EulerRot::ZYX);
            let back = quaternion([x, y, z].map(f32::to_degrees));
            worst = worst.max(grading::fk::angle_between(q, back));
        }
        worst
    };
    assert!(off(15.0) < 3e-4, "{}", off(15.0));
    assert!(off(2.0) < 3e-3, "{}", off(2.0));
    assert!(off(0.02) > 0.02, "{}", off(0.02));
}

fn quaternion([x, y, z]: [f32; 3]) -> Quat {
    Quat::from_euler(EulerRot::ZYX, z.to_radians(), y.to_radians(), x.to_radians())
}

#[test]
fn two_mistakes_in_one_function_are_both_named_when_they_show_in_different_checks() {
    let old_position = |frame: usize, old: usize, new: usize| {
        let place = frame as f32 * (old as f32 / new as f32);
        let (before, after) = (place.floor() as usize, place.ceil() as usize);
        Between { before, after, t: place - place.floor() }
    };
    let report = report(TimeWarpFunctions { old_position, ..TIME_WARP }, 0);
    assert_eq!(names(&report), ["past_the_end", "few_digits"]);
    assert_eq!(report.points(), 3);
    let blend = |from: &Posture, to: &Posture, t: f32| Posture {
        angles: (TIME_WARP.blend)(from, to, t).angles.iter().map(|a| a.map(f32::to_radians)).collect(),
        translations: from.translations.clone(),
    };
    let report = self::report(TimeWarpFunctions { blend, ..TIME_WARP }, 1);
    assert_eq!(names(&report), ["degrees_and_radians", "translations_stay"]);
}

/// As it is often written first: with index trouble and Euler numbers in quaternions.
#[test]
fn the_best_known_mistakes_are_named_wherever_the_slerp_comes_from() {
    fn packed(angles: [f32; 3]) -> Quat {
        Quat::from_xyzw(angles[0], angles[1], angles[2], 0.0)
    }
    let by_glam = |from: &Posture, to: &Posture, t: f32| {
        let mut blended = (TIME_WARP.blend)(from, to, t);
        for (bone, angles) in blended.angles.iter_mut().enumerate() {
            *angles = packed(from.angles[bone]).slerp(packed(to.angles[bone]), t).xyz().to_array();
        }
        blended
    };
    let as_numbers = |from: &Posture, to: &Posture, t: f32| {
        let by_matrix = |angles: [f32; 3]| {
            let [x, y, z] = angles.map(f32::to_radians);
            Quat::from_mat3(&Mat3::from_euler(EulerRot::ZYX, z, y, x))
        };
        let mut blended = (TIME_WARP.blend)(from, to, t);
        for (bone, angles) in blended.angles.iter_mut().enumerate() {
            *angles = by_matrix(from.angles[bone]).slerp(by_matrix(to.angles[bone]), t).xyz().to_array();
        }
        blended
    };
    let named = |blend| names(&report(TimeWarpFunctions { blend, ..TIME_WARP }, 1));
    assert_eq!(named(by_glam), ["angles_in_a_quaternion"]);
    assert_eq!(named(as_numbers), ["components_as_angles"]);
}

#[test]
fn a_mistake_that_nobody_knows_is_not_given_a_name() {
    let functions = TimeWarpFunctions {
        old_position: |frame, old, new| {
            let right = (TIME_WARP.old_position)(frame, old, new);
            Between { t: right.t * right.t, ..right }
        },
        blend: |from, to, t| (TIME_WARP.blend)(from, to, t * t),
        warp: |postures, new_count| {
            let mut warped = (TIME_WARP.warp)(postures, new_count);
            warped.rotate_left(new_count / 2);
            warped
        },
    };
    for part in 0..3 {
        let report = report(functions, part);
        assert!(report.named.is_empty() && report.points() < 5, "{report:?}");
        assert_ne!(report.state, PartState::NotStarted);
    }
}

#[test]
fn what_is_not_a_number_is_never_right() {
    let functions = TimeWarpFunctions {
        old_position: |frame, old, new| Between { t: f32::NAN, ..(TIME_WARP.old_position)(frame, old, new) },
        blend: |from, _, _| Posture {
            angles: vec![[f32::NAN; 3]; from.angles.len()],
            translations: vec![Vec3::NAN; from.translations.len()],
        },
        ..TIME_WARP
    };
    for part in 0..2 {
        let report = report(functions, part);
        assert_eq!((report.points(), names(&report).len()), (0, 0), "{report:?}");
        for check in &report.checks {
            let CheckState::Wrong(first) = &check.state else { panic!("{check:?}") };
            assert_eq!(first.wrong, first.cases);
            assert!(first.difference.between.contains("not a number"), "{first:?}");
        }
    }
    // Part 3 by itself neither.
    let warp = |postures: &[Posture], new_count: usize| {
        let mut warped = (TIME_WARP.warp)(postures, new_count);
        warped.iter_mut().for_each(|posture| posture.translations.fill(Vec3::NAN));
        warped
    };
    let report = report(TimeWarpFunctions { warp, ..TIME_WARP }, 2);
    assert_eq!(report.points(), 0);
}

#[test]
fn too_many_and_missing_bones_and_frames_are_told() {
    let one_bone = |from: &Posture, to: &Posture, t: f32| {
        let mut blended = (TIME_WARP.blend)(from, to, t);
        blended.angles.truncate(1);
        blended.translations.push(Vec3::ZERO);
        blended
    };
    let report = report(TimeWarpFunctions { blend: one_bone, ..TIME_WARP }, 1);
    assert_eq!(first_case(&report, "one_axis").difference.got, "1 angles");
    assert_eq!(first_case(&report, "one_axis").difference.expected, "7 angles, one for every bone");
    assert_eq!(first_case(&report, "translations").difference.between, "1 translations");
    let two_less = |postures: &[Posture], new_count: usize| {
        let mut warped = (TIME_WARP.warp)(postures, new_count);
        warped.truncate(new_count.saturating_sub(2));
        warped
    };
    let report = self::report(TimeWarpFunctions { warp: two_less, ..TIME_WARP }, 2);
    let first = first_case(&report, "longer");
    assert_eq!((first.difference.got.as_str(), first.difference.expected.as_str()), ("4 frames", "6 frames"));
    assert_eq!(first.difference.between, "2 frames missing");
}

#[test]
fn wrong_cases_of_one_kind_are_pointed_out() {
    let not_for_one = |frame: usize, old: usize, new: usize| {
        let right = (TIME_WARP.old_position)(frame, old, new);
        Between { after: if old == 1 { 1 } else { right.after }, ..right }
    };
    let report = report(TimeWarpFunctions { old_position: not_for_one, ..TIME_WARP }, 0);
    let first = first_case(&report, "last");
    assert_eq!(first.groups, ["an old motion of one frame"]);
    assert_eq!(first.difference.between, "there is no frame 1: the last one is 0");
}

#[test]
fn the_whole_motion_praises_what_is_right() {
    let whole = whole(TIME_WARP);
    assert!(whole.trouble.is_none() && whole.frames == 30, "{whole:?}");
    assert!(whole.praise.contains("12 frames become 30"), "{}", whole.praise);
}

#[test]
fn the_whole_motion_says_in_which_frame_and_at_which_bone_it_is_first_off() {
    let warp = |postures: &[Posture], new_count: usize| {
        let mut warped = (TIME_WARP.warp)(postures, new_count);
        warped[7].translations[3].x += 0.25;
        let q = quaternion(warped[9].angles[1]) * Quat::from_rotation_x(0.1);
        let (z, y, x) = q.to_euler(EulerRot::ZYX);
        warped[9].angles[1] = [x, y, z].map(f32::to_degrees);
        warped
    };
    let functions = TimeWarpFunctions { warp, ..TIME_WARP };
    let Some(Trouble::Different { summary, details }) = whole(functions).trouble else { panic!() };
    assert_eq!(
        summary,
        "With your three functions, 2 of 30 frames are off. The first of them is frame 7: bone 3 is off there, by 0.250 \
         (file's unit)."
    );
    assert_eq!(details[0], "Frame 7 is between the old frames 2 and 3, at t = 0.80.");
    assert!(details[1].starts_with("Yours: translations[3] (") && details[2].starts_with("Expected: "));
    assert!(details[3].starts_with("Wherever a new frame is an old one, it is right"), "{details:?}");
}

/// What is said when only the end is off, which nothing comes after.
#[test]
fn the_whole_motion_says_that_a_frame_is_after_the_last_old_one() {
    fn at(postures: &[Posture], new_count: usize, place: fn(f64, usize) -> (usize, usize)) -> Vec<Posture> {
        let frame = |frame| {
            let along = frame as f64 * postures.len() as f64 / new_count as f64;
            let (before, after) = place(along, postures.len());
            (TIME_WARP.blend)(&postures[before], &postures[after], (along - before as f64) as f32)
        };
        (0..new_count).map(frame).collect()
    }
    let round_again: fn(&[Posture], usize) -> Vec<Posture> = |postures, new_count| {
        at(postures, new_count, |along, old| (along as usize, (along as usize + 1) % old))
    };
    let goes_on: fn(&[Posture], usize) -> Vec<Posture> = |postures, new_count| {
        at(postures, new_count, |along, old| {
            let before = (along as usize).min(old - 2);
            (before, before + 1)
        })
    };
    for warp in [round_again, goes_on] {
        let functions = TimeWarpFunctions { warp, ..TIME_WARP };
        let Some(Trouble::Different { summary, details }) = whole(functions).trouble else { panic!() };
        assert!(summary.contains("2 of 30 frames are off. The first of them is frame 28: "), "{summary}");
        assert_eq!(details[0], "Frame 28 is after the last old frame, which stays.");
        assert_eq!(details.len(), 3, "{details:?}");
    }
}

#[test]
fn the_whole_motion_says_what_is_not_a_number() {
    let warp = |postures: &[Posture], new_count: usize| {
        let mut warped = (TIME_WARP.warp)(postures, new_count);
        warped[3].translations[2].y = f32::NAN;
        warped
    };
    let functions = TimeWarpFunctions { warp, ..TIME_WARP };
    let Some(Trouble::Different { summary, .. }) = whole(functions).trouble else { panic!() };
    let end = "frame 3: bone 2 is not a number there (NaN), or infinite: look for a division by zero.";
    assert!(summary.ends_with(end), "{summary}");
}

#[test]
fn the_whole_motion_tells_another_number_of_frames_and_of_bones() {
    let summary = |warp| match whole(TimeWarpFunctions { warp, ..TIME_WARP }).trouble {
        Some(Trouble::Different { summary, .. }) => summary,
        other => panic!("{other:?}"),
    };
    let fewer = |postures: &[Posture], new_count: usize| (TIME_WARP.warp)(postures, new_count - 1);
    assert!(summary(fewer).ends_with("the new motion has 29 frames, and not as many as were asked for."));
    let bones = |postures: &[Posture], new_count: usize| {
        let mut warped = (TIME_WARP.warp)(postures, new_count);
        warped[4].angles.truncate(2);
        warped
    };
    assert!(
        summary(bones).ends_with("frame 4: it has not as many bones as the motion."),
        "{}",
        summary(bones)
    );
}

/// What students read of the whole motion holds nothing of the right answer, and a misconception of each part shows in it.
#[test]
fn the_whole_motion_is_no_easy_one() {
    for seed in (0..20).map(|n| n * 7919 + 1).chain([PUBLIC_SEED]) {
        let exam = exam(seed, &Solutions);
        for part in ["part1", "part2", "part3"] {
            for misconception in grading::time_warp::misconceptions(part) {
                // These do not show in a longer motion that is short, or make a student's part 3 panic: that of the
                // variants is right then.
                let hidden = ["past_the_end", "upside_down", "few_digits", "last_kept"];
                let shows = !hidden.contains(&misconception.id);
                for wrong in &misconception.variants {
                    let report = marks::whole(&exam, *wrong);
                    let is_off = matches!(report.trouble, Some(Trouble::Different { .. }));
                    assert!(is_off || !shows, "seed {seed}, {}", misconception.id);
                }
            }
        }
    }
}

#[test]
fn a_question_about_a_whole_motion_is_put_as_one() {
    let Question::TimeWarp(TimeWarpQuestion::Motion { postures, new_count }) = public().whole_motion.question
    else {
        panic!()
    };
    assert_eq!((postures.len(), new_count), (12, 30));
}
