//! `walk.asf` and `walk.amc`: a human of bones, who walks straight ahead.
//!
//! As in the run the feet come first: the [`steps`] say where each one stands and how it rolls from the heel to the
//! toes, and how it swings to its next place. The [`pelvis`] moves above them, the [`legs`] reach for the feet by inverse
//! kinematics, and the [`upper`] body moves against them.

mod figure;
mod legs;
mod pelvis;
mod recorder;
mod steps;
mod upper;

use skeleton::acclaim::Motion;

use crate::Error;
use crate::humanoid::Side;
use figure::figure;
use pelvis::Pelvis;
use recorder::BoneRecorder;
use steps::Steps;

/// How many frames the walk has.
const FRAMES: usize = 480;
/// Frames per second. The file does not say so.
const RATE: f64 = 120.0;

/// The walk: 480 frames, meant for 120 per second, in cm.
///
/// # Errors
///
/// None, unless the tables of this crate contradict each other.
pub fn walking() -> Result<Motion, Error> {
    let mut pose = BoneRecorder::new(figure()?);
    let steps = Steps::new();
    for frame in 0..FRAMES {
        let time = frame as f64 / RATE;
        let pelvis = Pelvis::at(time);
        pose.set_root(pelvis.position, pelvis.rotation);
        for side in Side::BOTH {
            legs::set(&mut pose, &steps, &pelvis, side, time)?;
        }
        upper::set(&mut pose, &pelvis, time)?;
        pose.push_frame();
    }
    pose.finish()
}
