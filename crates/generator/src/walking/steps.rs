//! The steps: when and where each foot strikes, stands and swings.

use glam::DVec3;

use super::pelvis::{phase, time_of, way};
use crate::humanoid::{BALL_HEIGHT, Side};
use crate::leg::Foot;
use crate::math::wobble;
use crate::spline::Spline;

/// The part of a stride for which a foot is on the ground (Perry 1992, "Gait analysis: normal and pathological function").
const CONTACT: f64 = 0.62;
/// How far in front of the hips the ball of the foot is put down, in cm.
const AHEAD: f64 = 45.0;

/// One contact of a foot with the ground.
#[derive(Clone, Copy, Debug)]
struct Step {
    side: Side,
    /// When the heel meets the ground and when the toes leave it, in strides.
    strike: f64,
    off: f64,
    /// Where the ball of the foot stands, in cm.
    ball: DVec3,
    /// Where the toes point, in degrees about Y.
    heading: f64,
}

/// A foot, told by numbers that change smoothly.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    /// The ankle's global position, in cm.
    pub ankle: DVec3,
    /// Where the toes point, in degrees about Y; 0 is +Z.
    pub heading: f64,
    /// By how many degrees the heel is raised over the toes.
    pub pitch: f64,
    /// The toes' angle about X against the foot, in degrees; negative is bent upwards.
    pub toes: f64,
}

impl Step {
    /// Step number `index`; the left foot has the even ones.
    fn new(index: i32) -> Step {
        let strike = f64::from(index) / 2.0;
        let side = if index % 2 == 0 { Side::Left } else { Side::Right };
        let vary = |which: u32| wobble(which, time_of(strike) * 3.0);
        // The middles of the heels are about 8 cm apart (Murray et al. 1964), the toes point out by 7°.
        let sideways = side.sign() * 6.4 + 0.5 * vary(45);
        let ball = DVec3::new(sideways, BALL_HEIGHT, way(strike) + AHEAD + 0.25 * vary(46));
        Step { side, strike, off: strike + CONTACT, ball, heading: side.sign() * 7.0 + 0.8 * vary(47) }
    }

    /// The foot at `phase`, which should be in the contact or just beside it.
    ///
    /// It strikes with the heel, toes up, lies flat after a fifth of the contact, and after the middle of it the heel
    /// begins to rise.
    fn place(&self, phase: f64) -> Place {
        let t = (phase - self.strike) / (self.off - self.strike);
        let growing = |part: f64, power: f64| libm::pow(part.max(0.0), power);
        let pitch = 62.0 * growing((t - 0.58) / 0.42, 2.4) - 20.0 * growing((0.20 - t) / 0.20, 2.0);
        let Foot { ankle, toes, .. } = Foot::standing(self.ball, self.heading, pitch);
        Place { ankle, heading: self.heading, pitch, toes }
    }
}

/// All steps of the walk, in their order.
pub struct Steps(Vec<Step>);

impl Steps {
    /// Plans the steps.
    pub fn new() -> Steps {
        Steps((-4..14).map(Step::new).collect())
    }

    /// Where a foot is at `time`, in seconds.
    pub fn at(&self, side: Side, time: f64) -> Place {
        let phase = phase(time);
        let mut own = self.0.iter().filter(|step| step.side == side);
        let next = own.clone().position(|step| step.strike > phase).unwrap_or_default();
        match (own.nth(next.saturating_sub(1)), own.next()) {
            (Some(last), _) if phase < last.off => last.place(phase),
            (Some(last), Some(next)) => swinging(last, next, phase),
            (Some(last), None) => last.place(last.off),
            (None, _) => Place { ankle: DVec3::ZERO, heading: 0.0, pitch: 0.0, toes: 0.0 },
        }
    }
}

/// A foot between two stands. Every number follows a smooth curve that takes over place and speed at both ends.
fn swinging(last: &Step, next: &Step, phase: f64) -> Place {
    // Just long enough for a difference of places to say a speed.
    const MOMENT: f64 = 1.0 / 480.0;
    let span = [last.off, next.strike];
    let ends = [last, next];
    let curve = |number: &dyn Fn(&Place) -> f64, knots: &[(f64, f64)]| {
        let value = |end: usize, shift: f64| number(&ends[end].place(span[end] + shift));
        let speed = |end: usize| (value(end, MOMENT) - value(end, -MOMENT)) / (2.0 * MOMENT);
        let mut points = vec![(span[0], value(0, 0.0))];
        points.extend(knots.iter().map(|(part, value)| (span[0] + part * (span[1] - span[0]), *value)));
        points.push((span[1], value(1, 0.0)));
        Spline::clamped(&points, [speed(0), speed(1)]).at(phase)
    };
    let vary = 0.4 * wobble(48 + last.side as u32, time_of(last.off) * 3.0);
    let height = [(0.20, 22.5 + vary), (0.50, 14.2 + vary), (0.80, 10.6)];
    let pitch = [(0.12, 68.0), (0.50, 14.0), (0.82, -20.0)];
    let toes = [(0.30, -14.0), (0.60, -4.0)];
    // The foot passes the standing leg a little farther out, and its toes point ahead.
    let out = last.side.sign();
    let middle = |number: &dyn Fn(&Place) -> f64| {
        (number(&last.place(last.off)) + number(&next.place(next.strike))) / 2.0
    };
    Place {
        ankle: DVec3::new(
            curve(&|place| place.ankle.x, &[(0.50, middle(&|place| place.ankle.x) + out)]),
            curve(&|place| place.ankle.y, &height),
            curve(&|place| place.ankle.z, &[]),
        ),
        heading: curve(&|place| place.heading, &[(0.50, middle(&|place| place.heading) - 7.0 * out)]),
        pitch: curve(&|place| place.pitch, &pitch),
        toes: curve(&|place| place.toes, &toes),
    }
}
