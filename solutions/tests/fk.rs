//! The reference solution of forward kinematics: the examples of its own text, and matrices as a second opinion.
#![allow(clippy::unwrap_used)] // Helpers of tests.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use glam::{Mat3, Quat, Vec3};
use proptest::prelude::*;
use skeleton::{Axis, FrameCursor, Joint, JointId, Pose, RotationOrder, Skeleton, Transform};
use solutions::fk::{global_position, global_quaternion, local_quaternion};

const HALF: f32 = std::f32::consts::FRAC_1_SQRT_2;

mod local_quaternion {
    use super::*;

    #[test]
    fn turns_about_the_axis_of_the_first_angle() {
        let q = local(RotationOrder::Zyx, [90.0, 0.0, 0.0]);
        assert_abs_diff_eq!(q, Quat::from_xyzw(0.0, 0.0, HALF, HALF), epsilon = 1e-6);
        assert_abs_diff_eq!(q * Vec3::X, Vec3::Y, epsilon = 1e-6);
    }

    #[test]
    fn leaves_the_cursor_alone_when_there_is_no_order() {
        let mut cursor = FrameCursor::new(&[1.0, 2.0, 3.0]);
        assert_eq!(local_quaternion(&joint(RotationOrder::None), &mut cursor), Quat::IDENTITY);
        assert_eq!(cursor.taken(), 0);
    }

    proptest! {
        #[test]
        fn is_the_product_of_rotation_matrices_in_the_order_of_the_angles(
            order in prop::sample::select(&RotationOrder::ROTATING[..]),
            angles in prop::array::uniform3(-1000.0_f32..1000.0),
        ) {
            let [a, b, c] = order.axes().unwrap();
            let expected = matrix(a, angles[0]) * matrix(b, angles[1]) * matrix(c, angles[2]);
            let q = local(order, angles);
            assert_relative_eq!(q.length(), 1.0, epsilon = 1e-5);
            assert_abs_diff_eq!(Mat3::from_quat(q), expected, epsilon = 2e-5);
        }
    }

    fn local(order: RotationOrder, angles: [f32; 3]) -> Quat {
        let mut cursor = FrameCursor::new(&angles);
        let q = local_quaternion(&joint(order), &mut cursor);
        assert_eq!((cursor.taken(), cursor.overrun()), (3, false));
        q
    }

    /// Written out, as in any textbook: no quaternion comes near it.
    fn matrix(axis: Axis, degrees: f32) -> Mat3 {
        let (s, c) = degrees.to_radians().sin_cos();
        let rows = match axis {
            Axis::X => [[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]],
            Axis::Y => [[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]],
            Axis::Z => [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]],
        };
        Mat3::from_cols_array_2d(&rows).transpose()
    }
}

mod global_quaternion {
    use super::*;

    #[test]
    fn puts_the_parents_rotation_in_front() {
        let parent = Quat::from_rotation_z(90_f32.to_radians());
        let local = Quat::from_rotation_x(90_f32.to_radians());
        let global = global_quaternion(&child(), local, &pose(parent, Vec3::ZERO));
        assert_abs_diff_eq!(global, Quat::from_xyzw(0.5, 0.5, 0.5, 0.5), epsilon = 1e-6);
        assert_abs_diff_eq!(global * Vec3::X, Vec3::Y, epsilon = 1e-6);
        assert_abs_diff_eq!(global * Vec3::Y, Vec3::Z, epsilon = 1e-6);
    }

    #[test]
    fn of_a_root_is_its_local_one() {
        let local = Quat::from_rotation_x(1.0);
        let nobody = Pose::identity(1);
        assert_eq!(global_quaternion(&joint(RotationOrder::Xyz), local, &nobody), local);
    }
}

mod global_position {
    use super::*;

    #[test]
    fn begins_at_the_parent_and_goes_along_its_axes() {
        let pose = pose(Quat::from_rotation_z(90_f32.to_radians()), Vec3::new(10.0, 0.0, 0.0));
        let position = global_position(&child(), Vec3::new(2.0, 0.0, 0.0), &pose);
        assert_abs_diff_eq!(position, Vec3::new(10.0, 2.0, 0.0), epsilon = 1e-5);
    }

    #[test]
    fn of_a_root_is_its_local_one() {
        let nobody = Pose::identity(1);
        assert_eq!(global_position(&joint(RotationOrder::Xyz), Vec3::ONE, &nobody), Vec3::ONE);
    }

    proptest! {
        #[test]
        fn keeps_the_length_of_the_bone(
            angles in prop::array::uniform3(-3.0_f32..3.0),
            at in prop::array::uniform3(-50.0_f32..50.0),
            bone in prop::array::uniform3(-50.0_f32..50.0),
        ) {
            let [x, y, z] = angles;
            let rotation = Quat::from_rotation_x(x) * Quat::from_rotation_y(y) * Quat::from_rotation_z(z);
            let (at, bone) = (Vec3::from(at), Vec3::from(bone));
            let position = global_position(&child(), bone, &pose(rotation, at));
            assert_abs_diff_eq!(position.distance(at), bone.length(), epsilon = 1e-3);
        }
    }
}

fn joint(rotation_order: RotationOrder) -> Joint {
    let mut skeleton = Skeleton::new();
    let id = skeleton.add_joint(None, "joint", Vec3::ZERO, []).unwrap();
    Joint { rotation_order, ..skeleton.get(id).unwrap().clone() }
}

/// A joint whose parent is joint 0.
fn child() -> Joint {
    Joint { id: JointId(1), parent: Some(JointId(0)), ..joint(RotationOrder::Xyz) }
}

/// The parent as given, and the child not yet visited.
fn pose(rotation: Quat, position: Vec3) -> Pose {
    vec![Transform { rotation, position }, Transform::IDENTITY].into()
}
