//! A motion: a skeleton and one row of numbers per frame.

use std::fmt;

use glam::Vec3;

use crate::{Channel, Skeleton};

/// A skeleton and its movement: for every frame one row with a number for every channel, in the order of the file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Motion {
    skeleton: Skeleton,
    frame_count: usize,
    frame_time: f64,
    values: Vec<f32>,
}

impl Motion {
    /// `values` holds `frame_count` rows of [`Skeleton::channel_count`] numbers; `frame_time` is in seconds, kept as
    /// it is even if it cannot be played (see [`Motion::playable_frame_time`]).
    ///
    /// # Errors
    ///
    /// When the number of values is not frames × channels.
    pub fn new(
        skeleton: Skeleton,
        frame_count: usize,
        frame_time: f64,
        values: Vec<f32>,
    ) -> Result<Self, MotionError> {
        let channels = skeleton.channel_count();
        if frame_count.checked_mul(channels) != Some(values.len()) {
            return Err(MotionError { frames: frame_count, channels, values: values.len() });
        }
        Ok(Motion { skeleton, frame_count, frame_time, values })
    }

    /// The skeleton that moves.
    pub fn skeleton(&self) -> &Skeleton {
        &self.skeleton
    }

    /// How many frames there are; may be 0.
    pub fn frame_count(&self) -> usize {
        self.frame_count
    }

    /// The seconds from one frame to the next, as the file says it: not always a number that can be played.
    pub fn frame_time(&self) -> f64 {
        self.frame_time
    }

    /// The seconds from one frame to the next, or 1/30 where nobody could see what the file says: less than a
    /// millionth of a second, more than a million seconds, or no number.
    pub fn playable_frame_time(&self) -> f64 {
        if (1e-6..=1e6).contains(&self.frame_time) { self.frame_time } else { 1.0 / 30.0 }
    }

    /// All rows, one behind the other.
    pub fn values(&self) -> &[f32] {
        &self.values
    }

    /// The row of frame `index`, counted from 0; `None` behind the last frame.
    pub fn row(&self, index: usize) -> Option<&[f32]> {
        if index >= self.frame_count {
            return None;
        }
        let channels = self.skeleton.channel_count();
        self.values.get(index * channels..(index + 1) * channels)
    }

    /// Sorts the row of frame `index` (from 0) for the traversal, into `frame`, whose memory is used again.
    /// After the last frame, `frame` becomes the rest pose.
    pub fn read_frame(&self, index: usize, positions: PositionChannels, frame: &mut Frame) {
        frame.read(&self.skeleton, self.row(index).unwrap_or(&[]), positions);
    }

    /// Frame `index` (from 0), sorted for the traversal; position channels replace offsets.
    pub fn frame(&self, index: usize) -> Frame {
        let mut frame = Frame::default();
        self.read_frame(index, PositionChannels::Replace, &mut frame);
        frame
    }
}

/// What a position channel does to the OFFSET component on its axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PositionChannels {
    /// It takes its place. Most files mean this.
    #[default]
    Replace,
    /// It is added to it. A few programs read files this way.
    Add,
}

/// One frame of a motion, sorted for the traversal.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Frame {
    /// Three angles in degrees for every joint that rotates, in the order of the joints and, within a joint, in its
    /// rotation order. An axis without a channel has the angle zero.
    pub angles: Vec<f32>,
    /// For every joint its position relative to its parent, in the parent's axes: the offset, or what the position
    /// channels make of it.
    pub local_positions: Vec<Vec3>,
}

impl Frame {
    /// Sorts one row, wherever in it a joint's position and rotation channels stand. A row that is too short goes
    /// on with zero angles and plain offsets.
    fn read(&mut self, skeleton: &Skeleton, row: &[f32], positions: PositionChannels) {
        self.angles.clear();
        self.local_positions.clear();
        let mut rest = row.iter().copied();
        for joint in skeleton.joints() {
            let mut angles = [0.0; 3];
            let mut position = joint.offset;
            let mut rotations = 0;
            for channel in &joint.channels {
                let value = rest.next();
                match *channel {
                    Channel::Rotation(_) => {
                        angles[rotations] = value.unwrap_or(0.0);
                        rotations += 1;
                    }
                    Channel::Position(axis) => {
                        let component = &mut position[axis.index()];
                        *component = match (value, positions) {
                            (None, _) => *component,
                            (Some(value), PositionChannels::Replace) => value,
                            (Some(value), PositionChannels::Add) => *component + value,
                        };
                    }
                }
            }
            if rotations > 0 {
                self.angles.extend(angles);
            }
            self.local_positions.push(position);
        }
    }
}

/// The number of values does not fit the frames and channels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MotionError {
    /// Frames asked for.
    pub frames: usize,
    /// Channels in the skeleton.
    pub channels: usize,
    /// Values given.
    pub values: usize,
}

impl fmt::Display for MotionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let MotionError { frames, channels, values } = self;
        write!(f, "{frames} frames of {channels} channels cannot be made of {values} values")
    }
}

impl std::error::Error for MotionError {}
