//! A motion of which only the keyframes are left, as a motion that every program plays.
//!
//! BVH knows evenly spaced frames only. So all frames are there, and those between keyframes hold what comes out when they are
//! interpolated: the same skeleton, channels and frame time, and the keyframes' own numbers.

use inbetween::InbetweenClip;
use parser::angles::{angles_of, distance};
use skeleton::{Axis, Channel, Joint, JointId, Motion, Representation};
use solutions::interpolation::interpolate_angles;

use super::reordered::turns;

/// A rotation that is off by less than so many degrees is what an `f32` makes of the right one.
pub(crate) const LEAST_MISFIT: f64 = 0.01;

/// A motion with interpolated frames.
#[derive(Clone, Debug, PartialEq)]
pub struct Reduced {
    /// The motion. At a keyframe, which keeps its own numbers, angles may jump, mostly by whole turns.
    pub motion: Motion,
    /// The joints whose channels cannot hold all of their interpolated rotations, in the order of the joints: only such with
    /// one or two rotation channels, and only when quaternions are interpolated. The nearest rotations are there instead.
    pub misfits: Vec<Misfit>,
}

/// A joint whose channels cannot hold its interpolated rotations, between keyframes or in a time warp.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Misfit {
    /// Which joint.
    pub joint: JointId,
    /// How many rotation channels it has.
    pub channels: usize,
    /// By how many degrees it is off at most.
    pub degrees: f64,
    /// In which frame that is.
    pub frame: usize,
}

/// Interpolates all frames of `motion` between the `keyframes`, which are in ascending order. Frames before the first and
/// behind the last of them stay as they are. `clip` is made of the same motion, and says what is interpolated.
pub fn reduced(motion: &Motion, clip: &InbetweenClip, keyframes: &[usize]) -> Reduced {
    let mut table = Table {
        clip,
        channels: motion.skeleton().channel_count(),
        values: motion.values().to_vec(),
        worst: vec![None; motion.skeleton().len()],
    };
    for gap in keyframes.windows(2) {
        table.fill(gap[0], gap[1].min(motion.frame_count().saturating_sub(1)));
    }
    let values = table.values;
    let motion = Motion::new(motion.skeleton().clone(), motion.frame_count(), motion.frame_time(), values);
    Reduced {
        motion: motion.expect("there are as many values as before"),
        misfits: table.worst.into_iter().flatten().collect(),
    }
}

/// The numbers of all frames.
struct Table<'a> {
    clip: &'a InbetweenClip,
    channels: usize,
    values: Vec<f32>,
    /// For each joint the largest misfit so far.
    worst: Vec<Option<Misfit>>,
}

/// A frame between two keyframes, and where the numbers of a joint stand in a row.
#[derive(Clone, Copy)]
struct Spot {
    start: usize,
    end: usize,
    frame: usize,
    column: usize,
}

impl Table<'_> {
    /// Interpolates all frames between two keyframes. Where the motion stands still they stay as they are.
    fn fill(&mut self, start: usize, end: usize) {
        if self.clip.is_still(start, end) {
            return;
        }
        let clip = self.clip;
        for frame in start + 1..end {
            let rotations = match clip.representation() {
                Representation::Euler => Vec::new(),
                Representation::Quaternion => clip.local_between(start, end, frame).rotations,
            };
            let mut spot = Spot { start, end, frame, column: 0 };
            for joint in clip.skeleton().joints() {
                self.move_joint(joint, spot);
                match rotations.get(joint.id.0) {
                    None => self.turn_by_angles(joint, spot),
                    Some(rotation) => self.turn_to(joint, spot, *rotation),
                }
                spot.column += joint.channels.len();
            }
        }
    }

    /// The position channels: on the straight line, whether they are added to the offset or take its place.
    fn move_joint(&mut self, joint: &Joint, spot: Spot) {
        let share = (spot.frame - spot.start) as f64 / (spot.end - spot.start) as f64;
        for (at, _) in joint.channels.iter().enumerate().filter(|(_, c)| matches!(c, Channel::Position(_))) {
            let [from, to] =
                [spot.start, spot.end].map(|frame| f64::from(self.value(frame, spot.column + at)));
            *self.value_mut(spot.frame, spot.column + at) = (from + share * (to - from)) as f32;
        }
    }

    /// The rotation channels when angles are interpolated.
    fn turn_by_angles(&mut self, joint: &Joint, spot: Spot) {
        let share = (spot.frame - spot.start) as f32 / (spot.end - spot.start) as f32;
        let [from, to] = [spot.start, spot.end].map(|frame| self.angles(joint, frame, spot.column));
        self.set_angles(joint, spot, interpolate_angles(from, to, share));
    }

    /// The rotation channels when a rotation is interpolated: the angles that make it, close to those of the frame before.
    fn turn_to(&mut self, joint: &Joint, spot: Spot, rotation: glam::Quat) {
        let axes: Vec<Axis> = turns(joint).map(|(_, axis)| axis).collect();
        if axes.is_empty() {
            return;
        }
        let near = self.angles(joint, spot.frame - 1, spot.column).map(f64::from);
        let angles = angles_of(rotation, &axes, near);
        self.set_angles(joint, spot, angles.map(|angle| angle as f32));
        // Three angles make any rotation.
        if axes.len() < 3 {
            let degrees = distance(rotation, &axes, angles);
            let worst = &mut self.worst[joint.id.0];
            if degrees > worst.map_or(LEAST_MISFIT, |worst| worst.degrees) {
                *worst = Some(Misfit { joint: joint.id, channels: axes.len(), degrees, frame: spot.frame });
            }
        }
    }

    /// The angles of a joint in the order of its channels; 0 for those without a channel.
    fn angles(&self, joint: &Joint, frame: usize, column: usize) -> [f32; 3] {
        let mut angles = [0.0; 3];
        for (angle, (at, _)) in angles.iter_mut().zip(turns(joint)) {
            *angle = self.value(frame, column + at);
        }
        angles
    }

    fn set_angles(&mut self, joint: &Joint, spot: Spot, angles: [f32; 3]) {
        for (angle, (at, _)) in angles.into_iter().zip(turns(joint)) {
            *self.value_mut(spot.frame, spot.column + at) = angle;
        }
    }

    fn value(&self, frame: usize, column: usize) -> f32 {
        self.values[frame * self.channels + column]
    }

    fn value_mut(&mut self, frame: usize, column: usize) -> &mut f32 {
        &mut self.values[frame * self.channels + column]
    }
}

#[cfg(test)]
mod tests;
