//! The legs of the runner: planted while they bear weight, swung between.

use super::course::Course;
use super::pelvis::Pelvis;
use super::steps::{Step, Steps};
use crate::humanoid::Side;
use crate::leg::LegAngles;
use crate::math::{lerp, wobble};
use crate::spline::Spline;

/// The angles of one leg at `time`, in seconds.
pub fn leg(course: &Course, steps: &Steps, side: Side, time: f64) -> LegAngles {
    match steps.of(side, time) {
        None => LegAngles::default(),
        Some([step, _]) if time < step.off => standing(course, steps, step, time),
        Some([step, next]) => swinging(course, steps, step, next, time),
    }
}

/// The foot stands: the leg reaches for it.
fn standing(course: &Course, steps: &Steps, step: &Step, time: f64) -> LegAngles {
    let pelvis = Pelvis::at(course, steps, time);
    let knee_heading = lerp(course.at(time).heading, step.heading, 0.5);
    LegAngles::reaching(pelvis.hip(step.side), pelvis.rotation, step.foot(time), knee_heading)
}

/// The angles in flexion through which a swinging leg passes: (part of the swing, degrees).
///
/// After the curves of Novacheck 1998 (figures 5 to 7) and Mann and Hagy 1980 for running at 3 to 4 m/s: the thigh goes on
/// back for a moment, the knee folds to a good 100°, the thigh swings up to 45°, and the leg opens to meet the ground.
const HIP: [(f64, f64); 4] = [(0.14, -27.0), (0.46, 14.0), (0.68, 43.0), (0.87, 33.0)];
const KNEE: [(f64, f64); 4] = [(0.24, 50.0), (0.50, 105.0), (0.74, 60.0), (0.90, 24.0)];
const ANKLE: [(f64, f64); 3] = [(0.14, -24.0), (0.45, -6.0), (0.80, 5.0)];
const TOES: [(f64, f64); 2] = [(0.25, 8.0), (0.60, 0.0)];

/// The foot is in the air: every angle follows a curve that takes over place and speed from the step before and hands
/// them to the next one.
fn swinging(course: &Course, steps: &Steps, step: &Step, next: &Step, time: f64) -> LegAngles {
    // Just long enough for a difference of angles to say a speed.
    const MOMENT: f64 = 1.0 / 480.0;
    let ends = [(step, step.off), (next, next.strike)].map(|(step, end)| {
        let angles = |time: f64| standing(course, steps, step, time).to_array();
        (angles(end), angles(end - MOMENT), angles(end + MOMENT))
    });
    let length = next.strike - step.off;
    let effort = course.at(step.off).effort();
    let lift = lerp(0.95, 1.0, effort) * (1.0 + 0.02 * wobble(10 + step.side as u32, step.off * 3.0));
    let mut angles = [0.0; 8];
    for (n, angle) in angles.iter_mut().enumerate() {
        let [(from, before, after), (to, before_to, after_to)] = ends;
        let speeds = [(after[n] - before[n]) / (2.0 * MOMENT), (after_to[n] - before_to[n]) / (2.0 * MOMENT)];
        let mut points = vec![(step.off, from[n])];
        let knots: &[(f64, f64)] = match n {
            0 => &HIP,
            3 => &KNEE,
            4 => &ANKLE,
            7 => &TOES,
            _ => &[],
        };
        // Knees fold with positive angles; hip, ankle and toes flex with negative ones.
        let sign = if n == 3 { 1.0 } else { -1.0 };
        points.extend(knots.iter().map(|(part, degrees)| (step.off + part * length, sign * degrees * lift)));
        if knots.is_empty() {
            points.push((step.off + 0.5 * length, (from[n] + to[n]) / 2.0));
        }
        points.push((next.strike, to[n]));
        *angle = Spline::clamped(&points, speeds).at(time);
    }
    LegAngles::from_array(angles)
}
