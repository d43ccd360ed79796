//! One joint, turned from one set of angles to another.

use glam::Quat;
use skeleton::{Axis, RotationOrder};
use solutions::interpolation::{interpolate_angles, slerp};

use super::tables::{header, row};

/// Three angles in the order ZXY, in degrees, and three others.
const TURNS: [([f32; 3], [f32; 3]); 7] = [
    ([0.0, 0.0, 0.0], [120.0, 0.0, 0.0]),
    ([0.0, 0.0, 0.0], [10.0, 10.0, 10.0]),
    ([0.0, 0.0, 0.0], [45.0, 45.0, 45.0]),
    ([0.0, 0.0, 0.0], [90.0, 90.0, 90.0]),
    ([0.0, 0.0, 0.0], [150.0, 60.0, -120.0]),
    ([10.0, 80.0, 0.0], [-170.0, 80.0, 180.0]),
    ([0.0, 0.0, 0.0], [180.0, 180.0, 180.0]),
];

/// The way is measured in so many steps.
const STEPS: u16 = 1000;

/// How far the two interpolations turn, and how far they are apart.
pub fn table() -> String {
    let mut text =
        header(&["from Z, X, Y", "to Z, X, Y", "quaternions turn by", "Euler angles turn by", "most apart"]);
    for (from, to) in TURNS {
        let (start, end) = (quaternion(from), quaternion(to));
        let (mut way, mut apart) = (0.0_f32, 0.0_f32);
        let mut before = start;
        for step in 1..=STEPS {
            let t = f32::from(step) / f32::from(STEPS);
            let euler = quaternion(interpolate_angles(from, to, t));
            way += angle(before, euler);
            apart = apart.max(angle(slerp(start, end, t), euler));
            before = euler;
        }
        let degrees = |angle: f32| format!("{:.0}°", angle + 0.0);
        let numbers =
            |angles: [f32; 3]| angles.map(|angle| format!("{angle:.0}°").replace('-', "−")).join(", ");
        text += &row(&[numbers(from), numbers(to), degrees(angle(start, end)), degrees(way), degrees(apart)]);
    }
    text
}

fn quaternion(angles: [f32; 3]) -> Quat {
    let axes = RotationOrder::Zxy.axes().unwrap_or(Axis::ALL);
    let turns = axes.iter().zip(angles);
    turns.map(|(axis, angle)| Quat::from_axis_angle(axis.unit(), angle.to_radians())).product()
}

/// The angle between two rotations in degrees. By the arc cosine, small ones would be lost.
fn angle(a: Quat, b: Quat) -> f32 {
    let rest = a.inverse() * b;
    (2.0 * rest.xyz().length().atan2(rest.w.abs())).to_degrees()
}
