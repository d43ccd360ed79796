//! The exercises whose functions pose figures by themselves.

use crate::live::package::Package;
use crate::live::student::time_warp;
use crate::motion::source::Warping;
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
    /// Time warping: of all frames of a warped motion at once.
    TimeWarp,
}

impl Mover {
    /// The package of the exercise.
    pub fn package(self) -> Package {
        match self {
            Mover::Fk => Package::Fk,
            Mover::Acclaim => Package::Acclaim,
            Mover::TimeWarp => Package::TimeWarp,
        }
    }

    /// Whether it moves bones, and so needs a motion that was read from Acclaim files.
    pub fn needs_bones(self) -> bool {
        match self {
            Mover::Fk => false,
            Mover::Acclaim | Mover::TimeWarp => true,
        }
    }

    /// Whether its functions move the motion on `stage`: of a pair only the warped one has anything to do with time warping.
    pub fn moves(self, stage: &Stage) -> bool {
        match self {
            Mover::Fk | Mover::Acclaim => true,
            Mover::TimeWarp => stage.warp().is_some(),
        }
    }

    /// Whether one answer holds all frames of the motion on `stage`, whichever of them is asked about. Where one fails, all do.
    pub(crate) fn is_asked_whole(self, stage: &Stage) -> bool {
        match self {
            Mover::Fk | Mover::Acclaim => false,
            Mover::TimeWarp => time_warp::is_asked_whole(stage),
        }
    }

    /// How motions are warped where nothing is said of it; `None` where they are not.
    pub(crate) fn usual_warp(self) -> Option<Warping> {
        match self {
            Mover::Fk | Mover::Acclaim => None,
            // To twice as many frames.
            Mover::TimeWarp => Some(Warping { frames: None, keyframes: None }),
        }
    }

    /// The parts, from 0, that put things in their places in the motion on `stage`. Before all of these are begun nothing can be
    /// where it belongs.
    pub fn placing_parts(self, stage: &Stage) -> &'static [usize] {
        match self {
            Mover::Fk => &[2],
            Mover::Acclaim => &[1, 2],
            Mover::TimeWarp if self.is_asked_whole(stage) => &[2],
            Mover::TimeWarp => &[1],
        }
    }

    /// How many frames of the motion are asked about at once, where it is to be about so many `joints`.
    pub(crate) fn frames_at_once(self, stage: &Stage, joints: usize) -> usize {
        match self.is_asked_whole(stage) {
            true => stage.frame_count(),
            false => (joints / self.frame_size(stage)).max(1),
        }
    }

    /// How much memory the answer for one frame of the motion takes, in joints.
    pub(crate) fn frame_size(self, stage: &Stage) -> usize {
        let joints = stage.motion().skeleton().len();
        // The place of a bone takes as much as two joints.
        let bones = stage.bones().map_or(0, |bones| bones.motion().skeleton().len());
        match self {
            Mover::Fk | Mover::TimeWarp => joints.max(1),
            Mover::Acclaim => (joints + 2 * bones).max(1),
        }
    }
}
