//! The bones that the joints of a motion stand for, where it was read from Acclaim files.

use glam::{Quat, Vec3};
use skeleton::acclaim::{AcclaimFunctions, Bone, BoneId, BonePlace, Motion, Posture};
use skeleton::{Pose, RotationOrder, Transform};

/// A motion of bones, beside the same motion of joints as [`parser::acclaim::to_joints`] makes it: a joint stands for the
/// start of its bone, and an End Site for the end of the bone on which nothing hangs. Where such an end is moved, a joint
/// stands for it, too.
#[derive(Clone, Debug)]
pub struct Bones {
    motion: Motion,
    /// For every joint the bone that starts there, or else the one that ends there.
    of_joints: Vec<BoneId>,
    /// For every joint whether it stands for the end of its bone.
    ends: Vec<bool>,
}

impl Bones {
    /// `joints` are those that were made of the bones of `motion`.
    pub fn new(motion: Motion, joints: &skeleton::Skeleton) -> Bones {
        let (mut of_joints, mut ends) = (Vec::new(), Vec::new());
        for joint in joints.joints() {
            let starting = motion.skeleton().find(&joint.name).filter(|_| !joint.is_end_site);
            let ending = || joint.parent.map_or(BoneId::ROOT, |parent| of_joints[parent.0]);
            let bone = starting.map_or_else(ending, |bone| bone.id);
            of_joints.push(bone);
            ends.push(starting.is_none());
        }
        Bones { motion, of_joints, ends }
    }

    /// The motion of bones.
    pub fn motion(&self) -> &Motion {
        &self.motion
    }

    /// How many joints stand for bones, with the End Sites.
    pub fn joint_count(&self) -> usize {
        self.of_joints.len()
    }

    /// The bone that starts at joint `joint` (from 0), or ends at it when none does.
    pub fn of_joint(&self, joint: usize) -> BoneId {
        self.of_joints.get(joint).copied().unwrap_or(BoneId::ROOT)
    }

    /// Whether joint `joint` (from 0) stands for where its bone ends.
    pub fn is_end(&self, joint: usize) -> bool {
        self.ends.get(joint).copied().unwrap_or_default()
    }

    /// How the own axes of the bone of joint `joint` (from 0) are turned against the world's at rest.
    pub fn own_axes(&self, joint: usize) -> Quat {
        let bone = self.motion.skeleton().get(self.of_joint(joint));
        bone.map_or(Quat::IDENTITY, |bone| bone.axis_rotation)
    }

    /// Makes `pose` that of the joints whose bones are at `places`. A bone without a place is nowhere: its numbers are NaN.
    pub fn pose(&self, places: &[Option<BonePlace>], pose: &mut Pose) {
        pose.reset(self.of_joints.len());
        for (joint, transform) in pose.transforms_mut().iter_mut().enumerate() {
            let place = places.get(self.of_joint(joint).0).copied().flatten();
            *transform = place.map_or(NOWHERE, |place| Transform {
                rotation: place.rotation * self.own_axes(joint).inverse(),
                position: if self.ends[joint] { place.end } else { place.start },
            });
        }
    }

    /// The pose of so many joints of which nothing is known.
    pub fn nowhere(joints: usize) -> Pose {
        Pose::from(vec![NOWHERE; joints])
    }

    /// Where all bones are in `posture`, by the reference solution.
    pub fn reference(&self, posture: &Posture) -> Vec<Option<BonePlace>> {
        let mut places = Vec::new();
        self.read_reference(posture, &mut places);
        places
    }

    /// The same, into `places`, whose memory is used again.
    pub fn read_reference(&self, posture: &Posture, places: &mut Vec<Option<BonePlace>>) {
        exam::acclaim::read_places(self.motion.skeleton(), posture, &RIGHT, places);
    }

    /// The bones that turn about their axes in another order than Rz Ry Rx, which is that of the exercise: their degrees of
    /// freedom are not listed as rx, ry, rz.
    pub fn in_other_orders(&self) -> impl Iterator<Item = &Bone> + Clone {
        let usual = |bone: &&Bone| matches!(bone.rotation_order, RotationOrder::Zyx | RotationOrder::None);
        self.motion.skeleton().bones().iter().filter(move |bone| !usual(bone))
    }
}

/// The reference solution, but that its part 3 does not call itself: the bones of a file may hang on each other to any depth.
/// They stand parents first.
const RIGHT: AcclaimFunctions = AcclaimFunctions {
    visit_bones: |skeleton, _, visitor| skeleton.bones().iter().for_each(|bone| visitor.visit(bone)),
    ..solutions::ACCLAIM
};

const NOWHERE: Transform = Transform { rotation: Quat::NAN, position: Vec3::NAN };

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples::{chain_of_bones, walk, walk_with};

    #[test]
    fn joints_are_where_the_bones_for_which_they_stand_start_and_end() {
        let stage = walk();
        let (bones, mut pose) = (stage.bones().unwrap(), Pose::default());
        for frame in [0, 100, 479] {
            let posture = bones.motion().posture(frame);
            bones.pose(&bones.reference(&posture), &mut pose);
            for (own, other) in pose.transforms().iter().zip(stage.reference(frame).transforms()) {
                assert!(own.position.distance(other.position) < 1e-3, "{own:?} {other:?}");
                assert!(grading::fk::angle_between(own.rotation, other.rotation) < 0.01);
            }
        }
        assert_eq!(pose.len(), stage.motion().skeleton().len());
    }

    #[test]
    fn a_joint_stands_for_the_end_of_a_bone_that_is_moved() {
        let stage = walk_with(
            |skeleton| skeleton.replacen("dof rx\n    limits (-75 40)", "dof rx ty", 1),
            |line| line.strip_prefix("ltoes ").map(|number| format!("ltoes {number} -40")),
        );
        let (bones, mut pose) = (stage.bones().unwrap(), Pose::default());
        let places = bones.reference(&bones.motion().posture(100));
        bones.pose(&places, &mut pose);
        let joints = stage.motion().skeleton().joints();
        for (own, other) in pose.transforms().iter().zip(stage.reference(100).transforms()) {
            assert!(own.position.distance(other.position) < 1e-3, "{own:?} {other:?}");
        }
        let end = joints.iter().position(|joint| joint.name == "ltoes_end").unwrap();
        let toes = bones.motion().skeleton().find("ltoes").unwrap();
        assert!(bones.is_end(end) && !bones.is_end(end - 1));
        assert_eq!((bones.of_joint(end), bones.of_joint(end + 1)), (toes.id, toes.id));
        assert_eq!(pose.transforms()[end].position, places[toes.id.0].unwrap().end);
        assert!(joints[end + 1].is_end_site && !joints[end].is_end_site);
    }

    #[test]
    fn a_bone_without_a_place_is_nowhere() {
        let stage = walk();
        let (bones, mut pose) = (stage.bones().unwrap(), Pose::default());
        let mut places = bones.reference(&bones.motion().posture(0));
        let joints = stage.motion().skeleton().joints();
        let joint = joints.iter().position(|joint| joint.name == "lhumerus").unwrap();
        places[bones.of_joint(joint).0] = None;
        bones.pose(&places, &mut pose);
        let lost = pose.transforms().iter().filter(|transform| transform.position.is_nan()).count();
        assert!(pose.transforms()[joint].position.is_nan());
        assert_eq!(lost, 1);
    }

    #[test]
    fn a_chain_of_any_depth_has_its_places() {
        const COUNT: usize = 200_000;
        let places = || {
            let bones = Bones::new(chain_of_bones(COUNT), &skeleton::Skeleton::new());
            bones.reference(&Posture::default())
        };
        // As much as a thread usually has.
        let thread = std::thread::Builder::new().stack_size(2 << 20).spawn(places);
        let places = thread.unwrap().join().unwrap();
        assert_eq!(places.len(), COUNT + 1);
        assert!(places.iter().all(Option::is_some));
        assert_eq!(places[COUNT].unwrap().end, Vec3::Y * COUNT as f32);
    }
}
