//! The steps: when and where each foot strikes and leaves the ground.

use glam::DVec3;

use super::course::Course;
use crate::humanoid::{BALL_HEIGHT, Side};
use crate::leg::Foot;
use crate::math::{cos, lerp, sin, wobble};

/// One contact of a foot with the ground.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    /// The foot.
    pub side: Side,
    /// When the heel meets the ground, in seconds.
    pub strike: f64,
    /// When the toes leave it, in seconds.
    pub off: f64,
    /// Where the ball of the foot stands, in cm.
    pub ball: DVec3,
    /// Where the toes point, in degrees about Y.
    pub heading: f64,
}

/// The part of a contact after which the ball of the foot is under the hips.
const UNDER: f64 = 0.44;
/// How high the hip joints are above the ankles as the body leans into a curve, in cm.
const LEANING_HEIGHT: f64 = 80.0;

impl Step {
    /// Step number `index`; the left foot has the even ones.
    fn new(course: &Course, index: i32) -> Step {
        let phase = f64::from(index) / 2.0;
        let strike = course.time_of(phase);
        // The foot is on the ground for 36 % of the stride in a jog and 30 % in a run.
        let duty = lerp(0.36, 0.30, course.at(strike).effort());
        let off = course.time_of(phase + duty);
        let side = if index % 2 == 0 { Side::Left } else { Side::Right };
        let under = course.at(lerp(strike, off, UNDER));
        // Runners set their feet almost on one line; in a curve the feet run outside of the hips.
        let outwards = LEANING_HEIGHT * sin(under.lean) / cos(under.lean);
        let sideways = side.sign() * 4.8 - outwards + 0.7 * wobble(7, strike * 3.0);
        let ahead = 0.6 * wobble(8, strike * 3.0);
        let ball = under.place + under.left() * sideways + under.forward() * ahead + DVec3::Y * BALL_HEIGHT;
        let heading = under.heading + side.sign() * (6.0 + 1.5 * wobble(9, strike * 3.0));
        Step { side, strike, off, ball, heading }
    }

    /// The foot at `time`, which should be in the contact or just beside it.
    ///
    /// It strikes with the heel, toes 8° up, lies flat after a quarter of the contact, and after a third the heel
    /// begins to rise, to 60° at take-off.
    pub fn foot(&self, time: f64) -> Foot {
        let t = (time - self.strike) / (self.off - self.strike);
        let square = |x: f64| if x > 0.0 { x * x } else { 0.0 };
        let pitch = 60.0 * square((t - 0.33) / 0.67) - 8.0 * square((0.24 - t) / 0.24);
        Foot::standing(self.ball, self.heading, pitch)
    }
}

/// All steps of the run, in the order of time.
pub struct Steps(Vec<Step>);

impl Steps {
    /// Plans the steps along the way.
    pub fn new(course: &Course) -> Steps {
        Steps((-4..36).map(|index| Step::new(course, index)).collect())
    }

    /// The last step that began by `time`, between the ones before and after it; `None` at the ends of the run.
    pub fn around(&self, time: f64) -> Option<[&Step; 3]> {
        let next = self.0.partition_point(|step| step.strike <= time);
        let [before, step, after] = self.0.get(next.checked_sub(2)?..=next)? else { return None };
        Some([before, step, after])
    }

    /// The last step of one foot that began by `time`, and that foot's next one.
    pub fn of(&self, side: Side, time: f64) -> Option<[&Step; 2]> {
        let next = self.0.iter().position(|step| step.side == side && step.strike > time)?;
        Some([self.0.get(next.checked_sub(2)?)?, self.0.get(next)?])
    }
}
