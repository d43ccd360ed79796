//! The frames of a motion, and where joints are in them.

use skeleton::{Frame, Pose, pose_frame};

use super::Stage;

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
}
