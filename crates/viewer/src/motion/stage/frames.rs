//! The frames of a motion, and where joints are in them.

use skeleton::acclaim::{Between, BonePlace, Posture};
use skeleton::{Frame, Pose, pose_frame};

use super::Stage;
use crate::motion::bones::Bones;

/// A frame, and where everything is in it: memory that is used again for the next one.
#[derive(Clone, Debug, Default)]
pub struct Moment {
    /// The frame as functions that move joints get it.
    pub frame: Frame,
    /// Where the joints are if everything is right.
    pub pose: Pose,
    /// The frame as functions that move bones get it; empty where the exercise is not about these.
    pub posture: Posture,
    /// Where the bones are then; nothing for one that is nowhere.
    pub places: Vec<Option<BonePlace>>,
    /// Of a frame that lies between two others, the one behind it.
    next_frame: Frame,
    next_posture: Posture,
}

impl Stage {
    /// Frame `index` (from 0) as the functions get it. After the last frame it is the rest pose.
    pub fn frame(&self, index: usize) -> Frame {
        let mut frame = Frame::default();
        self.read_frame(index, &mut frame);
        frame
    }

    /// All frames; none when the file holds none.
    pub fn frames(&self) -> Vec<Frame> {
        (0..self.moving_frames()).map(|index| self.frame(index)).collect()
    }

    /// Frame `index`, into `frame`, whose memory is used again. One that a warp has put between two others takes memory for
    /// the other of these; [`Stage::read`] uses that again, too.
    pub fn read_frame(&self, index: usize, frame: &mut Frame) {
        self.read_frame_with(index, frame, &mut Frame::default());
    }

    /// The same, with memory for another frame.
    fn read_frame_with(&self, index: usize, frame: &mut Frame, next: &mut Frame) {
        match &self.warp {
            None => self.motion.read_frame(index, self.positions, frame),
            Some(warp) => self.read_warped(warp, index, frame, next),
        }
    }

    /// Where the joints are in frame `index` (from 0) if everything is right.
    pub fn reference(&self, index: usize) -> Pose {
        let mut pose = Pose::default();
        self.read_reference(index, &mut Frame::default(), &mut pose);
        pose
    }

    /// The same, into `pose` and with `frame`, whose memory is used again as by [`Stage::read_frame`].
    pub fn read_reference(&self, index: usize, frame: &mut Frame, pose: &mut Pose) {
        self.read_frame(index, frame);
        self.pose_reference(frame, pose);
    }

    fn pose_reference(&self, frame: &Frame, pose: &mut Pose) {
        pose_frame(self.motion.skeleton(), frame, &solutions::FK, pose);
    }

    /// Frame `index` (from 0) as functions that move bones get it. After the last frame it is the rest pose. Without bones it
    /// is empty.
    pub fn posture(&self, index: usize) -> Posture {
        let mut posture = Posture::default();
        if let Some(bones) = &self.bones {
            self.read_posture(bones, index, &mut posture, &mut Posture::default());
        }
        posture
    }

    /// The same, into `posture`, whose memory is used again, and with memory for another posture. Only what the solution's
    /// `blend` gives is new.
    fn read_posture(&self, bones: &Bones, index: usize, posture: &mut Posture, next: &mut Posture) {
        let motion = bones.motion();
        match &self.warp {
            None => motion.read_posture(index, posture),
            Some(warp) if index >= warp.frame_count() => motion.read_posture(motion.frame_count(), posture),
            Some(warp) => {
                let Between { before, after, t } = warp.place(index);
                motion.read_posture(before, posture);
                if before != after && t != 0.0 {
                    motion.read_posture(after, next);
                    *posture = (solutions::TIME_WARP.blend)(posture, next, t);
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
    ///
    /// The memory of `moment` is used again. New are only, where it is `of_bones`, the two lists of a posture that lies between
    /// two others: the solution's `blend` gives these.
    pub fn read(&self, index: usize, of_bones: bool, moment: &mut Moment) {
        let Moment { frame, pose, posture, places, next_frame, next_posture } = moment;
        self.read_frame_with(index, frame, next_frame);
        let Some(bones) = self.bones.as_ref().filter(|_| of_bones) else {
            posture.angles.clear();
            posture.translations.clear();
            places.clear();
            return self.pose_reference(frame, pose);
        };
        self.read_posture(bones, index, posture, next_posture);
        bones.read_reference(posture, places);
        bones.pose(places, pose);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::time_map::TimeMap;
    use crate::samples;

    #[test]
    fn a_moment_that_is_used_again_is_as_a_new_one() {
        let walk = samples::walk();
        let warped = walk.warped(TimeMap::Whole { old: 480, new: 1001 });
        let chain = Stage::new(samples::chain(9, 1.0), skeleton::PositionChannels::Replace);
        let mut moment = Moment::default();
        for (stage, index, of_bones) in [
            (&warped, 333, true),
            (&*walk, 100, false),
            (&warped, 500, true),
            (&chain, 3, true),
            (&warped, 1001, true),
            (&*walk, 7, true),
        ] {
            stage.read(index, of_bones, &mut moment);
            let mut new = Moment::default();
            stage.read(index, of_bones, &mut new);
            assert_eq!((&moment.frame, &moment.posture), (&new.frame, &new.posture));
            assert_eq!((&moment.places, &moment.pose), (&new.places, &new.pose));
            let about_bones = of_bones && stage.bones().is_some();
            let posture = if about_bones { stage.posture(index) } else { Posture::default() };
            assert_eq!((&moment.frame, &moment.posture), (&stage.frame(index), &posture));
            assert_eq!(moment.places.is_empty(), !about_bones);
        }
        assert_eq!(chain.posture(3), Posture::default());
    }
}
