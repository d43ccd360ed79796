//! One pose of the running figure, as a student's functions compute it and as it should be.

use exam::fk::{Answer as FkAnswer, Question as FkQuestion};
use exam::{Answer, Question};
use glam::Quat;
use grading::{Reference, Solutions};
use results::Picture;
use skeleton::{Pose, Skeleton};

use crate::Error;

/// The motion of which one frame is drawn. Students have it too, so that the picture tells them nothing new.
const MOTION: &str = include_str!("../../../data/running.bvh");

/// The frame: a long stride.
const FRAME: usize = 100;

/// From which side: turned about Y, in degrees.
const SIDE: f32 = 0.0;

/// What is asked for the picture.
#[derive(Debug)]
pub struct Portrait {
    skeleton: Skeleton,
    /// The question.
    pub question: Question,
    /// The pose as it should be.
    pub reference: Picture,
}

impl Portrait {
    /// Reads the motion.
    ///
    /// # Errors
    ///
    /// When the motion cannot be read.
    pub fn new() -> Result<Portrait, Error> {
        let broken = || Error::Motion("running.bvh".to_owned());
        let motion = parser::bvh::read(MOTION.as_bytes()).map_err(|_| broken())?.motion;
        let skeleton = motion.skeleton().clone();
        if motion.frame_count() <= FRAME {
            return Err(broken());
        }
        let frames = vec![motion.frame(FRAME)];
        let question = Question::Fk(FkQuestion::Poses { skeleton: skeleton.clone(), frames });
        let reference = picture(&skeleton, &Solutions.answer(&question)).ok_or_else(broken)?;
        Ok(Portrait { skeleton, question, reference })
    }

    /// The picture that `answer` gives, if it is an answer to the question.
    pub fn picture(&self, answer: &Answer) -> Option<Picture> {
        picture(&self.skeleton, answer)
    }
}

fn picture(skeleton: &Skeleton, answer: &Answer) -> Option<Picture> {
    let Answer::Fk(FkAnswer::Poses(poses)) = answer else { return None };
    let pose: &Pose = &poses.first()?.pose;
    if pose.len() != skeleton.len() {
        return None;
    }
    let side = Quat::from_rotation_y(SIDE.to_radians());
    let points = pose.transforms().iter().map(|transform| (side * transform.position).to_array()).collect();
    let bones = skeleton.joints().iter().enumerate().filter_map(|(index, joint)| {
        Some((u16::try_from(joint.parent?.0).ok()?, u16::try_from(index).ok()?))
    });
    Some(Picture { points, bones: bones.collect() })
}
