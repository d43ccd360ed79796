//! The pelvis of the runner: its height over the ground, its sway and its turns.

use glam::{DMat3, DVec3};
use skeleton::Axis;

use super::course::{Course, GRAVITY};
use super::steps::{Step, Steps};
use crate::humanoid::{LEFT_HIP, Side};
use crate::math::{cos, from_euler, wobble};

/// The height of the hip joints when a foot strikes, in cm.
const STRIKE_HEIGHT: f64 = 89.8;
/// The height of the hip joints when a foot leaves the ground, in cm.
const OFF_HEIGHT: f64 = 88.0;

/// Where the pelvis is.
#[derive(Clone, Copy, Debug)]
pub struct Pelvis {
    /// The global position of the joint `Hips`, in cm.
    pub position: DVec3,
    /// The angles of `Hips` about X, Y and Z in this order, in degrees.
    pub angles: [f64; 3],
    /// The same as a rotation.
    pub rotation: DMat3,
}

impl Pelvis {
    /// The pelvis at `time`, in seconds.
    ///
    /// The heading goes into the angle about Y, the middle one. Near ±90° of it the turns about X and about Z do the
    /// same, and one kind of tilt is out of reach without leaps: so the trunk's lean forward is left to the spine,
    /// and the small tilt about X dies away there.
    pub fn at(course: &Course, steps: &Steps, time: f64) -> Pelvis {
        let now = course.at(time);
        let wave = |amplitude: f64, peak: f64| amplitude * cos(360.0 * (now.phase - peak));
        let double_wave = |amplitude: f64, peak: f64| amplitude * cos(720.0 * (now.phase - peak));
        // Forward on the side of the leg that is in front, up on the side that stands, and a little tilt twice per
        // stride; of the size that Schache et al. 1999 report in "The coordinated movement of the lumbo-pelvic-hip
        // complex during running".
        let rotation = wave(6.0 + 0.6 * wobble(3, time), 0.40);
        let list = wave(4.5 + 0.5 * wobble(4, time), 0.14);
        let tilt = double_wave(1.5, 0.18);
        let angles = [tilt * cos(now.heading), now.heading + rotation, list - 0.6 * now.lean];
        let rotation = from_euler(Axis::ALL, angles);
        let sway = wave(1.1, 0.15) + 0.8 * wobble(5, time);
        let surge = double_wave(0.5, 0.36);
        let hips = now.place + now.left() * sway + now.forward() * surge;
        let height = cos(now.lean) * (height(steps, time) + 0.2 * wobble(6, time));
        let middle = DVec3::new(0.0, LEFT_HIP.y, 0.0);
        Pelvis { position: hips + DVec3::Y * height - rotation * middle, angles, rotation }
    }

    /// The global position of a hip joint, in cm.
    pub fn hip(&self, side: Side) -> DVec3 {
        self.position + self.rotation * side.mirror(LEFT_HIP)
    }
}

/// The height of the hip joints at `time`.
///
/// In flight the body falls freely. On the ground it is pushed up by a force that rises and falls like half a sine
/// wave (Morin et al. 2005, "A simple method for measuring stiffness during running"), plus a
/// full wave that makes up for taking off lower than landing. Both strengths follow from the speeds and heights at
/// strike and take-off.
fn height(steps: &Steps, time: f64) -> f64 {
    let Some([before, step, after]) = steps.around(time) else { return STRIKE_HEIGHT };
    let contact = step.off - step.strike;
    let landing = take_off_speed(before, step) - GRAVITY * (step.strike - before.off);
    let leaving = take_off_speed(step, after);
    if time >= step.off {
        let t = time - step.off;
        return OFF_HEIGHT + t * (leaving - GRAVITY * t / 2.0);
    }
    let pi = std::f64::consts::PI;
    let half = pi * (leaving - landing + GRAVITY * contact) / (2.0 * contact);
    let fall = OFF_HEIGHT - STRIKE_HEIGHT - contact * (landing + contact * (half / pi - GRAVITY / 2.0));
    let full = fall * 2.0 * pi / (contact * contact);
    let t = time - step.strike;
    let push = |strength: f64, wave: f64| strength / wave * (t - libm::sin(wave * t) / wave);
    STRIKE_HEIGHT
        + t * (landing - GRAVITY * t / 2.0)
        + push(half, pi / contact)
        + push(full, 2.0 * pi / contact)
}

/// The upward speed in cm/s that leads from `step`'s take-off to `next`'s strike.
fn take_off_speed(step: &Step, next: &Step) -> f64 {
    let flight = next.strike - step.off;
    (STRIKE_HEIGHT - OFF_HEIGHT) / flight + GRAVITY * flight / 2.0
}
