//! The scoreboard of the exercise on interpolation, word for word. After a change,
//! `FK_LAB_BLESS=1 cargo test -p grading --test interpolation_scoreboard` writes the expected texts again: look at them
//! before you keep them.

#[path = "support/golden.rs"]
mod golden;

use exam::Functions;
use glam::Quat;
use grading::interpolation;
use skeleton::{
    Axis, Frame, FrameCursor, InterpolationFunctions, Joint, LocalPose, Representation, RotationOrder,
    Skeleton,
};
use solutions::INTERPOLATION;

#[test]
fn not_started() {
    check("not_started", interpolation::TEMPLATE);
}

#[test]
fn all_right() {
    check("all_right", INTERPOLATION);
}

/// What many write first: numbers in a straight line, and the formula with nothing around it. Part 3 is right.
#[test]
fn the_shorter_way_is_nowhere() {
    fn straight(from: [f32; 3], to: [f32; 3], t: f32) -> [f32; 3] {
        std::array::from_fn(|axis| from[axis] + t * (to[axis] - from[axis]))
    }
    fn formula(from: Quat, to: Quat, t: f32) -> Quat {
        let angle = from.dot(to).acos();
        (from * ((1.0 - t) * angle).sin() + to * (t * angle).sin()) / angle.sin()
    }
    fn frame(
        skeleton: &Skeleton,
        from: &Frame,
        to: &Frame,
        t: f32,
        representation: Representation,
    ) -> LocalPose {
        let mut ends = [from, to].map(|frame| FrameCursor::new(&frame.angles));
        let rotation = |joint: &Joint| {
            if joint.rotation_order == RotationOrder::None {
                return Quat::IDENTITY;
            }
            let [from, to] = ends.each_mut().map(FrameCursor::take3);
            match representation {
                Representation::Euler => quaternion(joint, straight(from, to, t)),
                Representation::Quaternion => formula(quaternion(joint, from), quaternion(joint, to), t),
            }
        };
        let rotations = skeleton.joints().iter().map(rotation).collect();
        let pairs = from.local_positions.iter().zip(&to.local_positions);
        LocalPose { rotations, positions: pairs.map(|(from, to)| from.lerp(*to, t)).collect() }
    }
    let functions =
        InterpolationFunctions { interpolate_angles: straight, slerp: formula, interpolate_frame: frame };
    check("shorter_way_nowhere", functions);
}

/// Parts 1 and 2 are right; part 3 hands angles to slerp and lets only the root move.
#[test]
fn angles_in_quaternions_and_a_root_alone() {
    fn frame(
        skeleton: &Skeleton,
        from: &Frame,
        to: &Frame,
        t: f32,
        representation: Representation,
    ) -> LocalPose {
        let mut pose = (INTERPOLATION.interpolate_frame)(skeleton, from, to, t, representation);
        let mut ends = [from, to].map(|frame| FrameCursor::new(&frame.angles));
        for joint in skeleton.joints() {
            if joint.rotation_order != RotationOrder::None && representation == Representation::Quaternion {
                let packed = |[x, y, z]: [f32; 3]| Quat::from_xyzw(x, y, z, 0.0).normalize();
                let [from, to] = ends.each_mut().map(|angles| packed(angles.take3()));
                pose.rotations[joint.id.0] = (INTERPOLATION.slerp)(from, to, t);
            }
            if !joint.is_root() {
                pose.positions[joint.id.0] = joint.offset;
            }
        }
        pose
    }
    check("angles_in_quaternions", InterpolationFunctions { interpolate_frame: frame, ..INTERPOLATION });
}

#[test]
fn a_mistake_without_a_name_and_a_panic() {
    fn slower(from: [f32; 3], to: [f32; 3], t: f32) -> [f32; 3] {
        (INTERPOLATION.interpolate_angles)(from, to, t * t)
    }
    fn panics(from: Quat, to: Quat, t: f32) -> Quat {
        if !(0.0..=1.0).contains(&t) {
            panic!("t is {t}?");
        }
        (INTERPOLATION.slerp)(from, to, t)
    }
    let functions = InterpolationFunctions { interpolate_angles: slower, slerp: panics, ..INTERPOLATION };
    check("no_name_and_panic", functions);
}

fn quaternion(joint: &Joint, angles: [f32; 3]) -> Quat {
    let turn = |(axis, degrees): (Axis, f32)| Quat::from_axis_angle(axis.unit(), degrees.to_radians());
    joint.rotation_order.axes().into_iter().flatten().zip(angles).map(turn).product()
}

fn check(name: &str, functions: InterpolationFunctions) {
    golden::check(&format!("interpolation_{name}"), Functions::Interpolation(functions));
}
