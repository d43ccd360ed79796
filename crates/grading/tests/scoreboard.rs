//! The scoreboard, word for word. After a change, `FK_LAB_BLESS=1 cargo test -p grading --test scoreboard` writes the
//! expected texts again: look at them before you keep them.
#![allow(clippy::unwrap_used, clippy::approx_constant)] // Helpers of tests, and a short π.

use std::time::Duration;
use std::{env, fs};

use exam::{Answer, Failure, Functions, InProcess, Question, Subject};
use glam::{Quat, Vec3};
use grading::{Graded, PUBLIC_SEED, Solutions, fk};
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

/// Counts how often it was to forget everything.
struct Restarted(InProcess, usize);

impl Subject for Restarted {
    fn ask(&mut self, question: &Question, limit: Duration) -> Result<Answer, Failure> {
        self.0.ask(question, limit)
    }

    fn restart(&mut self) {
        self.1 += 1;
    }
}

fn check(name: &str, functions: FkFunctions) {
    let exam = fk::exam(PUBLIC_SEED, &Solutions);
    let mut subject = Restarted(InProcess(Functions::Fk(functions)), 0);
    let graded = Graded::ask(&mut subject, &exam, grading::CHECK_LIMIT);
    assert_eq!(
        subject.1,
        exam.parts.len() + 1,
        "every part, and the whole motion, meets functions that keep nothing"
    );
    let scoreboard = graded.scoreboard(&exam);
    let styled = scoreboard.to_string();
    assert!(styled.ends_with(&scoreboard.summary().to_string()));
    for row in scoreboard.rows() {
        assert!(styled.contains(&format!("\n  {row}\n")), "{row}");
        assert!(row.named.iter().all(|named| styled.contains(named.title)), "{row}");
    }
    assert!(styled.contains(&scoreboard.verdict()) && scoreboard.verdict().ends_with(" of 15 points."));
    let plain = anstream::adapter::strip_str(&styled).to_string();
    assert!(plain.lines().all(|line| line.chars().count() <= 110), "{plain}");

    let path = format!("{}/tests/golden/{name}.txt", env!("CARGO_MANIFEST_DIR"));
    // Where a function panics depends on this file's lines.
    let here =
        plain.split_whitespace().find(|word| word.contains("scoreboard.rs:")).unwrap_or("no such word");
    let plain = plain.replace(here, "FILE:LINE:COLUMN:");
    if env::var_os("FK_LAB_BLESS").is_some() {
        fs::write(&path, &plain).unwrap();
    }
    let expected = fs::read_to_string(&path).unwrap();
    assert_eq!(plain, expected, "{path}");
}
