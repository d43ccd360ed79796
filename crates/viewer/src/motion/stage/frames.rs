//! The frames of a motion, and where joints are in them.

use skeleton::acclaim::{Between, BonePlace, Posture};
use skeleton::{Frame, Pose, pose_frame};

use super::Stage;

/// A frame, and where everything is in it: memory that is used again for the next one.
#[derive(Clone, Debug, Default)]
pub struct Moment {
    /// The frame as functions that move joints get it.
    pub frame: Frame,
    /// Where the joints are if everything is right.
    pub pose: Pose,
    /// The frame as functions that move bones get it, where the exercise is about these.
    pub posture: Posture,
    /// Where the bones are then; nothing for one that is nowhere.
    pub places: Vec<Option<BonePlace>>,
}

impl Stage {
    /// Frame `index` (from 0) as the functions get it. Behind the last frame it is the rest pose.
    pub fn frame(&self, index: usize) -> Frame {
        let mut frame = Frame::default();
        self.read_frame(index, &mut frame);
        frame
    }

    /// All frames; none when the file holds none.
    pub fn frames(&self) -> Vec<Frame> {
        (0..self.moving_frames()).map(|index| self.frame(index)).collect()
    }

    /// Frame `index`, into `frame`, whose memory is used again.
    pub fn read_frame(&self, index: usize, frame: &mut Frame) {
        match &self.warp {
            None => self.motion.read_frame(index, self.positions, frame),
            Some(warp) => self.read_warped(warp, index, frame),
        }
    }

    /// Where the joints are in frame `index` (from 0) if everything is right.
    pub fn reference(&self, index: usize) -> Pose {
        let mut pose = Pose::default();
        self.read_reference(index, &mut Frame::default(), &mut pose);
        pose
    }

    /// The same, into `pose` and with `frame`, whose memory is used again.
    pub fn read_reference(&self, index: usize, frame: &mut Frame, pose: &mut Pose) {
        self.read_frame(index, frame);
        pose_frame(self.motion.skeleton(), frame, &solutions::FK, pose);
    }

    /// Frame `index` (from 0) as functions that move bones get it. Behind the last frame it is the rest pose, and so is
    /// every frame of a motion without bones.
    pub fn posture(&self, index: usize) -> Posture {
        let mut posture = Posture::default();
        self.read_posture(index, &mut posture);
        posture
    }

    /// The same, into `posture`, whose memory is used again.
    pub fn read_posture(&self, index: usize, posture: &mut Posture) {
        let Some(bones) = &self.bones else { return };
        let motion = bones.motion();
        match &self.warp {
            None => motion.read_posture(index, posture),
            Some(warp) if index >= warp.frame_count() => motion.read_posture(motion.frame_count(), posture),
            Some(warp) => {
                let Between { before, after, t } = warp.place(index);
                motion.read_posture(before, posture);
                if before != after && t != 0.0 {
                    *posture = (solutions::TIME_WARP.blend)(posture, &motion.posture(after), t);
                }
            }
        }
    }

    /// Reads frame `index` (from 0) into `moment`, and where the joints are in it if everything is right: in the exercise on
    /// bones where it is `of_bones`.
    ///
    /// That exercise turns all bones by Rz Ry Rx, and so does this: its right solution agrees with it in every file. That is
    /// the [reference](Stage::reference), too, but where a file lists degrees of freedom in another order or a warped frame
    /// lies between two others.
    pub fn read(&self, index: usize, of_bones: bool, moment: &mut Moment) {
        let Moment { frame, pose, posture, places } = moment;
        let Some(bones) = self.bones.as_ref().filter(|_| of_bones) else {
            return self.read_reference(index, frame, pose);
        };
        self.read_frame(index, frame);
        self.read_posture(index, posture);
        bones.read_reference(posture, places);
        bones.pose(places, pose);
    }
}
