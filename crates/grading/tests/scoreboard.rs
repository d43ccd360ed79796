//! The scoreboard, word for word. After a change, `FK_LAB_BLESS=1 cargo test -p grading --test scoreboard` writes the
//! expected texts again: look at them before you keep them.
#![allow(clippy::approx_constant)] // A short π.

#[path = "support/golden.rs"]
mod golden;

use exam::Functions;
use glam::{Quat, Vec3};
use grading::fk;
use skeleton::{FkFunctions, FrameCursor, Joint, Pose};

#[test]
fn not_started() {
    check("not_started", fk::TEMPLATE);
}

#[test]
fn all_right() {
    check("all_right", solutions::FK);
}

#[test]
fn reversed_order() {
    fn reversed(joint: &Joint, frame: &mut FrameCursor) -> Quat {
        let Some(axes) = joint.rotation_order.axes() else { return Quat::IDENTITY };
        let factors = axes.into_iter().zip(frame.take3());
        factors.fold(Quat::IDENTITY, |all, (axis, angle)| {
            Quat::from_axis_angle(axis.unit(), angle.to_radians()) * all
        })
    }
    check("reversed_order", FkFunctions { local_quaternion: reversed, ..solutions::FK });
}

#[test]
fn short_pi_and_a_cursor_that_stands_still() {
    fn peek(joint: &Joint, frame: &mut FrameCursor) -> Quat {
        let Some(axes) = joint.rotation_order.axes() else { return Quat::IDENTITY };
        let factors = axes.into_iter().zip(frame.peek3());
        factors.fold(Quat::IDENTITY, |all, (axis, angle)| {
            all * Quat::from_axis_angle(axis.unit(), angle * 3.14 / 180.0)
        })
    }
    check("short_pi_and_cursor", FkFunctions { local_quaternion: peek, ..solutions::FK });
}

#[test]
fn a_mistake_without_a_name_and_a_panic() {
    fn half(joint: &Joint, local: Quat, pose: &Pose) -> Quat {
        joint.parent.map_or(local, |parent| pose[parent].rotation.slerp(local, 0.25))
    }
    fn panics(joint: &Joint, local: Vec3, pose: &Pose) -> Vec3 {
        if joint.is_root() {
            panic!("a root?");
        }
        solutions::fk::global_position(joint, local, pose)
    }
    let functions = FkFunctions { global_quaternion: half, global_position: panics, ..solutions::FK };
    check("no_name_and_panic", functions);
}

fn check(name: &str, functions: FkFunctions) {
    golden::check(name, Functions::Fk(functions));
}
