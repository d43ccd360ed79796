//! There is more than one right way through the exercise on interpolation. All of them get all points, and with a wrong
//! part 1 or 2 all of part 3's.
#![allow(clippy::unwrap_used)] // Helpers of tests.

#[path = "support/marks.rs"]
mod marks;

use exam::Functions;
use glam::{EulerRot, Mat3, Quat, Vec4};
use grading::interpolation::exam;
use grading::{PUBLIC_SEED, PartReport, Solutions};
use skeleton::{
    Axis, Frame, InterpolationFunctions, Joint, LocalPose, Representation, RotationOrder, Skeleton,
};
use solutions::INTERPOLATION;

use marks::lost_checks;

/// The reports on all parts, for the public seed and some others.
fn reports(functions: InterpolationFunctions) -> impl Iterator<Item = Vec<PartReport>> {
    let seeds = [PUBLIC_SEED, 0, 1, 2, 3, 77, 1_000_003, u64::MAX];
    seeds
        .into_iter()
        .map(move |seed| marks::reports(&exam(seed, &Solutions), Functions::Interpolation(functions)))
}

fn assert_all_right(what: &str, functions: InterpolationFunctions) {
    for report in reports(functions).flatten() {
        assert!(lost_checks(&report).is_empty() && report.remark.is_none(), "{what}: {report:?}");
    }
}

/// A part 1 that does the same to each angle.
macro_rules! each_angle {
    (|$from:ident, $to:ident, $t:ident| $between:expr) => {
        InterpolationFunctions {
            interpolate_angles: |from, to, t| {
                let $t = t.clamp(0.0, 1.0);
                std::array::from_fn(|axis| {
                    let ($from, $to): (f32, f32) = (from[axis], to[axis]);
                    $between
                })
            },
            ..INTERPOLATION
        }
    };
}

#[test]
fn angles_may_be_in_any_full_turn() {
    assert_all_right(
        "half a turn more, the remainder, half a turn less",
        each_angle!(|from, to, t| from + t * ((to - from + 180.0).rem_euclid(360.0) - 180.0)),
    );
    assert_all_right(
        "from 0 to 360",
        each_angle!(|from, to, t| {
            (from + t * ((to - from + 180.0).rem_euclid(360.0) - 180.0)).rem_euclid(360.0)
        }),
    );
    assert_all_right(
        "back from the second, and two turns below",
        each_angle!(|from, to, t| to - (1.0 - t) * ((to - from + 180.0).rem_euclid(360.0) - 180.0) - 720.0),
    );
    assert_all_right(
        "one turn after the other",
        each_angle!(|from, to, t| {
            let mut to = to;
            while to - from > 180.0 {
                to -= 360.0;
            }
            while to - from < -180.0 {
                to += 360.0;
            }
            from * (1.0 - t) + to * t
        }),
    );
    assert_all_right(
        "by the arc tangent",
        each_angle!(|from, to, t| {
            let (sine, cosine) = (to - from).to_radians().sin_cos();
            from + t * sine.atan2(cosine).to_degrees()
        }),
    );
}

/// A part 2 that is given the shorter way and a `t` between 0 and 1.
macro_rules! shorter {
    (|$from:ident, $to:ident, $t:ident| $between:expr) => {
        InterpolationFunctions {
            slerp: |from, to, t| {
                let $t = t.clamp(0.0, 1.0);
                let $from: Quat = from;
                let $to: Quat = if from.dot(to) < 0.0 { -to } else { to };
                $between
            },
            ..INTERPOLATION
        }
    };
}

#[test]
fn slerp_may_be_written_in_other_ways() {
    assert_all_right(
        "a dot product that is kept at 1, and the first where it is",
        shorter!(|from, to, t| {
            let angle = from.dot(to).min(1.0).acos();
            if angle == 0.0 { from } else { arc(from, to, t, angle) }
        }),
    );
    assert_all_right(
        "the first where the sine is nearly 0",
        shorter!(|from, to, t| {
            let angle = from.dot(to).min(1.0).acos();
            if angle.sin() < 1e-3 { from } else { arc(from, to, t, angle) }
        }),
    );
    assert_all_right(
        "a line that is not brought back to length 1",
        shorter!(|from, to, t| {
            let dot = from.dot(to);
            if dot > 0.9999 { from * (1.0 - t) + to * t } else { arc(from, to, t, dot.acos()) }
        }),
    );
    assert_all_right(
        "the line for all that are less than ten degrees apart",
        shorter!(|from, to, t| {
            let dot = from.dot(to);
            if dot > 0.9962 { (from * (1.0 - t) + to * t).normalize() } else { arc(from, to, t, dot.acos()) }
        }),
    );
    assert_all_right(
        "the angle by the arc tangent of two lengths",
        shorter!(|from, to, t| {
            let angle = 2.0 * (to - from).length().atan2((to + from).length());
            if angle < 1e-6 { from } else { arc(from, to, t, angle) }
        }),
    );
    assert_all_right(
        "in double precision",
        shorter!(|from, to, t| {
            let [a, b] = [from, to].map(|q| q.to_array().map(f64::from));
            let dot: f64 = a.iter().zip(b).map(|(a, b)| a * b).sum();
            let (angle, t) = (dot.min(1.0).acos(), f64::from(t));
            let weights = [((1.0 - t) * angle).sin(), (t * angle).sin()].map(|sine| sine / angle.sin());
            if angle == 0.0 {
                return from;
            }
            Quat::from_array([0, 1, 2, 3].map(|i| (a[i] * weights[0] + b[i] * weights[1]) as f32))
        }),
    );
    assert_all_right(
        "along the sphere from one, towards what of the other is at right angles to it",
        shorter!(|from, to, t| {
            let (a, b) = (Vec4::from(from), Vec4::from(to));
            let aside = b - a * a.dot(b);
            let angle = aside.length().atan2(a.dot(b)) * t;
            Quat::from_vec4(a * angle.cos() + aside.normalize_or_zero() * angle.sin())
        }),
    );
    assert_all_right(
        "a part of the turn from one to the other",
        shorter!(|from, to, t| {
            let turn = (to * from.conjugate()).to_scaled_axis();
            Quat::from_scaled_axis(turn * t) * from
        }),
    );
    assert_all_right(
        "the same by an arc cosine, with an axis of its own",
        shorter!(|from, to, t| {
            let turn = to * from.conjugate();
            let half = turn.w.min(1.0).acos() * t;
            let Some(axis) = turn.xyz().try_normalize() else { return from };
            Quat::from_vec4((axis * half.sin()).extend(half.cos())) * from
        }),
    );
    assert_all_right("glam's, and the other sign", shorter!(|from, to, t| -from.slerp(to, t)));
}

/// Slerp's formula.
fn arc(from: Quat, to: Quat, t: f32, angle: f32) -> Quat {
    (from * ((1.0 - t) * angle).sin() + to * (t * angle).sin()) / angle.sin()
}

/// Part 3 with glam's conversions and an index in place of a cursor. `MATRICES` gives quaternions of either sign.
fn by_glam<const MATRICES: bool>(
    functions: InterpolationFunctions,
    skeleton: &Skeleton,
    [from, to]: [&Frame; 2],
    t: f32,
    representation: Representation,
) -> LocalPose {
    let mut next = 0;
    let rotation = |joint: &Joint| {
        if joint.rotation_order == RotationOrder::None {
            return Quat::IDENTITY;
        }
        let [from, to] = [from, to].map(|frame| [0, 1, 2].map(|place| frame.angles[next + place]));
        next += 3;
        let quaternion = |angles| if MATRICES { by_matrices(joint, angles) } else { by_euler(joint, angles) };
        match representation {
            Representation::Euler => quaternion((functions.interpolate_angles)(from, to, t)),
            Representation::Quaternion => (functions.slerp)(quaternion(from), quaternion(to), t),
        }
    };
    let rotations = skeleton.joints().iter().map(rotation).collect();
    let pairs = from.local_positions.iter().zip(&to.local_positions);
    LocalPose { rotations, positions: pairs.map(|(from, to)| from + (to - from) * t).collect() }
}

fn by_euler(joint: &Joint, angles: [f32; 3]) -> Quat {
    let order = match joint.rotation_order {
        RotationOrder::None => return Quat::IDENTITY,
        RotationOrder::Xyz => EulerRot::XYZ,
        RotationOrder::Xzy => EulerRot::XZY,
        RotationOrder::Yxz => EulerRot::YXZ,
        RotationOrder::Yzx => EulerRot::YZX,
        RotationOrder::Zxy => EulerRot::ZXY,
        RotationOrder::Zyx => EulerRot::ZYX,
    };
    let [a, b, c] = angles.map(f32::to_radians);
    Quat::from_euler(order, a, b, c)
}

fn by_matrices(joint: &Joint, angles: [f32; 3]) -> Quat {
    let turn = |(axis, degrees): (Axis, f32)| Mat3::from_axis_angle(axis.unit(), degrees.to_radians());
    Quat::from_mat3(&joint.rotation_order.axes().unwrap().into_iter().zip(angles).map(turn).product())
}

/// Part 3 like this, with right parts 1 and 2 or with parts that never take the shorter way.
fn frame<const MATRICES: bool, const RIGHT: bool>(
    skeleton: &Skeleton,
    from: &Frame,
    to: &Frame,
    t: f32,
    representation: Representation,
) -> LocalPose {
    let functions = if RIGHT { INTERPOLATION } else { NEVER_SHORTER };
    by_glam::<MATRICES>(functions, skeleton, [from, to], t, representation)
}

/// Wrong in parts 1 and 2.
const NEVER_SHORTER: InterpolationFunctions = InterpolationFunctions {
    interpolate_angles: |from, to, t| std::array::from_fn(|axis| from[axis] + t * (to[axis] - from[axis])),
    slerp: |from, to, t| arc(from, to, t, from.dot(to).acos()),
    interpolate_frame: frame::<false, false>,
};

#[test]
fn a_frame_may_be_put_together_with_what_glam_has() {
    let with = |interpolate_frame| InterpolationFunctions { interpolate_frame, ..INTERPOLATION };
    assert_all_right("Euler angles", with(frame::<false, true>));
    assert_all_right("matrices", with(frame::<true, true>));
}

#[test]
fn wrong_parts_1_and_2_cost_nothing_in_part_3_whatever_the_signs_of_its_quaternions() {
    for interpolate_frame in [frame::<false, false>, frame::<true, false>] {
        for reports in reports(InterpolationFunctions { interpolate_frame, ..NEVER_SHORTER }) {
            assert_eq!(lost_checks(&reports[0]), ["across", "turns", "ends"]);
            assert_eq!(lost_checks(&reports[1]), ["shorter_way", "close", "ends"]);
            assert!(lost_checks(&reports[2]).is_empty(), "{:?}", reports[2]);
        }
    }
}

#[test]
fn a_right_part_3_may_do_without_wrong_parts_1_and_2() {
    let functions =
        InterpolationFunctions { interpolate_frame: INTERPOLATION.interpolate_frame, ..NEVER_SHORTER };
    assert!(reports(functions).all(|reports| lost_checks(&reports[2]).is_empty()));
}

#[test]
fn a_wrong_part_3_costs_points_even_with_wrong_parts_1_and_2() {
    let functions = InterpolationFunctions {
        interpolate_frame: |skeleton, from, to, t, representation| {
            let mut pose = frame::<false, false>(skeleton, from, to, t, representation);
            pose.rotations.iter_mut().for_each(|rotation| *rotation = rotation.conjugate());
            pose
        },
        ..NEVER_SHORTER
    };
    for reports in reports(functions) {
        assert_eq!(lost_checks(&reports[2]), ["euler", "quaternion"]);
    }
}

#[test]
fn a_straight_line_between_what_is_not_close_is_no_other_way() {
    let functions = shorter!(|from, to, t| {
        let dot = from.dot(to);
        if dot > 0.95 { (from * (1.0 - t) + to * t).normalize() } else { arc(from, to, t, dot.acos()) }
    });
    // On many seeds: it must not depend on them.
    for seed in 0..60 {
        let report = marks::report(&exam(seed, &Solutions), 1, Functions::Interpolation(functions));
        assert_eq!(lost_checks(&report), ["near", "shorter_way"], "seed {seed}");
    }
}

/// Part 3 that turns nothing, and parts 1 and 2 that agree with it.
#[test]
fn rotations_that_are_the_same_for_all_joints_are_nobodys_own() {
    let functions = InterpolationFunctions {
        interpolate_angles: |_, _, _| [0.0; 3],
        slerp: |_, _, _| Quat::IDENTITY,
        interpolate_frame: |skeleton, from, to, t, representation| {
            let pose = frame::<false, true>(skeleton, from, to, t, representation);
            LocalPose { rotations: vec![Quat::IDENTITY; skeleton.len()], ..pose }
        },
    };
    for reports in reports(functions) {
        assert_eq!(lost_checks(&reports[2]), ["euler", "quaternion"]);
    }
}
