//! A motion of bones as the tests look at it: every bone's path, by the matrices of the expected values.

use generator::{PlacedBone, place_bones};
use glam::{DMat3, DVec3};
use skeleton::acclaim::{Bone, Motion, Posture};

pub struct BonePaths {
    pub motion: Motion,
    postures: Vec<Posture>,
    placed: Vec<Vec<PlacedBone>>,
}

impl BonePaths {
    pub fn new(motion: Motion) -> BonePaths {
        let frames = 0..motion.frame_count();
        let postures = frames.clone().map(|frame| motion.posture(frame)).collect();
        let placed = frames.map(|frame| place_bones(&motion, frame)).collect();
        BonePaths { motion, postures, placed }
    }

    pub fn bone(&self, name: &str) -> &Bone {
        self.motion.skeleton().find(name).expect(name)
    }

    /// Where a bone starts in every frame.
    pub fn starts(&self, name: &str) -> Vec<DVec3> {
        let id = self.bone(name).id;
        self.placed.iter().map(|frame| DVec3::from_array(frame[id.0].start)).collect()
    }

    /// Where a bone ends in every frame.
    pub fn ends(&self, name: &str) -> Vec<DVec3> {
        let id = self.bone(name).id;
        self.placed.iter().map(|frame| DVec3::from_array(frame[id.0].end)).collect()
    }

    /// Where something is in every frame that a bone carries along: a direction, in the axes of the rest pose.
    pub fn directions(&self, name: &str, at_rest: DVec3) -> Vec<DVec3> {
        let id = self.bone(name).id;
        let matrix = |rows: &[[f64; 3]; 3]| DMat3::from_cols_array_2d(rows).transpose();
        self.placed.iter().map(|frame| matrix(&frame[id.0].rotation) * at_rest).collect()
    }

    /// A bone's angle about its own X, Y or Z (0, 1, 2) in every frame, in degrees.
    pub fn angles(&self, name: &str, axis: usize) -> Vec<f64> {
        let id = self.bone(name).id;
        self.postures.iter().map(|posture| f64::from(posture.angles[id.0][axis])).collect()
    }
}
