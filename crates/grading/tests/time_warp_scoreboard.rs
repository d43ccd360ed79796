//! The scoreboard of the exercise on time warping, word for word. After a change,
//! `FK_LAB_BLESS=1 cargo test -p grading --test time_warp_scoreboard` writes the expected texts again: look at them before
//! you keep them.

#[path = "support/golden.rs"]
mod golden;

use exam::Functions;
use glam::{Quat, Vec3, Vec4};
use grading::time_warp::TEMPLATE;
use skeleton::acclaim::{Between, Posture, TimeWarpFunctions};
use solutions::TIME_WARP;

#[test]
fn not_started() {
    check("not_started", TEMPLATE);
}

#[test]
fn all_right() {
    check("all_right", TIME_WARP);
}

/// What is often written first: single precision, no look at the end, and angles in quaternions.
#[test]
fn ceil_and_angles_in_quaternions() {
    fn old_position(new_frame: usize, old_count: usize, new_count: usize) -> Between {
        let ratio = old_count as f32 / new_count as f32;
        let place = ratio * new_frame as f32;
        Between { before: place.floor() as usize, after: place.ceil() as usize, t: place - place.floor() }
    }
    /// As long as such numbers are, Eigen's slerp is a straight line.
    fn slerp(from: [f32; 3], to: [f32; 3], t: f32) -> [f32; 3] {
        let [from, to] = [from, to].map(|[x, y, z]| Vec4::new(x, y, z, 0.0));
        let to = if from.dot(to) < 0.0 { -to } else { to };
        from.lerp(to, t).truncate().to_array()
    }
    fn blend(from: &Posture, to: &Posture, t: f32) -> Posture {
        let angles = from.angles.iter().zip(&to.angles).map(|(from, to)| slerp(*from, *to, t));
        let translations = from.translations.iter().zip(&to.translations);
        Posture {
            angles: angles.collect(),
            translations: translations.map(|(from, to)| from.lerp(*to, t)).collect(),
        }
    }
    fn warp(postures: &[Posture], new_count: usize) -> Vec<Posture> {
        let frame = |frame| {
            let Between { before, after, t } = old_position(frame, postures.len(), new_count);
            blend(&postures[before], &postures[after], t)
        };
        (0..new_count).map(frame).collect()
    }
    check("often", TimeWarpFunctions { old_position, blend, warp });
}

/// The mapping that keeps both ends; a quaternion's numbers as angles, and a root alone. Part 3 puts together what there is.
#[test]
fn both_ends_kept_and_numbers_as_angles() {
    fn old_position(new_frame: usize, old_count: usize, new_count: usize) -> Between {
        let steps = new_count.saturating_sub(1).max(1) as f64;
        let place = new_frame as f64 * (old_count - 1) as f64 / steps;
        Between { before: place.floor() as usize, after: place.ceil() as usize, t: place.fract() as f32 }
    }
    fn blend(from: &Posture, to: &Posture, t: f32) -> Posture {
        let quaternion = |[x, y, z]: [f32; 3]| {
            let turn = |axis, degrees: f32| Quat::from_axis_angle(axis, degrees.to_radians());
            turn(Vec3::Z, z) * turn(Vec3::Y, y) * turn(Vec3::X, x)
        };
        let angles = from.angles.iter().zip(&to.angles);
        let mut translations = from.translations.clone();
        translations[0] = translations[0].lerp(to.translations[0], t);
        Posture {
            angles: angles
                .map(|(from, to)| quaternion(*from).slerp(quaternion(*to), t).xyz().to_array())
                .collect(),
            translations,
        }
    }
    fn warp(postures: &[Posture], new_count: usize) -> Vec<Posture> {
        let frame = |frame| {
            let Between { before, after, t } = old_position(frame, postures.len(), new_count);
            blend(&postures[before], &postures[after], t)
        };
        if postures.is_empty() { Vec::new() } else { (0..new_count).map(frame).collect() }
    }
    check("both_ends", TimeWarpFunctions { old_position, blend, warp });
}

#[test]
fn a_mistake_without_a_name_and_a_panic() {
    fn slower(new_frame: usize, old_count: usize, new_count: usize) -> Between {
        let right = (TIME_WARP.old_position)(new_frame, old_count, new_count);
        Between { t: right.t * right.t, ..right }
    }
    fn panics(from: &Posture, to: &Posture, t: f32) -> Posture {
        assert!(t < 1.0, "what is t = {t}?");
        (TIME_WARP.blend)(from, to, t)
    }
    fn backwards(postures: &[Posture], new_count: usize) -> Vec<Posture> {
        let mut warped = (TIME_WARP.warp)(postures, new_count);
        warped.reverse();
        warped
    }
    check("no_name_and_panic", TimeWarpFunctions { old_position: slower, blend: panics, warp: backwards });
}

fn check(name: &str, functions: TimeWarpFunctions) {
    golden::check(&format!("time_warp_{name}"), Functions::TimeWarp(functions));
}
