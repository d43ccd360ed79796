//! Angles to rotations and back.

use glam::{EulerRot, Mat3, Quat};
use skeleton::RotationOrder;

/// The product of the rotations about X, Y and Z by `angles` (degrees) in this order.
pub(super) fn rotation(order: RotationOrder, angles: [f32; 3]) -> Quat {
    let [x, y, z] = angles.map(f32::to_radians);
    match order {
        RotationOrder::None => Quat::IDENTITY,
        RotationOrder::Zyx => Quat::from_euler(EulerRot::ZYX, z, y, x),
        RotationOrder::Yzx => Quat::from_euler(EulerRot::YZX, y, z, x),
        RotationOrder::Zxy => Quat::from_euler(EulerRot::ZXY, z, x, y),
        RotationOrder::Xzy => Quat::from_euler(EulerRot::XZY, x, z, y),
        RotationOrder::Yxz => Quat::from_euler(EulerRot::YXZ, y, x, z),
        RotationOrder::Xyz => Quat::from_euler(EulerRot::XYZ, x, y, z),
    }
}

/// The angles about Z, Y and X, in degrees, of a rotation Rz * Ry * Rx. Of the many that there are, those nearest to
/// `near`: other whole turns, and the other way round about Y, give the same rotation.
pub(super) fn zyx_near(rotation: Quat, near: [f32; 3]) -> [f32; 3] {
    let m = Mat3::from_quat(rotation);
    let flat = m.x_axis.x.hypot(m.x_axis.y);
    // Where Y is a quarter turn, Z and X turn about the same axis. Then Z can stay as it was, and X does all.
    let z = if flat < 1e-6 { near[0].to_radians() } else { m.x_axis.y.atan2(m.x_axis.x) };
    let y = (-m.x_axis.z).atan2(flat);
    // What is left when Z has been turned back: so X makes up for whatever Z is.
    let (sin, cos) = z.sin_cos();
    let x = (sin * m.z_axis.x - cos * m.z_axis.y).atan2(cos * m.y_axis.y - sin * m.y_axis.x);
    let one = [z, y, x].map(f32::to_degrees);
    let other = [one[0] + 180.0, 180.0 - one[1], one[2] + 180.0];
    let [one, other] = [one, other].map(|angles| turned_near(angles, near));
    if distance(one, near) <= distance(other, near) { one } else { other }
}

/// The same angles, whole turns more or less, so that each is within half a turn of `near`.
fn turned_near(angles: [f32; 3], near: [f32; 3]) -> [f32; 3] {
    std::array::from_fn(|i| angles[i] + 360.0 * ((near[i] - angles[i]) / 360.0).round())
}

fn distance(one: [f32; 3], other: [f32; 3]) -> f32 {
    one.into_iter().zip(other).map(|(a, b)| (a - b).abs()).sum()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use skeleton::Axis;

    use super::*;

    fn angle_between(one: Quat, other: Quat) -> f32 {
        // Twice the arc sine of the vector part: the arc cosine loses small angles.
        let difference = one.inverse() * other;
        2.0 * difference.xyz().length().atan2(difference.w.abs()).to_degrees()
    }

    #[test]
    fn rotations_are_multiplied_in_their_order() {
        let angles = [20.0, 50.0, -70.0];
        for order in RotationOrder::ROTATING {
            let turn = |axis: Axis| Quat::from_axis_angle(axis.unit(), f32::to_radians(angles[axis.index()]));
            let product = order.axes().expect("three axes").map(turn).into_iter().product::<Quat>();
            assert!(angle_between(rotation(order, angles), product) < 1e-4, "{order}");
        }
        assert_eq!(rotation(RotationOrder::None, angles), Quat::IDENTITY);
    }

    #[test]
    fn angles_do_not_leap_where_y_passes_a_quarter_turn() {
        let mut last = [170.0, 80.0, -100.0];
        for step in 0..400 {
            let wanted = [170.0 + 0.1 * step as f32, 80.0 + 0.05 * step as f32, -100.0];
            let rotation = rotation(RotationOrder::Zyx, [wanted[2], wanted[1], wanted[0]]);
            let angles = zyx_near(rotation, last);
            let leap = angles.iter().zip(last).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
            assert!(leap < 0.5 || (wanted[1] - 90.0).abs() < 0.06, "{last:?} to {angles:?} at {wanted:?}");
            assert!(leap < 6.0, "{last:?} to {angles:?} at {wanted:?}");
            last = angles;
        }
        assert!(last[1] > 99.0 && last[0] > 209.0, "{last:?}");
    }

    fn any_angle() -> impl Strategy<Value = f32> {
        prop_oneof![
            -720f32..720.0,
            prop::sample::select(vec![0.0, 90.0, -90.0, 180.0, 270.0, 89.9999, 90.0001])
        ]
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]

        #[test]
        fn angles_give_back_the_rotation(
            [z, y, x] in prop::array::uniform3(any_angle()),
            near in prop::array::uniform3(any_angle()),
        ) {
            let wanted = rotation(RotationOrder::Zyx, [x, y, z]);
            let angles = zyx_near(wanted, near);
            let [z, y, x] = angles;
            let off = angle_between(rotation(RotationOrder::Zyx, [x, y, z]), wanted);
            prop_assert!(off < 3e-4, "off by {off}° with {angles:?}");
            for (angle, near) in angles.into_iter().zip(near) {
                prop_assert!((angle - near).abs() < 180.1);
            }
        }
    }
}
