//! One pose of a figure, as a student's functions compute it and as it should be.

use exam::acclaim::{Answer as AcclaimAnswer, Question as AcclaimQuestion};
use exam::fk::{Answer as FkAnswer, Question as FkQuestion};
use exam::{Answer, Question};
use glam::{Quat, Vec3};
use grading::{Reference, Solutions};
use results::Picture;
use skeleton::{Pose, Skeleton};

use crate::Error;

/// The motions of which one frame each is drawn. Students have them too, so that the picture tells them nothing new.
const RUN: &str = include_str!("../../../data/running.bvh");
const WALK: [&str; 2] = [include_str!("../../../data/walk.asf"), include_str!("../../../data/walk.amc")];

/// Their frames: a long stride each.
const RUN_FRAME: usize = 100;
const WALK_FRAME: usize = 60;

/// From which side: turned about Y, in degrees. The run passes by, and the walk comes straight on.
const RUN_SIDE: f32 = 0.0;
const WALK_SIDE: f32 = -70.0;

/// What is asked for the picture.
#[derive(Debug)]
pub struct Portrait {
    /// The question.
    pub question: Question,
    /// The pose as it should be.
    pub reference: Picture,
    figure: Figure,
}

/// What is drawn.
#[derive(Debug)]
enum Figure {
    Joints(Skeleton),
    /// So many bones.
    Bones(usize),
}

impl Portrait {
    /// The run, for functions that pose joints.
    ///
    /// # Errors
    ///
    /// When the motion cannot be read.
    pub fn of_joints() -> Result<Portrait, Error> {
        let broken = || Error::Motion("running.bvh".to_owned());
        let motion = parser::bvh::read(RUN.as_bytes()).map_err(|_| broken())?.motion;
        let skeleton = motion.skeleton().clone();
        let frames =
            if motion.frame_count() > RUN_FRAME { vec![motion.frame(RUN_FRAME)] } else { Vec::new() };
        let question = Question::Fk(FkQuestion::Poses { skeleton: skeleton.clone(), frames });
        Portrait::new(question, Figure::Joints(skeleton)).ok_or_else(broken)
    }

    /// The walk, for functions that place bones.
    ///
    /// # Errors
    ///
    /// When the motion cannot be read.
    pub fn of_bones() -> Result<Portrait, Error> {
        let broken = || Error::Motion("walk.amc".to_owned());
        let [skeleton, motion] = WALK.map(str::as_bytes);
        let skeleton = parser::acclaim::read_skeleton(skeleton).map_err(|_| broken())?.skeleton;
        let motion = parser::acclaim::read_motion(motion, &skeleton).map_err(|_| broken())?.motion;
        let (bones, postures) = (skeleton.len(), vec![motion.posture(WALK_FRAME)]);
        let question = Question::Acclaim(AcclaimQuestion::Places { skeleton, postures });
        Portrait::new(question, Figure::Bones(bones)).ok_or_else(broken)
    }

    fn new(question: Question, figure: Figure) -> Option<Portrait> {
        let reference = figure.picture(&Solutions.answer(&question))?;
        Some(Portrait { question, reference, figure })
    }

    /// The picture that `answer` gives, if it is an answer to the question.
    pub fn picture(&self, answer: &Answer) -> Option<Picture> {
        self.figure.picture(answer)
    }
}

impl Figure {
    fn picture(&self, answer: &Answer) -> Option<Picture> {
        match (self, answer) {
            (Figure::Joints(skeleton), Answer::Fk(FkAnswer::Poses(poses))) => {
                joints(skeleton, &poses.first()?.pose)
            }
            (Figure::Bones(count), Answer::Acclaim(AcclaimAnswer::Places(frames))) => {
                let places = frames.first().filter(|places| places.len() == *count)?;
                // A bone that was not visited is nowhere.
                let ends = places.iter().flatten().flat_map(|place| [place.start, place.end]);
                let points = seen_from(WALK_SIDE, ends);
                let last = u16::try_from(points.len()).ok()?;
                let bones = (0..last).step_by(2).map(|start| (start, start + 1)).collect();
                Some(Picture { points, bones })
            }
            _ => None,
        }
    }
}

fn joints(skeleton: &Skeleton, pose: &Pose) -> Option<Picture> {
    if pose.len() != skeleton.len() {
        return None;
    }
    let points = seen_from(RUN_SIDE, pose.transforms().iter().map(|transform| transform.position));
    let bones = skeleton.joints().iter().enumerate().filter_map(|(index, joint)| {
        Some((u16::try_from(joint.parent?.0).ok()?, u16::try_from(index).ok()?))
    });
    Some(Picture { points, bones: bones.collect() })
}

fn seen_from(side: f32, places: impl Iterator<Item = Vec3>) -> Vec<[f32; 3]> {
    let side = Quat::from_rotation_y(side.to_radians());
    places.map(|place| (side * place).to_array()).collect()
}

#[cfg(test)]
mod tests {
    use exam::{Functions, InProcess, Subject};
    use skeleton::acclaim::{AcclaimFunctions, Bone, Visitor};

    use super::*;

    fn drawn(functions: AcclaimFunctions) -> Picture {
        let portrait = Portrait::of_bones().unwrap();
        let mut subject = InProcess(Functions::Acclaim(functions));
        let answer = subject.ask(&portrait.question, std::time::Duration::MAX).unwrap();
        portrait.picture(&answer).unwrap()
    }

    #[test]
    fn bones_are_lines_from_their_starts_to_their_ends() {
        let picture = drawn(solutions::ACCLAIM);
        assert_eq!(picture, Portrait::of_bones().unwrap().reference);
        assert_eq!((picture.bones.len(), picture.points.len()), (31, 62));
    }

    #[test]
    fn bones_that_are_not_visited_are_not_drawn() {
        fn only_this(_: &skeleton::acclaim::Skeleton, bone: &Bone, visitor: &mut Visitor) {
            visitor.visit(bone);
        }
        let picture = drawn(AcclaimFunctions { visit_bones: only_this, ..solutions::ACCLAIM });
        assert_eq!(picture.bones, [(0, 1)]);
    }
}
