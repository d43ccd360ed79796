//! The legs of the runner: planted while they bear weight, swung between.

use super::course::Course;
use super::pelvis::Pelvis;
use super::steps::{Step, Steps};
use crate::humanoid::Side;
use crate::leg::{Knots, LegAngles};
use crate::math::{lerp, wobble};

/// The angles of one leg at `time`, in seconds.
pub fn leg(course: &Course, steps: &Steps, side: Side, time: f64) -> LegAngles {
    match steps.of(side, time) {
        None => LegAngles::default(),
        Some([step, _]) if time < step.off => standing(course, steps, step, time),
        Some([step, next]) => {
            let [before, after] =
                [step, next].map(|step| move |time: f64| standing(course, steps, step, time));
            let knots = knots(course, step, &before(step.off), &after(next.strike));
            LegAngles::swinging([step.off, next.strike], [&before, &after], knots, time)
        }
    }
}

/// The foot stands: the leg reaches for it.
fn standing(course: &Course, steps: &Steps, step: &Step, time: f64) -> LegAngles {
    let pelvis = Pelvis::at(course, steps, time);
    let knee_heading = lerp(course.at(time).heading, step.heading, 0.5);
    LegAngles::reaching(pelvis.hip(step.side), pelvis.rotation, step.foot(time), knee_heading)
}

/// The flexions through which a swinging leg passes: (part of the swing, degrees).
///
/// After the curves of Novacheck 1998, "The biomechanics of running", and Mann and Hagy 1980, "Biomechanics of
/// walking, running, and sprinting", for 3 to 4 m/s: the thigh goes on back for a moment, the knee folds to a good
/// 100°, the thigh swings up past 40°, and the leg opens again to meet the ground.
const HIP: [(f64, f64); 4] = [(0.13, -31.0), (0.46, 12.0), (0.68, 43.0), (0.87, 33.0)];
const KNEE: [(f64, f64); 4] = [(0.24, 57.0), (0.48, 109.0), (0.74, 60.0), (0.90, 24.0)];
const ANKLE: [(f64, f64); 3] = [(0.14, -24.0), (0.45, -6.0), (0.72, 8.0)];
const TOES: [(f64, f64); 2] = [(0.25, 8.0), (0.60, 4.0)];

/// The points between the stands `from` and `to`. A jog lifts the legs less than a run, and no two swings are equal.
fn knots(course: &Course, step: &Step, from: &LegAngles, to: &LegAngles) -> [Knots; 8] {
    let lift = lerp(0.98, 1.0, course.at(step.off).effort());
    let lift = lift * (1.0 + 0.02 * wobble(10 + step.side as u32, step.off * 3.0));
    let scaled = |flexions: &[(f64, f64)], sign: f64| -> Knots {
        flexions.iter().map(|(part, degrees)| (*part, sign * degrees * lift)).collect()
    };
    let (from, to) = (from.to_array(), to.to_array());
    std::array::from_fn(|n| match n {
        // Knees flex with positive angles; hip, ankle and toes with negative ones.
        0 => scaled(&HIP, -1.0),
        3 => scaled(&KNEE, 1.0),
        4 => scaled(&ANKLE, -1.0),
        7 => scaled(&TOES, -1.0),
        _ => vec![(0.5, (from[n] + to[n]) / 2.0)],
    })
}
