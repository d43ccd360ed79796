use glam::EulerRot;
use proptest::prelude::*;
use skeleton::RotationOrder;

use super::*;

/// The rotation of some angles in degrees: the product of the turns, by another way than that which is tested.
fn product(axes: &[Axis], angles: [f64; 3]) -> Quat {
    let turn = |(axis, angle): (&Axis, f64)| {
        // Reduced first: what an `f32` holds of a large angle is coarse.
        Quat::from_axis_angle(axis.unit(), (angle % 720.0).to_radians() as f32)
    };
    axes.iter().zip(angles).map(turn).product()
}

/// The angle between two rotations in degrees.
fn between(a: Quat, b: Quat) -> f64 {
    let rest = a.inverse() * b;
    f64::from(2.0 * rest.xyz().length().atan2(rest.w.abs())).to_degrees()
}

fn orders() -> impl Strategy<Value = [Axis; 3]> {
    prop::sample::select(RotationOrder::ROTATING.to_vec()).prop_map(|order| order.axes().unwrap())
}

fn rotations() -> impl Strategy<Value = Quat> {
    let part = || prop_oneof![4 => -1.0f32..1.0, 1 => Just(0.0f32), 1 => -1e-6f32..1e-6];
    [part(), part(), part(), part()]
        .prop_map(Quat::from_array)
        .prop_filter("nothing to normalise", |quat| quat.length() > 1e-3)
        .prop_map(Quat::normalize)
}

fn angles(limit: f64) -> impl Strategy<Value = [f64; 3]> {
    let angle = || prop_oneof![3 => -limit..limit, 1 => Just(0.0), 1 => Just(90.0), 1 => Just(-180.0)];
    [angle(), angle(), angle()]
}

fn assert_close(found: [f64; 3], expected: [f64; 3], tolerance: f64) -> Result<(), TestCaseError> {
    for (found_angle, expected_angle) in found.iter().zip(expected) {
        let close = (found_angle - expected_angle).abs() < tolerance;
        prop_assert!(close, "{found:?} and {expected:?}");
    }
    Ok(())
}

proptest! {
    #[test]
    fn three_angles_make_every_rotation_in_every_order(
        rotation in rotations(), axes in orders(), near in angles(1e5),
    ) {
        let found = angles_of(rotation, &axes, near);
        prop_assert!(between(product(&axes, found), rotation) < 1e-3, "{found:?}");
        prop_assert!(distance(rotation, &axes, found) < 2e-4, "{found:?}");
        prop_assert!(found.iter().all(|angle| angle.abs() <= LARGEST + 1e-6), "{found:?}");
    }

    /// A middle angle of 90 degrees included, where two of the three angles are free to go against each other.
    #[test]
    fn angles_come_back_when_they_are_those_to_stay_close_to(
        axes in orders(), expected in angles(3000.0), channels in 1usize..=3, noise in [-20.0f64..20.0, -20.0..20.0, -20.0..20.0],
    ) {
        let expected = std::array::from_fn(|at| if at < channels { expected[at] } else { 0.0 });
        let axes = &axes[..channels];
        let rotation = product(axes, expected);
        // Close to a gimbal lock a small turn needs large changes of angles.
        let steep = channels == 3 && expected[1].to_radians().cos().abs() < 0.1;
        let (noise, tolerance) = if steep { ([0.0; 3], 0.5) } else { (noise, 0.01) };
        let near = std::array::from_fn(|at| expected[at] + noise[at]);
        let found = angles_of(rotation, axes, near);
        assert_close(found, expected, tolerance)?;
        prop_assert!(distance(rotation, axes, found) < 2e-4);
    }

    #[test]
    fn in_a_gimbal_lock_the_angles_change_as_little_as_they_can(
        axes in orders(), lock in prop::sample::select(vec![90.0, -90.0, 270.0]),
        outer in angles(400.0), moved in -20.0f64..20.0,
    ) {
        let near = [outer[0], lock, outer[2]];
        let rotation = product(&axes, [near[0] + moved, lock, near[2]]);
        let found = angles_of(rotation, &axes, near);
        prop_assert!(distance(rotation, &axes, found) < 2e-4);
        // The change is shared by both of the outer angles, which turn about the same line.
        prop_assert!((found[0] - near[0]).abs() <= moved.abs() / 2.0 + 0.1, "{found:?} near {near:?}");
        prop_assert!((found[2] - near[2]).abs() <= moved.abs() / 2.0 + 0.1, "{found:?} near {near:?}");
    }

    #[test]
    fn with_too_few_channels_no_other_angles_come_closer(
        rotation in rotations(), axes in orders(), channels in 1usize..=2,
    ) {
        let axes = &axes[..channels];
        let found = angles_of(rotation, axes, [0.0; 3]);
        let best = distance(rotation, axes, found);
        let seconds = if channels == 2 { 0..72 } else { 0..1 };
        for (first, second) in (0..72).flat_map(|first| seconds.clone().map(move |second| (first, second))) {
            let other = [f64::from(first) * 5.0, f64::from(second) * 5.0, 0.0];
            let found_other = distance(rotation, axes, other);
            prop_assert!(found_other > best - 1e-3, "{found:?}: {best}, {other:?}: {found_other}");
        }
    }

    /// Away from a gimbal lock angles change at most so much faster than the rotation as the middle axis allows.
    #[test]
    fn along_a_way_between_two_rotations_angles_do_not_jump(
        from in rotations(), to in rotations(), axes in orders(), start in angles(1000.0),
    ) {
        const STEPS: u16 = 400;
        let step = between(from, to).max(0.1) / f64::from(STEPS);
        let mut before = angles_of(from, &axes, start);
        for number in 1..=STEPS {
            let rotation = from.slerp(to, f32::from(number) / f32::from(STEPS));
            let found = angles_of(rotation, &axes, before);
            let slope = found[1].to_radians().cos().abs().min(before[1].to_radians().cos().abs());
            if slope > 0.2 {
                assert_close(found, before, 1.5 * step / slope + 0.01)?;
            }
            before = found;
        }
    }
}

/// A quarter turn about Z is as far from all turns about X and Y by the same angle, and by angles a full turn apart.
#[test]
fn of_angles_that_come_equally_close_those_nearby_are_taken() {
    let quarter = Quat::from_axis_angle(Axis::Z.unit(), std::f32::consts::FRAC_PI_2);
    let cases = [([100.0, 20.0], [60.0, 60.0]), ([200.0, 0.0], [280.0, -80.0])];
    for (near, expected) in cases {
        let found = angles_of(quarter, &[Axis::X, Axis::Y], [near[0], near[1], 0.0]);
        let close = (found[0] - expected[0]).abs() < 1e-3 && (found[1] - expected[1]).abs() < 1e-3;
        assert!(close, "{found:?} near {near:?}");
    }
    assert_eq!(angles_of(quarter * quarter, &[Axis::X], [77.0, 0.0, 0.0])[0].round(), 77.0);
}

#[test]
fn turns_are_multiplied_in_the_order_of_their_axes() {
    let other_way =
        [EulerRot::ZYX, EulerRot::YZX, EulerRot::ZXY, EulerRot::XZY, EulerRot::YXZ, EulerRot::XYZ];
    for (order, other_way) in RotationOrder::ROTATING.into_iter().zip(other_way) {
        let [a, b, c] = [20.0_f32, 50.0, -70.0];
        let expected = Quat::from_euler(other_way, a.to_radians(), b.to_radians(), c.to_radians());
        let axes = order.axes().unwrap();
        assert!(between(rotation_of(&axes, [a, b, c]), expected) < 1e-4, "{order}");
    }
    assert_eq!(rotation_of(&[], []), Quat::IDENTITY);
}

#[test]
fn the_distance_is_that_of_a_known_turn() {
    let quarter = Quat::from_axis_angle(Axis::X.unit(), std::f32::consts::FRAC_PI_2);
    assert!((distance(quarter, &[Axis::Y], [0.0; 3]) - 90.0).abs() < 1e-3);
    assert!(distance(quarter, &[Axis::Y, Axis::X], [0.0, 90.0, 0.0]) < 1e-3);
    assert!((distance(-quarter, &[], [0.0; 3]) - 90.0).abs() < 1e-3);
}

#[test]
fn what_no_number_is_stays_no_number() {
    assert!(angles_of(Quat::from_array([f32::NAN; 4]), &[Axis::X, Axis::Y, Axis::Z], [0.0; 3])[0].is_nan());
}
