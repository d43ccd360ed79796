//! Collects the poses of a movement, frame by frame, into a [`Motion`].

use std::collections::HashMap;

use glam::{DMat3, DVec3};
use skeleton::{Axis, Channel, JointId, Motion, Skeleton};

use crate::Error;
use crate::math::{to_euler, wrap};

/// The pose that is being made, and the rows of the frames made so far.
///
/// What one frame sets holds for the next ones too, until it is set again.
pub struct Recorder {
    skeleton: Skeleton,
    joints: HashMap<String, JointId>,
    /// For every joint its angles in degrees, in the order of its channels.
    angles: Vec<[f64; 3]>,
    positions: Vec<DVec3>,
    wrapped: Vec<JointId>,
    values: Vec<f32>,
    frames: usize,
}

impl Recorder {
    /// A recorder in front of the first frame, with all angles zero and all joints at their offsets.
    pub fn new(skeleton: Skeleton) -> Recorder {
        let joints = skeleton.joints().iter().map(|joint| (joint.name.clone(), joint.id)).collect();
        let angles = vec![[0.0; 3]; skeleton.len()];
        let positions = skeleton.joints().iter().map(|joint| joint.offset.as_dvec3()).collect();
        Recorder { skeleton, joints, angles, positions, wrapped: Vec::new(), values: Vec::new(), frames: 0 }
    }

    /// Stores the angles of this joint within ±180° from now on: they jump where they pass it.
    ///
    /// # Errors
    ///
    /// When no joint has this name.
    pub fn wrap(&mut self, name: &str) -> Result<(), Error> {
        let id = self.find(name)?;
        self.wrapped.push(id);
        Ok(())
    }

    /// Sets the angles of a joint about X, Y and Z, in degrees; they are stored in the order of its channels.
    ///
    /// # Errors
    ///
    /// When no joint has this name.
    pub fn set_angles(&mut self, name: &str, xyz: [f64; 3]) -> Result<(), Error> {
        let id = self.find(name)?;
        self.angles[id.0] = self.axes(id).map(|axis| xyz[axis.index()]);
        Ok(())
    }

    /// Sets the local rotation of a joint; its angles come out near those of the frame before.
    ///
    /// # Errors
    ///
    /// When no joint has this name.
    pub fn set_rotation(&mut self, name: &str, rotation: DMat3) -> Result<(), Error> {
        let id = self.find(name)?;
        self.angles[id.0] = to_euler(rotation, self.axes(id), self.angles[id.0]);
        Ok(())
    }

    /// Sets the local position of a joint, in the skeleton's unit. It matters on the axes that have a position
    /// channel.
    ///
    /// # Errors
    ///
    /// When no joint has this name.
    pub fn set_position(&mut self, name: &str, position: DVec3) -> Result<(), Error> {
        let id = self.find(name)?;
        self.positions[id.0] = position;
        Ok(())
    }

    /// Keeps the pose as the next frame. All values are rounded to four decimals.
    pub fn push_frame(&mut self) {
        for joint in self.skeleton.joints() {
            let mut angles = self.angles[joint.id.0].into_iter();
            for channel in &joint.channels {
                let value = match channel {
                    Channel::Position(axis) => self.positions[joint.id.0][axis.index()],
                    Channel::Rotation(_) => {
                        let angle = angles.next().unwrap_or(0.0);
                        if self.wrapped.contains(&joint.id) { wrap(angle) } else { angle }
                    }
                };
                // Adding zero turns −0 into 0.
                self.values.push((libm::round(value * 1e4) / 1e4 + 0.0) as f32);
            }
        }
        self.frames += 1;
    }

    /// All frames as a motion; `frame_time` in seconds.
    ///
    /// # Errors
    ///
    /// When the number of values does not fit the skeleton.
    pub fn finish(self, frame_time: f64) -> Result<Motion, Error> {
        Ok(Motion::new(self.skeleton, self.frames, frame_time, self.values)?)
    }

    fn find(&self, name: &str) -> Result<JointId, Error> {
        self.joints.get(name).copied().ok_or_else(|| Error::UnknownJoint(name.to_string()))
    }

    fn axes(&self, id: JointId) -> [Axis; 3] {
        let order = self.skeleton.joints()[id.0].rotation_order;
        order.axes().unwrap_or(Axis::ALL)
    }
}
