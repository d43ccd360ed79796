//! There is more than one right way through the exercise on time warping. All of them get all points, and with a wrong part
//! 1 or 2 all of part 3's.
#![allow(clippy::unwrap_used)] // Helpers of tests.

#[path = "support/marks.rs"]
mod marks;

use exam::Functions;
use glam::{EulerRot, Mat3, Quat, Vec3};
use grading::time_warp::{TEMPLATE, exam};
use grading::{CheckState, PUBLIC_SEED, PartReport, PartState, Solutions};
use skeleton::acclaim::{Between, Posture, TimeWarpFunctions};
use solutions::TIME_WARP;

use marks::{first_case, lost_checks};

/// The reports on all parts, for the public seed and some others.
fn reports(functions: TimeWarpFunctions) -> impl Iterator<Item = Vec<PartReport>> {
    let seeds = [PUBLIC_SEED, 0, 1, 2, 3, 77, 1_000_003, u64::MAX];
    seeds.into_iter().map(move |seed| marks::reports(&exam(seed, &Solutions), Functions::TimeWarp(functions)))
}

fn assert_all_right(what: &str, functions: TimeWarpFunctions) {
    for report in reports(functions).flatten() {
        assert!(lost_checks(&report).is_empty() && report.remark.is_none(), "{what}: {report:?}");
    }
    let report = marks::whole(&exam(PUBLIC_SEED, &Solutions), Functions::TimeWarp(functions));
    assert!(report.trouble.is_none(), "{what}: {report:?}");
}

/// All three functions, with these parts 1 and 2 called by part 3.
macro_rules! together {
    ($place:expr, $blend:expr) => {
        TimeWarpFunctions {
            old_position: $place,
            blend: $blend,
            warp: |postures, new_count| {
                let place: fn(usize, usize, usize) -> Between = $place;
                let blend: fn(&Posture, &Posture, f32) -> Posture = $blend;
                let mut warped = Vec::new();
                for frame in 0..if postures.is_empty() { 0 } else { new_count } {
                    let between = place(frame, postures.len(), new_count);
                    warped.push(blend(&postures[between.before], &postures[between.after], between.t));
                }
                warped
            },
        }
    };
}

#[test]
fn a_place_may_be_named_in_other_ways() {
    assert_all_right(
        "a ratio in double precision, floor and ceil",
        together!(
            |frame, old, new| {
                let place = old as f64 / new as f64 * frame as f64;
                let (before, after) = (place.floor() as usize, place.ceil() as usize);
                Between { before, after: after.min(old - 1), t: (place - before as f64) as f32 }
            },
            TIME_WARP.blend
        ),
    );
    assert_all_right(
        "the place kept within the motion, and always the next frame",
        together!(
            |frame, old, new| {
                let place = (frame as f64 * (old as f64 / new as f64)).min((old - 1) as f64);
                let before = place as usize;
                Between { before, after: (before + 1).min(old - 1), t: place.fract() as f32 }
            },
            TIME_WARP.blend
        ),
    );
    assert_all_right(
        "the frame after is found first",
        together!(
            |frame, old, new| {
                let after = (frame * old).div_ceil(new);
                let back = (after * new - frame * old) as f64 / new as f64;
                let before = after.saturating_sub(1).min(old - 1);
                Between {
                    before,
                    after: after.min(old - 1),
                    t: if after == 0 { 1.0 } else { 1.0 - back as f32 },
                }
            },
            TIME_WARP.blend
        ),
    );
}

/// In single precision it is right for as long as the motions are short, whatever the formula.
#[test]
fn single_precision_costs_only_long_motions() {
    macro_rules! single {
        (|$frame:ident, $old:ident, $new:ident| $place:expr) => {
            together!(
                |frame, old_count, new_count| {
                    let ($frame, $old, $new) = (frame as f32, old_count as f32, new_count as f32);
                    let place: f32 = $place;
                    let last = old_count - 1;
                    let (before, after) = (place.floor(), place.ceil());
                    let at = |frame: f32| (frame as usize).min(last);
                    Between { before: at(before), after: at(after), t: place - before }
                },
                TIME_WARP.blend
            )
        };
    }
    for functions in [
        single!(|frame, old, new| old / new * frame),
        single!(|frame, old, new| frame * old / new),
        single!(|frame, old, new| frame / new * old),
        single!(|frame, old, new| frame / (new / old)),
    ] {
        for reports in reports(functions) {
            assert_eq!(lost_checks(&reports[0]), ["long"]);
            assert_eq!(reports[0].named[0].id, "few_digits");
            assert!(lost_checks(&reports[1]).is_empty() && lost_checks(&reports[2]).is_empty());
        }
    }
}

/// A part 2 that turns each bone like this.
macro_rules! turning {
    (|$from:ident, $to:ident, $t:ident| $angles:expr) => {
        together!(TIME_WARP.old_position, |from, to, t| {
            let $t = t;
            let angles = from.angles.iter().zip(&to.angles).map(|($from, $to)| $angles);
            let moved = from.translations.iter().zip(&to.translations);
            Posture {
                angles: angles.collect(),
                translations: moved.map(|(from, to)| *from * (1.0 - t) + *to * t).collect(),
            }
        })
    };
}

fn quaternion([x, y, z]: [f32; 3]) -> Quat {
    let turn = |axis, degrees: f32| Quat::from_axis_angle(axis, degrees.to_radians());
    turn(Vec3::Z, z) * turn(Vec3::Y, y) * turn(Vec3::X, x)
}

/// By the formulas of a textbook.
fn angles(q: Quat) -> [f32; 3] {
    let x = (2.0 * (q.w * q.x + q.y * q.z)).atan2(1.0 - 2.0 * (q.x * q.x + q.y * q.y));
    let y = (2.0 * (q.w * q.y - q.z * q.x)).clamp(-1.0, 1.0).asin();
    let z = (2.0 * (q.w * q.z + q.x * q.y)).atan2(1.0 - 2.0 * (q.y * q.y + q.z * q.z));
    [x, y, z].map(f32::to_degrees)
}

#[test]
fn postures_may_be_blended_in_other_ways() {
    assert_all_right(
        "quaternions of three turns, a slerp of one's own, and a textbook's angles",
        turning!(|from, to, t| {
            let (from, mut to) = (quaternion(*from), quaternion(*to));
            let mut dot = from.dot(to);
            if dot < 0.0 {
                (to, dot) = (-to, -dot);
            }
            let angle = dot.min(1.0).acos();
            let between = if angle < 1e-3 {
                from.lerp(to, t)
            } else {
                (from * ((1.0 - t) * angle).sin() + to * (t * angle).sin()) / angle.sin()
            };
            angles(between)
        }),
    );
    assert_all_right(
        "by way of matrices",
        turning!(|from, to, t| {
            let matrix = |[x, y, z]: [f32; 3]| {
                Mat3::from_euler(EulerRot::ZYX, z.to_radians(), y.to_radians(), x.to_radians())
            };
            let [from, to] = [from, to].map(|angles| Quat::from_mat3(&matrix(*angles)));
            let (z, y, x) = Mat3::from_quat(from.slerp(to, t)).to_euler(EulerRot::ZYX);
            [x, y, z].map(f32::to_degrees)
        }),
    );
    assert_all_right(
        "about fixed axes in the opposite order",
        turning!(|from, to, t| {
            let quaternion = |angles: [f32; 3]| {
                let [x, y, z] = angles.map(f32::to_radians);
                Quat::from_euler(EulerRot::XYZEx, x, y, z)
            };
            let (x, y, z) = quaternion(*from).slerp(quaternion(*to), t).to_euler(EulerRot::XYZEx);
            [x, y, z].map(f32::to_degrees)
        }),
    );
    assert_all_right(
        "other angles for the same rotation",
        turning!(|from, to, t| {
            let [x, y, z] = angles(quaternion(*from).slerp(quaternion(*to), t));
            [x + 180.0, 180.0 - y, z - 540.0]
        }),
    );
}

/// Whoever hands over the angles about X, Y and Z where those about Z, Y and X belong, and takes them back in the same way,
/// blends the inverse rotations in a mirror. What comes out is right.
#[test]
fn exchanging_x_and_z_on_both_ways_is_right() {
    assert_all_right(
        "x, y and z in the order of Z, Y and X",
        turning!(|from, to, t| {
            let quaternion = |angles: [f32; 3]| {
                let [x, y, z] = angles.map(f32::to_radians);
                Quat::from_euler(EulerRot::ZYX, x, y, z)
            };
            let (x, y, z) = quaternion(*from).slerp(quaternion(*to), t).to_euler(EulerRot::ZYX);
            [x, y, z].map(f32::to_degrees)
        }),
    );
}

/// Wrong in parts 1 and 2: other places, and angles number by number.
const WRONG: TimeWarpFunctions = together!(
    |frame, old, new| {
        let place = frame as f64 * (old - 1) as f64 / (new.max(2) - 1) as f64;
        Between { before: place.floor() as usize, after: place.ceil() as usize, t: place.fract() as f32 }
    },
    |from, to, t| Posture {
        angles: from
            .angles
            .iter()
            .zip(&to.angles)
            .map(|(from, to)| std::array::from_fn(|axis| from[axis] + t * (to[axis] - from[axis])))
            .collect(),
        translations: from.translations.clone(),
    }
);

#[test]
fn wrong_parts_1_and_2_cost_nothing_in_part_3() {
    for reports in reports(WRONG) {
        assert_eq!(lost_checks(&reports[0]), ["slower", "faster", "last", "long"]);
        assert_eq!(lost_checks(&reports[1]), ["translations", "all_axes", "wrap"]);
        assert_eq!(
            (reports[2].state, lost_checks(&reports[2]).len()),
            (PartState::Right, 0),
            "{:?}",
            reports[2]
        );
    }
}

/// One new frame, and 0 / 0: what is not a number in part 1 is not one in part 3 either.
#[test]
fn a_division_by_zero_in_part_1_costs_nothing_in_part_3() {
    const BOTH_ENDS: fn(usize, usize, usize) -> Between = |frame, old, new| {
        let place = frame as f64 * (old - 1) as f64 / (new - 1) as f64;
        let (before, after) = (place.floor() as usize, place.ceil() as usize);
        Between { before, after, t: (place - place.floor()) as f32 }
    };
    const SINGLE: fn(usize, usize, usize) -> Between = |frame, old, new| {
        let place = frame as f32 * ((old as f32 - 1.0) / (new as f32 - 1.0));
        let (before, last) = (place as usize, old - 1);
        Between { before: before.min(last), after: (before + 1).min(last), t: place - place.floor() }
    };
    for functions in [together!(BOTH_ENDS, TIME_WARP.blend), together!(SINGLE, TIME_WARP.blend)] {
        for reports in reports(functions) {
            assert_eq!(lost_checks(&reports[0]), ["slower", "faster", "last", "long"]);
            assert!(lost_checks(&reports[1]).is_empty());
            assert!(lost_checks(&reports[2]).is_empty(), "{:?}", reports[2]);
        }
    }
}

#[test]
fn a_right_part_3_may_do_without_wrong_parts_1_and_2() {
    let functions = TimeWarpFunctions { warp: TIME_WARP.warp, ..WRONG };
    assert!(reports(functions).all(|reports| lost_checks(&reports[2]).is_empty()));
}

#[test]
fn a_wrong_part_3_costs_points_even_with_wrong_parts_1_and_2() {
    let functions = TimeWarpFunctions {
        warp: |postures, new_count| {
            let mut warped = (WRONG.warp)(postures, new_count);
            warped.reverse();
            warped
        },
        ..WRONG
    };
    for reports in reports(functions) {
        assert_eq!(lost_checks(&reports[2]), ["longer", "shorter", "same"]);
    }
}

/// A part 1 that leaves the motion makes a part 3 that relies on it panic. With fewer frames it does not, and there part 3
/// shows what it does.
#[test]
fn a_part_1_that_leaves_the_motion_costs_nothing_in_part_3() {
    const PAST_THE_END: fn(usize, usize, usize) -> Between = |frame, old, new| {
        let place = frame as f64 * old as f64 / new as f64;
        Between { before: place.floor() as usize, after: place.ceil() as usize, t: place.fract() as f32 }
    };
    const NEXT: fn(usize, usize, usize) -> Between = |frame, old, new| {
        let between = PAST_THE_END(frame, old, new);
        Between { after: between.before + 1, ..between }
    };
    for functions in [together!(PAST_THE_END, TIME_WARP.blend), together!(NEXT, WRONG.blend)] {
        for reports in reports(functions) {
            assert_eq!(lost_checks(&reports[0]), ["last"]);
            assert!(lost_checks(&reports[2]).is_empty(), "{:?}", reports[2]);
        }
    }
    let careful = TimeWarpFunctions {
        old_position: PAST_THE_END,
        warp: |postures, new_count| {
            let frame = |frame| {
                let Between { before, after, t } = PAST_THE_END(frame, postures.len(), new_count);
                (TIME_WARP.blend)(&postures[before], &postures[after.min(postures.len() - 1)], t)
            };
            (0..if postures.is_empty() { 0 } else { new_count }).map(frame).collect()
        },
        ..TIME_WARP
    };
    assert!(reports(careful).all(|reports| lost_checks(&reports[2]).is_empty()));
}

/// What is wrong with part 3 itself is not excused.
#[test]
fn a_part_1_that_leaves_the_motion_does_not_make_a_wrong_part_3_right() {
    const PAST_THE_END: fn(usize, usize, usize) -> Between = |frame, old, new| {
        let place = frame as f64 * old as f64 / new as f64;
        Between { before: place.floor() as usize, after: place.ceil() as usize, t: place.fract() as f32 }
    };
    let backwards: fn(&[Posture], usize) -> Vec<Posture> = |postures, new_count| {
        let frame = |frame| {
            let Between { before, after, t } = PAST_THE_END(frame, postures.len(), new_count);
            (TIME_WARP.blend)(&postures[after], &postures[before], t)
        };
        (0..if postures.is_empty() { 0 } else { new_count }).map(frame).collect()
    };
    let panics: fn(&[Posture], usize) -> Vec<Posture> = |_, new_count| panic!("no {new_count} frames");
    let wrong =
        [backwards, panics].map(|warp| TimeWarpFunctions { old_position: PAST_THE_END, warp, ..TIME_WARP });
    for reports in reports(wrong[0]) {
        assert_eq!(lost_checks(&reports[2]), ["longer", "shorter"]);
        let difference = &first_case(&reports[2], "longer").difference;
        assert!(difference.got.starts_with("of 3 frames: frame 1, angles[0] ("), "{difference:?}");
        assert!(difference.between.contains("so that fewer were asked for"), "{difference:?}");
    }
    for reports in reports(wrong[1]) {
        assert_eq!((reports[2].state, reports[2].points()), (PartState::Panicked, 0));
        let CheckState::Failed { failure, .. } = &reports[2].checks[0].state else { panic!() };
        assert!(failure.to_string().contains("no 6 frames"), "{failure}");
    }
}

/// What the parts make of the motion is asked for with part 3, but an untouched part 3 is known by its own answers.
#[test]
fn an_untouched_part_3_is_not_started_whatever_parts_1_and_2_are() {
    for parts in [TIME_WARP, WRONG] {
        for reports in reports(TimeWarpFunctions { warp: TEMPLATE.warp, ..parts }) {
            let report = &reports[2];
            assert_eq!((report.state, report.points()), (PartState::NotStarted, 0), "{report:?}");
        }
    }
    let functions = skeleton::InterpolationFunctions {
        interpolate_frame: grading::interpolation::TEMPLATE.interpolate_frame,
        ..solutions::INTERPOLATION
    };
    let exam = grading::interpolation::exam(PUBLIC_SEED, &Solutions);
    let report = marks::report(&exam, 2, Functions::Interpolation(functions));
    assert_eq!(report.state, PartState::NotStarted, "{report:?}");
}
