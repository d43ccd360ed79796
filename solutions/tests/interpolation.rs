//! The reference solution of interpolation: the examples of its own text, and what holds for any rotation and any
//! angle.
#![allow(clippy::unwrap_used)] // Helpers of tests.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use glam::{Quat, Vec3};
use proptest::prelude::*;
use skeleton::{Axis, Channel, Frame, FrameCursor, Joint, Representation, RotationOrder, Skeleton};
use solutions::interpolation::{interpolate_angles, interpolate_frame, slerp};

const HALF: f32 = std::f32::consts::FRAC_1_SQRT_2;

mod angles {
    use super::*;

    #[test]
    fn of_the_example_are_those_it_says() {
        let half_way = interpolate_angles([170.0, 0.0, 30.0], [-170.0, 10.0, 30.0], 0.5);
        assert_eq!(half_way, [180.0, 5.0, 30.0]);
    }

    #[test]
    fn that_are_full_turns_apart_stay_where_they_are() {
        for t in [0.0, 0.25, 1.0] {
            assert_eq!(
                interpolate_angles([10.0, -350.0, 0.0], [730.0, 10.0, -720.0], t),
                [10.0, -350.0, 0.0]
            );
        }
    }

    proptest! {
        #[test]
        fn go_the_shorter_way_evenly(
            from in prop::array::uniform3(any_angle()),
            to in prop::array::uniform3(any_angle()),
            t in 0.0_f32..=1.0,
        ) {
            let [begin, middle, end] = [0.0, t, 1.0].map(|t| interpolate_angles(from, to, t));
            for axis in 0..3 {
                let (from, to) = (from[axis], to[axis]);
                // What is lost by storing angles of this size, and their difference, as `f32`.
                let digits = 4.0 * f64::from(f32::EPSILON) * f64::from(360.0 + from.abs() + to.abs());
                let way = f64::from(end[axis]) - f64::from(from);
                prop_assert_eq!(begin[axis], from);
                prop_assert!(way.abs() <= 180.0 + digits, "{} to {}: {}", from, to, way);
                // The end is the same direction.
                let turns = (f64::from(end[axis]) - f64::from(to)) / 360.0;
                prop_assert!((turns - turns.round()).abs() * 360.0 <= digits, "{} to {}: {}", from, to, way);
                let so_far = f64::from(middle[axis]) - f64::from(from);
                prop_assert!((so_far - f64::from(t) * way).abs() <= digits, "{} to {}: {}", from, to, so_far);
            }
        }

        #[test]
        fn stay_at_the_ends_before_and_after(
            from in prop::array::uniform3(any_angle()),
            to in prop::array::uniform3(any_angle()),
            beyond in 0.0_f32..10.0,
        ) {
            prop_assert_eq!(interpolate_angles(from, to, -beyond), from);
            prop_assert_eq!(interpolate_angles(from, to, 1.0 + beyond), interpolate_angles(from, to, 1.0));
        }
    }

    fn any_angle() -> impl Strategy<Value = f32> {
        prop_oneof![-360.0_f32..360.0, -2_000.0_f32..2_000.0, -1e9_f32..1e9]
    }
}

mod rotations {
    use super::*;

    #[test]
    fn of_the_example_are_those_it_says() {
        let third = slerp(Quat::IDENTITY, Quat::from_xyzw(0.0, 0.0, HALF, HALF), 1.0 / 3.0);
        assert_abs_diff_eq!(third, Quat::from_xyzw(0.0, 0.0, 0.2588, 0.9659), epsilon = 1e-4);
    }

    #[test]
    fn that_are_the_same_or_opposite_as_vectors_are_numbers_all_the_way() {
        let q = Quat::from_xyzw(0.5, -0.5, 0.5, 0.5);
        for to in [q, -q] {
            for t in [0.0, 0.5, 1.0] {
                assert_abs_diff_eq!(slerp(q, to, t), q, epsilon = 1e-6);
            }
        }
    }

    proptest! {
        #[test]
        fn are_unit_quaternions_from_one_to_the_other(from in any_rotation(), to in any_rotation(), t in 0.0_f32..=1.0) {
            prop_assert!((slerp(from, to, t).length() - 1.0).abs() < 1e-6);
            prop_assert!(slerp(from, to, 0.0).dot(from).abs() > 1.0 - 1e-6);
            prop_assert!(slerp(from, to, 1.0).dot(to).abs() > 1.0 - 1e-6);
            prop_assert_eq!(slerp(from, to, -t), slerp(from, to, 0.0));
            prop_assert_eq!(slerp(from, to, 1.0 + t), slerp(from, to, 1.0));
        }

        #[test]
        fn go_the_shorter_way_at_an_even_speed(from in any_rotation(), to in any_rotation(), t in 0.0_f32..=1.0) {
            let between = slerp(from, to, t);
            let whole = angle(from, to);
            // The shorter way is at most half a turn, whichever of its two quaternions a rotation is written as.
            prop_assert!(whole <= std::f64::consts::PI + 1e-3);
            let so_far = angle(from, between);
            prop_assert!((so_far - f64::from(t) * whole).abs() < 2e-3, "{} of {}", so_far, whole);
            prop_assert!((angle(between, to) - f64::from(1.0 - t) * whole).abs() < 2e-3);
            prop_assert!(slerp(from, -to, t).dot(between).abs() > 1.0 - 1e-5);
        }

        #[test]
        fn are_those_of_glam(from in any_rotation(), to in any_rotation(), t in 0.0_f32..=1.0) {
            // Half a turn apart, both ways round are as short.
            prop_assume!(from.dot(to).abs() > 1e-3);
            assert_abs_diff_eq!(slerp(from, to, t), from.slerp(to, t), epsilon = 1e-5);
        }

        #[test]
        fn that_are_close_together_are_off_by_less_than_a_millionth(
            from in any_rotation(),
            axis in prop::array::uniform3(-1.0_f64..1.0),
            half_angle in 0.0_f64..0.05,
            t in 0.0_f32..=1.0,
        ) {
            let length = axis.iter().map(|x| x * x).sum::<f64>().sqrt();
            prop_assume!(length > 0.1);
            let [x, y, z] = axis.map(|x| (x / length * half_angle.sin()) as f32);
            let to = (from * Quat::from_xyzw(x, y, z, half_angle.cos() as f32)).normalize();
            let expected = exact(from, to, t);
            let between = slerp(from, to, t).to_array().map(f64::from);
            let off = between.iter().zip(expected).map(|(is, should)| (is - should).powi(2)).sum::<f64>().sqrt();
            prop_assert!(off < 1e-6, "{}", off);
        }
    }

    /// The formula in double precision, for quaternions that are less than half a turn apart.
    fn exact(from: Quat, to: Quat, t: f32) -> [f64; 4] {
        let ([from, to], t) = ([from, to].map(|q| q.to_array().map(f64::from)), f64::from(t));
        let length = |q: [f64; 4]| q.iter().map(|x| x * x).sum::<f64>().sqrt();
        let difference = std::array::from_fn(|i| to[i] / length(to) - from[i] / length(from));
        let angle = 2.0 * (length(difference) / 2.0).asin();
        let [a, b] =
            if angle < 1e-9 { [1.0 - t, t] } else { [1.0 - t, t].map(|t| (t * angle).sin() / angle.sin()) };
        let sum = std::array::from_fn(|i| a * from[i] + b * to[i]);
        sum.map(|x| x / length(sum))
    }

    /// By how much one is turned against the other, in radians, from 0 to π.
    fn angle(a: Quat, b: Quat) -> f64 {
        let relative = a.conjugate() * b;
        let sine = f64::from(relative.xyz().length());
        2.0 * sine.atan2(f64::from(relative.w.abs()))
    }

    fn any_rotation() -> impl Strategy<Value = Quat> {
        let numbers = prop::array::uniform4(-1.0_f32..1.0)
            .prop_filter("too short", |q| q.iter().map(|x| x * x).sum::<f32>() > 0.1);
        numbers.prop_map(|q| Quat::from_array(q).normalize())
    }
}

mod frames {
    use super::*;

    #[test]
    fn of_the_example_turn_by_45_degrees_in_both_representations() {
        let (skeleton, [from, to]) = example([90.0, 0.0, 0.0]);
        for representation in Representation::ALL {
            let pose = interpolate_frame(&skeleton, &from, &to, 0.5, representation);
            assert_abs_diff_eq!(
                pose.rotations[1],
                Quat::from_rotation_z(45_f32.to_radians()),
                epsilon = 1e-6
            );
            // A joint without angles and an End Site are not turned.
            assert_eq!((pose.rotations[0], pose.rotations[2]), (Quat::IDENTITY, Quat::IDENTITY));
            assert_eq!(pose.positions, [Vec3::new(5.0, -1.0, 0.0), Vec3::Y, Vec3::X]);
        }
    }

    #[test]
    fn of_three_different_angles_do_not_agree() {
        let (skeleton, [from, to]) = example([90.0, 60.0, 30.0]);
        let [angles, quaternions] = Representation::ALL
            .map(|representation| interpolate_frame(&skeleton, &from, &to, 0.5, representation));
        assert!(angles.rotations[1].dot(quaternions.rotations[1]).abs() < 0.999);
        assert_eq!(angles.positions, quaternions.positions);
    }

    /// A joint without angles that moves from the origin to (10, −2, 0); one with the order ZYX, turned from nothing
    /// to these angles; an End Site.
    fn example(angles: [f32; 3]) -> (Skeleton, [Frame; 2]) {
        let mut skeleton = Skeleton::new();
        let root = skeleton.add_joint(None, "root", Vec3::ZERO, [Channel::Position(Axis::X)]).unwrap();
        let channels = [Axis::Z, Axis::Y, Axis::X].map(Channel::Rotation);
        let joint = skeleton.add_joint(Some(root), "joint", Vec3::Y, channels).unwrap();
        skeleton.add_end_site(joint, "End Site", Vec3::X).unwrap();
        let frame = |angles: [f32; 3], root| Frame {
            angles: angles.to_vec(),
            local_positions: vec![root, Vec3::Y, Vec3::X],
        };
        (skeleton, [frame([0.0; 3], Vec3::ZERO), frame(angles, Vec3::new(10.0, -2.0, 0.0))])
    }

    proptest! {
        #[test]
        fn are_parts_1_and_2_for_each_joint_and_straight_lines_for_positions(
            orders in prop::collection::vec(any_order(), 1..6),
            numbers in prop::collection::vec(-400.0_f32..400.0, 60),
            t in -0.5_f32..1.5,
            representation in prop::sample::select(&Representation::ALL[..]),
        ) {
            let mut skeleton = Skeleton::new();
            for order in &orders {
                let channels = order.axes().into_iter().flatten().map(Channel::Rotation).collect::<Vec<_>>();
                let parent = skeleton.joints().last().map(|joint| joint.id);
                skeleton.add_joint(parent, "joint", Vec3::ONE, channels).unwrap();
            }
            let mut numbers = numbers.into_iter().cycle();
            let mut next = |count: usize| numbers.by_ref().take(count).collect::<Vec<f32>>();
            let turning = orders.iter().filter(|order| **order != RotationOrder::None).count();
            let mut frame = || Frame {
                angles: next(3 * turning),
                local_positions: orders.iter().map(|_| Vec3::from_slice(&next(3))).collect(),
            };
            let (from, to) = (frame(), frame());
            let pose = interpolate_frame(&skeleton, &from, &to, t, representation);
            let (mut of_from, mut of_to) = (FrameCursor::new(&from.angles), FrameCursor::new(&to.angles));
            for joint in skeleton.joints() {
                let expected = match representation {
                    _ if joint.rotation_order == RotationOrder::None => Quat::IDENTITY,
                    Representation::Euler => local(joint, &interpolate_angles(of_from.take3(), of_to.take3(), t)),
                    Representation::Quaternion => slerp(local(joint, &of_from.take3()), local(joint, &of_to.take3()), t),
                };
                assert_abs_diff_eq!(pose.rotations[joint.id.0], expected, epsilon = 1e-5);
                let (from, to) = (from.local_positions[joint.id.0], to.local_positions[joint.id.0]);
                let expected = from + t.clamp(0.0, 1.0) * (to - from);
                assert_relative_eq!(pose.positions[joint.id.0], expected, epsilon = 1e-3, max_relative = 1e-5);
            }
            prop_assert_eq!((pose.rotations.len(), pose.positions.len()), (orders.len(), orders.len()));
        }
    }

    /// By part 1 of forward kinematics.
    fn local(joint: &Joint, angles: &[f32]) -> Quat {
        solutions::fk::local_quaternion(joint, &mut FrameCursor::new(angles))
    }

    fn any_order() -> impl Strategy<Value = RotationOrder> {
        prop_oneof![1 => Just(RotationOrder::None), 6 => prop::sample::select(&RotationOrder::ROTATING[..])]
    }
}
