//! `running.bvh`: a human runs out of a jog into a run and around a wide bend.
//!
//! The steps come first: a [`course`] says where the body is at which speed, and the [`steps`] say where each foot
//! stands and for how long. The [`pelvis`] rides above them as gravity and the push of the legs want it. The [`legs`]
//! reach for the planted feet and swing between, and the [`upper`] body moves against them.

mod course;
mod legs;
mod pelvis;
mod steps;
mod upper;

use skeleton::{Axis, Motion};

use crate::Error;
use crate::humanoid::{Side, skeleton};
use crate::recorder::Recorder;
use course::Course;
use pelvis::Pelvis;
use steps::Steps;

/// How many frames the run has.
const FRAMES: usize = 1377;
/// The seconds between two frames, as files recorded at 120 frames per second have it.
const FRAME_TIME: f64 = 0.008333;

/// The run: 1377 frames at 120 per second, all joints in the order X, Y, Z, in cm.
///
/// # Errors
///
/// None, unless the tables of this crate contradict each other.
pub fn running() -> Result<Motion, Error> {
    let mut pose = Recorder::new(skeleton(|_| Axis::ALL)?);
    let course = Course::new();
    let steps = Steps::new(&course);
    for frame in 0..FRAMES {
        let time = frame as f64 * FRAME_TIME;
        let now = course.at(time);
        let pelvis = Pelvis::at(&course, &steps, time);
        pose.set_position("Hips", pelvis.position)?;
        pose.set_angles("Hips", pelvis.angles)?;
        for side in Side::BOTH {
            legs::leg(&course, &steps, side, time).set(&mut pose, side)?;
        }
        upper::set(&mut pose, &now, &pelvis, time)?;
        pose.push_frame();
    }
    pose.finish(FRAME_TIME)
}
