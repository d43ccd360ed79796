//! Mistakes in time warping as students write them, and the names they are given.
#![allow(clippy::unwrap_used, clippy::approx_constant)] // Helpers of tests.

#[path = "support/marks.rs"]
mod marks;

use exam::Functions;
use glam::{EulerRot, Quat};
use grading::time_warp::exam;
use grading::{PUBLIC_SEED, PartReport, Solutions};
use skeleton::acclaim::{Between, Posture, TimeWarpFunctions};
use solutions::TIME_WARP;

use marks::{lost_checks, names};

/// The reports on all parts, for the public seed and some others.
fn reports(functions: TimeWarpFunctions) -> impl Iterator<Item = Vec<PartReport>> {
    let seeds = [PUBLIC_SEED, 0, 1, 2, 77, u64::MAX];
    seeds.into_iter().map(move |seed| marks::reports(&exam(seed, &Solutions), Functions::TimeWarp(functions)))
}

/// What a frame too many is, part 1 decides, and it is given a name whatever that is.
#[test]
fn frames_that_are_counted_wrongly_are_named_with_any_right_part_1() {
    /// The place kept within the motion.
    const AT_MOST_LAST: fn(usize, usize, usize) -> Between = |frame, old, new| {
        let place = (frame as f64 * old as f64 / new as f64).min((old - 1) as f64);
        let before = place as usize;
        Between { before, after: (before + 1).min(old - 1), t: place.fract() as f32 }
    };
    /// Whole numbers, which divide by zero when there is no new frame.
    const WHOLE: fn(usize, usize, usize) -> Between = |frame, old, new| {
        let (before, last) = (frame * old / new, old - 1);
        let t = (frame * old % new) as f64 / new as f64;
        Between { before: before.min(last), after: (before + 1).min(last), t: t as f32 }
    };
    macro_rules! counted {
        ($place:expr, |$count:ident| $frames:expr) => {
            TimeWarpFunctions {
                old_position: $place,
                blend: TIME_WARP.blend,
                warp: |postures, $count| {
                    let place: fn(usize, usize, usize) -> Between = $place;
                    let frame = |frame| {
                        let Between { before, after, t } = place(frame, postures.len(), $count);
                        (TIME_WARP.blend)(&postures[before], &postures[after], t)
                    };
                    if postures.is_empty() { Vec::new() } else { $frames.map(frame).collect() }
                },
            }
        };
    }
    macro_rules! with_each_part_1 {
        (|$count:ident| $frames:expr) => {
            [
                counted!(TIME_WARP.old_position, |$count| $frames),
                counted!(AT_MOST_LAST, |$count| $frames),
                counted!(WHOLE, |$count| $frames),
            ]
        };
    }
    let wrong = [
        ("one_off", with_each_part_1!(|count| 0..=count)),
        ("one_off", with_each_part_1!(|count| 0..count.saturating_sub(1))),
        ("begins_at_1", with_each_part_1!(|count| 1..=count)),
        ("begins_at_1", with_each_part_1!(|count| 1..count)),
    ];
    for (name, functions) in wrong {
        for reports in functions.into_iter().flat_map(reports) {
            assert!(lost_checks(&reports[0]).is_empty());
            assert_eq!(lost_checks(&reports[2]), ["longer", "shorter", "same", "few"]);
            assert_eq!(names(&reports[2]), [name]);
        }
    }
}

/// A part 2 that makes quaternions and angles like this.
macro_rules! turning {
    (|$angles:ident| $quaternion:expr, |$rotation:ident| $back:expr) => {
        TimeWarpFunctions {
            blend: |from, to, t| {
                let quaternion = |$angles: [f32; 3]| -> Quat { $quaternion };
                let angles = |$rotation: Quat| -> [f32; 3] { $back };
                let pairs = from.angles.iter().zip(&to.angles);
                Posture {
                    angles: pairs
                        .map(|(from, to)| angles(quaternion(*from).slerp(quaternion(*to), t)))
                        .collect(),
                    ..(TIME_WARP.blend)(from, to, t)
                }
            },
            ..TIME_WARP
        }
    };
}

#[test]
fn euler_angles_as_they_come_are_named() {
    let unconverted =
        turning!(|angles| Quat::from_euler(EulerRot::XYZ, angles[0], angles[1], angles[2]), |rotation| {
            rotation.to_euler(EulerRot::XYZ).into()
        });
    let converted_later =
        turning!(|angles| Quat::from_euler(EulerRot::XYZ, angles[0], angles[1], angles[2]), |rotation| {
            <[f32; 3]>::from(rotation.to_euler(EulerRot::XYZ)).map(f32::to_degrees)
        });
    for reports in [unconverted, converted_later].into_iter().flat_map(reports) {
        assert_eq!(lost_checks(&reports[1]), ["one_axis", "all_axes", "wrap"]);
        assert_eq!(names(&reports[1]), ["degrees_and_order"]);
    }
}

#[test]
fn a_short_pi_is_accepted_with_a_remark() {
    let short = turning!(
        |angles| {
            let [x, y, z] = angles.map(|angle| angle * 3.14 / 180.0);
            Quat::from_euler(EulerRot::ZYX, z, y, x)
        },
        |rotation| {
            let (z, y, x) = rotation.to_euler(EulerRot::ZYX);
            [x, y, z].map(|angle| angle * 180.0 / 3.14)
        }
    );
    for reports in reports(short) {
        assert!(reports.iter().all(|report| report.points() == 5), "{reports:?}");
        assert!(reports[1].remark.unwrap().contains("π"));
    }
}

#[test]
fn as_many_frames_as_before_are_named() {
    type Warp = fn(&[Posture], usize) -> Vec<Posture>;
    let old_count = |postures: &[Posture], new_count: usize| {
        let mut warped = Vec::new();
        for frame in 0..postures.len() {
            let Between { before, after, t } = (TIME_WARP.old_position)(frame, postures.len(), new_count);
            warped.push((TIME_WARP.blend)(&postures[before], &postures[after], t));
        }
        warped
    };
    let cut_off = |postures: &[Posture], new_count: usize| {
        let mut warped = postures.to_vec();
        warped.truncate(new_count);
        warped
    };
    let functions = [("old_count", old_count as Warp), ("cut_off", cut_off)];
    for (name, warp) in functions {
        for reports in reports(TimeWarpFunctions { warp, ..TIME_WARP }) {
            assert_eq!(lost_checks(&reports[2]), ["longer", "shorter", "same", "few"]);
            assert_eq!(names(&reports[2]), [name]);
        }
    }
}

#[test]
fn a_whole_place_for_t_is_named() {
    let old_position = |frame: usize, old: usize, new: usize| {
        let place = frame as f64 * old as f64 / new as f64;
        let (before, after) = (place.floor() as usize, place.ceil() as usize);
        Between { before: before.min(old - 1), after: after.min(old - 1), t: place as f32 }
    };
    for reports in reports(TimeWarpFunctions { old_position, ..TIME_WARP }) {
        assert_eq!(lost_checks(&reports[0]), ["slower", "faster", "last", "long"]);
        assert_eq!(names(&reports[0]), ["t_not_within_a_frame"]);
    }
}
