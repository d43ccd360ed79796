//! Collects the postures of a movement, frame by frame, into a [`Motion`].

use glam::{DMat3, DVec3};
use skeleton::acclaim::{BoneId, Columns, Motion, Skeleton};
use skeleton::{Axis, Channel};

use crate::Error;
use crate::math::{from_euler, to_euler};

/// The axes of all rotations from left to right: `dof rx ry rz` means Rz * Ry * Rx.
pub const ORDER: [Axis; 3] = [Axis::Z, Axis::Y, Axis::X];

/// The posture that is being made, and the rows of the frames made so far.
///
/// What one frame sets holds for the next ones too, until it is set again.
pub struct BoneRecorder {
    columns: Columns,
    position: DVec3,
    /// For every bone its angles about its own X, Y and Z, in degrees.
    angles: Vec<[f64; 3]>,
    values: Vec<f32>,
    frames: usize,
}

impl BoneRecorder {
    /// A recorder in front of the first frame, with all angles zero.
    pub fn new(skeleton: Skeleton) -> BoneRecorder {
        let angles = vec![[0.0; 3]; skeleton.len()];
        let columns = Columns::new(skeleton);
        BoneRecorder { columns, position: DVec3::ZERO, angles, values: Vec::new(), frames: 0 }
    }

    /// Puts the root into its place, in cm, and turns it.
    pub fn set_root(&mut self, position: DVec3, rotation: DMat3) {
        self.position = position;
        self.set_own(BoneId::ROOT, rotation);
    }

    /// Sets the angles of a bone about its own X, Y and Z, in degrees.
    ///
    /// # Errors
    ///
    /// When no bone has this name.
    pub fn set_angles(&mut self, name: &str, xyz: [f64; 3]) -> Result<(), Error> {
        let id = self.find(name)?;
        self.angles[id.0] = xyz;
        Ok(())
    }

    /// Turns a bone against its parent; `rotation` is about the axes of the rest pose, the world's. Its angles come out
    /// near those of the frame before.
    ///
    /// # Errors
    ///
    /// When no bone has this name.
    pub fn set_rotation(&mut self, name: &str, rotation: DMat3) -> Result<(), Error> {
        let id = self.find(name)?;
        let [x, y, z] = self.columns.skeleton().bones()[id.0].axis.angles.map(f64::from);
        let axes = from_euler(ORDER, [z, y, x]);
        self.set_own(id, axes.transpose() * rotation * axes);
        Ok(())
    }

    /// Keeps the posture as the next frame. All values are rounded to four decimals.
    pub fn push_frame(&mut self) {
        for (id, angles) in self.angles.iter().enumerate() {
            for channel in self.columns.channels(BoneId(id)) {
                let value = match channel {
                    Channel::Position(axis) => self.position[axis.index()],
                    Channel::Rotation(axis) => angles[axis.index()],
                };
                // Adding zero turns −0 into 0.
                self.values.push((libm::round(value * 1e4) / 1e4 + 0.0) as f32);
            }
        }
        self.frames += 1;
    }

    /// All frames as a motion.
    ///
    /// # Errors
    ///
    /// When the number of values does not fit the skeleton.
    pub fn finish(self) -> Result<Motion, Error> {
        Ok(Motion::new(self.columns, self.frames, self.values)?)
    }

    fn set_own(&mut self, id: BoneId, rotation: DMat3) {
        let [x, y, z] = self.angles[id.0];
        let [z, y, x] = to_euler(rotation, ORDER, [z, y, x]);
        self.angles[id.0] = [x, y, z];
    }

    fn find(&self, name: &str) -> Result<BoneId, Error> {
        let bone = self.columns.skeleton().find(name);
        bone.map(|bone| bone.id).ok_or_else(|| Error::UnknownBone(name.to_string()))
    }
}
