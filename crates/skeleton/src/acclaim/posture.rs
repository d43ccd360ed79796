//! How all bones are turned in one frame.

use glam::Vec3;

use super::Skeleton;

/// The angles and translations of all bones in one frame.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Posture {
    /// For every bone, in the order of the skeleton, its angles about its own X, Y and Z axis, in degrees: zero where it
    /// has no such degree of freedom.
    pub angles: Vec<[f32; 3]>,
    /// For the root where it is, in the world, in the file's unit. For every other bone how far its end is moved, along
    /// the world's axes: zero for nearly all bones of nearly all files.
    pub translations: Vec<Vec3>,
}

impl Posture {
    /// The rest pose: nothing is turned, and the root is where the skeleton puts it.
    pub fn rest(skeleton: &Skeleton) -> Self {
        let mut posture = Posture::default();
        posture.reset(skeleton);
        posture
    }

    /// Becomes the rest pose of `skeleton`, and keeps the memory.
    pub(super) fn reset(&mut self, skeleton: &Skeleton) {
        let bones = skeleton.len();
        self.angles.clear();
        self.angles.resize(bones, [0.0; 3]);
        self.translations.clear();
        self.translations.resize(bones, Vec3::ZERO);
        if let Some(root) = self.translations.first_mut() {
            *root = skeleton.position();
        }
    }
}
