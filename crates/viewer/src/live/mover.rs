//! The exercises whose functions pose figures by themselves.

use crate::live::package::Package;
use crate::motion::stage::Stage;

/// An exercise whose functions say, for each frame, where everything is. How its functions are asked for frames is
/// [decided by this](super::student), and so is what is told of them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mover {
    /// Forward kinematics: of joints.
    #[default]
    Fk,
    /// Acclaim forward kinematics: of bones.
    Acclaim,
}

impl Mover {
    /// The package of the exercise.
    pub fn package(self) -> Package {
        match self {
            Mover::Fk => Package::Fk,
            Mover::Acclaim => Package::Acclaim,
        }
    }

    /// Whether it moves bones, and so needs a motion that was read from Acclaim files.
    pub fn needs_bones(self) -> bool {
        match self {
            Mover::Fk => false,
            Mover::Acclaim => true,
        }
    }

    /// The parts, from 0, that put things in their places. Before all of these are begun nothing can be where it belongs.
    pub fn placing_parts(self) -> &'static [usize] {
        match self {
            Mover::Fk => &[2],
            Mover::Acclaim => &[1, 2],
        }
    }

    /// How much memory the answer for one frame of the motion takes, in joints.
    pub(crate) fn frame_size(self, stage: &Stage) -> usize {
        let joints = stage.motion().skeleton().len();
        // The place of a bone takes as much as two joints.
        let bones = stage.bones().map_or(0, |bones| bones.motion().skeleton().len());
        match self {
            Mover::Fk => joints.max(1),
            Mover::Acclaim => (joints + 2 * bones).max(1),
        }
    }
}
