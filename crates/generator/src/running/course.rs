//! The way that the runner takes: speed, heading and cadence over time.

use glam::DVec3;

use crate::math::{atan2, cos, lerp, sin, smooth, wobble};

/// The gravity on Earth, in cm/s².
pub const GRAVITY: f64 = 981.0;

/// Seconds between two stored samples.
const STEP: f64 = 1.0 / 1200.0;
/// The first and the last stored time, in seconds: more than the frames need, since a stride begins before them.
const SPAN: [f64; 2] = [-1.6, 13.0];

/// The runner at one moment.
#[derive(Clone, Copy, Debug, Default)]
pub struct Moment {
    /// The point of the path under the body, in cm; `y` is 0.
    pub place: DVec3,
    /// The direction of travel in degrees about Y; 0 is +Z. It grows to the left and is never wrapped.
    pub heading: f64,
    /// cm/s.
    pub speed: f64,
    /// Strides since time 0: the left foot strikes at whole numbers, the right one halfway between.
    pub phase: f64,
    /// By how many degrees the body leans into the curve, to the left.
    pub lean: f64,
}

impl Moment {
    /// The unit vector in the direction of travel.
    pub fn forward(&self) -> DVec3 {
        DVec3::new(sin(self.heading), 0.0, cos(self.heading))
    }

    /// The unit vector to the runner's left.
    pub fn left(&self) -> DVec3 {
        DVec3::new(cos(self.heading), 0.0, -sin(self.heading))
    }

    /// How far the speed has come from a jog (0) to the run (1).
    pub fn effort(&self) -> f64 {
        (self.speed - JOG) / (RUN - JOG)
    }
}

/// The speed at the start, cm/s.
const JOG: f64 = 270.0;
/// The speed from the sixth second on, cm/s.
const RUN: f64 = 345.0;

/// The whole way, sampled finely. Out of a jog on a straight line into a run and a wide bend to the left.
pub struct Course {
    samples: Vec<Moment>,
}

impl Course {
    /// Works the way out.
    pub fn new() -> Course {
        let count = ((SPAN[1] - SPAN[0]) / STEP) as usize + 1;
        let zero = (-SPAN[0] / STEP) as usize;
        let mut samples = vec![Moment::default(); count];
        // From time 0 forwards, and then backwards.
        let mut distance = 0.0;
        samples[zero] = moment(0.0, 0.0, Moment::default());
        for i in zero..count - 1 {
            distance += samples[i].speed * STEP;
            samples[i + 1] =
                moment((i + 1 - zero) as f64 * STEP, distance, advance(&samples[i], distance, STEP));
        }
        distance = 0.0;
        for i in (0..zero).rev() {
            distance -= samples[i + 1].speed * STEP;
            samples[i] =
                moment((i as f64 - zero as f64) * STEP, distance, advance(&samples[i + 1], distance, -STEP));
        }
        Course { samples }
    }

    /// The runner at `time`, in seconds; times outside the stored span give its ends.
    pub fn at(&self, time: f64) -> Moment {
        let position = ((time - SPAN[0]) / STEP).clamp(0.0, (self.samples.len() - 2) as f64);
        let (a, b) = (&self.samples[position as usize], &self.samples[position as usize + 1]);
        let t = position - libm::floor(position);
        Moment {
            place: a.place + (b.place - a.place) * t,
            heading: lerp(a.heading, b.heading, t),
            speed: lerp(a.speed, b.speed, t),
            phase: lerp(a.phase, b.phase, t),
            lean: lerp(a.lean, b.lean, t),
        }
    }

    /// The time in seconds at which the phase reaches `phase`.
    pub fn time_of(&self, phase: f64) -> f64 {
        let i = self.samples.partition_point(|sample| sample.phase < phase).clamp(1, self.samples.len() - 1);
        let (a, b) = (self.samples[i - 1].phase, self.samples[i].phase);
        SPAN[0] + (i as f64 - 1.0 + (phase - a) / (b - a)) * STEP
    }
}

/// Place, heading and phase one step after (or before) `from`.
fn advance(from: &Moment, distance: f64, step: f64) -> Moment {
    let heading = from.heading + (curvature(distance) * from.speed * step).to_degrees();
    let middle = Moment { heading: (from.heading + heading) / 2.0, ..*from };
    let place = from.place + middle.forward() * (from.speed * step);
    Moment { place, heading, phase: from.phase + cadence(from) * step, ..*from }
}

/// Fills in what `time` (seconds) and the way run so far (cm) say.
fn moment(time: f64, distance: f64, at: Moment) -> Moment {
    let speed = lerp(JOG, RUN, smooth(time / 6.0)) + 2.0 * wobble(1, time);
    // A runner leans until gravity and the push outwards pull along the body.
    let lean = atan2(speed * speed * curvature(distance), GRAVITY);
    Moment { speed, lean, ..at }
}

/// Strides per second. Cadence grows slowly with speed, here from 166 to 174 steps a minute (Cavanagh and Kram 1989,
/// "Stride length in distance running"), and differs by about 1 % between strides (Jordan, Challis and Newell 2007,
/// "Speed influences on the scaling behavior of gait cycle fluctuations during treadmill running").
fn cadence(at: &Moment) -> f64 {
    let time = at.phase / 1.4;
    lerp(1.38, 1.45, at.effort()) * (1.0 + 0.008 * wobble(2, time))
}

/// The bend of the way in radians per cm, positive to the left: straight, then a bend of 6 m radius.
fn curvature(distance: f64) -> f64 {
    (smooth((distance - 600.0) / 500.0) - smooth((distance - 2900.0) / 500.0)) / 600.0
}
