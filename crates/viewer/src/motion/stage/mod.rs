//! A motion set up for being looked at: how large its figure is, where its ground is, what to follow.

mod figure;
mod frames;
mod measure;
mod warped;

use std::sync::Arc;

use glam::{Quat, Vec3};
use skeleton::{Motion, Pose, PositionChannels};

use crate::camera::Camera;
use crate::draw::canvas::Ground;
use crate::motion::body;
use crate::motion::bones::Bones;
use crate::motion::sides::sides;
use crate::motion::time_map::TimeMap;
use crate::motion::upright::Up;
use crate::scene::Side;

pub use figure::Wanted;
pub(crate) use figure::tips;
pub use frames::Moment;

/// A motion and what follows from it for the picture. Lengths are in the file's unit. Places in the picture are those of
/// the file, turned so that Y points up.
#[derive(Clone, Debug)]
pub struct Stage {
    motion: Arc<Motion>,
    /// The bones for which the joints stand.
    bones: Option<Arc<Bones>>,
    /// The frames of the motion that are shown, where these are others than its own.
    warp: Option<TimeMap>,
    positions: PositionChannels,
    up: Up,
    upright: Quat,
    sides: Vec<Side>,
    /// The tips that leave traces.
    traced: Vec<usize>,
    /// How thick the bone to each joint is.
    radii: Vec<f32>,
    /// How long the axes of each joint are.
    axes: Vec<f32>,
    size: f32,
    ground: Ground,
    /// Corners of the box in which the figure stays, relative to its anchor.
    surroundings: Vec<Vec3>,
    /// The height of the anchor, where it does not go up and down with the root.
    level: Option<f32>,
    azimuth: f32,
    too_coarse: bool,
}

/// The camera's height above the horizon, in radians.
const ELEVATION: f32 = 0.2;

impl Stage {
    /// Looks at the motion as the reference solution moves it. `positions` says what position channels do. Which way is
    /// up is told by the motion itself.
    pub fn new(motion: Motion, positions: PositionChannels) -> Stage {
        Stage::with_up(motion, positions, None)
    }

    /// The same, with this axis pointing up. `None` finds it out.
    pub fn with_up(motion: Motion, positions: PositionChannels, up: Option<Up>) -> Stage {
        let joints = motion.skeleton().joints();
        let mut stage = Stage {
            bones: None,
            warp: None,
            up: Up::Y,
            upright: Quat::IDENTITY,
            sides: sides(joints),
            traced: Vec::new(),
            radii: Vec::new(),
            axes: Vec::new(),
            motion: Arc::new(motion),
            positions,
            size: 1.0,
            ground: Ground { height: 0.0, cell: 1.0 },
            surroundings: Vec::new(),
            level: None,
            azimuth: 0.6,
            too_coarse: false,
        };
        stage.up = up.unwrap_or_else(|| stage.find_up());
        stage.upright = stage.up.rotation();
        stage.measure();
        let skeleton = stage.motion.skeleton();
        stage.radii = body::radii(skeleton, stage.size);
        stage.axes = figure::axes(skeleton, stage.size);
        let rest = skeleton.rest_positions();
        stage.traced = figure::traced(&tips(skeleton.joints()), &rest, &stage.sides, stage.size);
        stage
    }

    /// The motion as it was read. Its frames are not those that are shown when it is [warped](Stage::warped).
    pub fn motion(&self) -> &Motion {
        &self.motion
    }

    /// The bones for which the joints stand, where the motion was read from Acclaim files.
    pub fn bones(&self) -> Option<&Arc<Bones>> {
        self.bones.as_ref()
    }

    /// The same, of a motion whose joints stand for these bones.
    #[must_use]
    pub fn with_bones(self, bones: Bones) -> Stage {
        Stage { bones: Some(Arc::new(bones)), ..self }
    }

    /// How many frames there are; may be 0.
    pub fn moving_frames(&self) -> usize {
        self.warp.map_or(self.motion.frame_count(), |warp| warp.frame_count())
    }

    /// How many frames can be shown: at least one, which is the rest pose when there are none.
    pub fn frame_count(&self) -> usize {
        self.moving_frames().max(1)
    }

    /// The axis of the motion that points up.
    pub fn up(&self) -> Up {
        self.up
    }

    /// Where a place of the motion is in the picture's world.
    pub fn place(&self, position: Vec3) -> Vec3 {
        self.upright * position
    }

    /// Where the joints of a pose are in the picture's world.
    pub fn places<'a>(&'a self, pose: &'a Pose) -> impl Iterator<Item = Vec3> + 'a {
        pose.transforms().iter().map(|transform| self.place(transform.position))
    }

    /// The joints that leave traces: End Sites, and leaves without one, of those that are close together only one.
    pub fn traced(&self) -> &[usize] {
        &self.traced
    }

    /// The plane below the figure.
    pub fn ground(&self) -> Ground {
        self.ground
    }

    /// The size of the skeleton: the diagonal of the box around its rest pose. Positive.
    pub fn size(&self) -> f32 {
        self.size
    }

    /// Whether the coordinates are so large, compared with the skeleton, that single precision shows no true figure.
    pub fn is_too_coarse(&self) -> bool {
        self.too_coarse
    }

    /// On which side of the body a joint (from 0) is.
    pub fn side(&self, joint: usize) -> Side {
        self.sides.get(joint).copied().unwrap_or_default()
    }

    /// Whether left and right can be told by the joints' names.
    pub fn has_sides(&self) -> bool {
        self.sides.iter().any(|side| *side != Side::Middle)
    }

    /// What the camera follows in frame `index` (from 0): the root, which the reference and even unfinished functions
    /// put in the same place. Its ups and downs are left out unless they are large.
    pub fn anchor(&self, index: usize) -> Vec3 {
        self.anchor_of(&self.reference(index))
    }

    /// The same, where the pose is at hand.
    pub fn anchor_of(&self, pose: &Pose) -> Vec3 {
        let root = self.root(pose);
        let anchor = Vec3::new(root.x, self.level.unwrap_or(root.y), root.z);
        if anchor.is_finite() { anchor } else { Vec3::ZERO }
    }

    /// A camera that shows all that the figure does around `anchor`, and also `others`, as far as they are not much
    /// farther away than the figure is large.
    pub fn camera(&self, anchor: Vec3, others: &[Vec3], size: (usize, usize)) -> Camera {
        self.camera_from((self.azimuth, ELEVATION), anchor, others, size)
    }

    /// The same, seen from a chosen side: azimuth and elevation of the [`Camera`], in radians.
    pub fn camera_from(
        &self,
        (azimuth, elevation): (f32, f32),
        anchor: Vec3,
        others: &[Vec3],
        size: (usize, usize),
    ) -> Camera {
        let mut camera = Camera { target: anchor, distance: self.size, ..Camera::default() };
        camera.orbit(azimuth, elevation);
        let mut points: Vec<Vec3> = self.surroundings.iter().map(|place| anchor + *place).collect();
        points.extend(others.iter().filter(|place| place.distance(anchor) < 2.5 * self.size));
        camera.frame(&points, size, MARGIN, 0.5 * self.size);
        camera
    }

    /// The first joint's place, or the origin.
    fn root(&self, pose: &Pose) -> Vec3 {
        pose.transforms().first().map_or(Vec3::ZERO, |root| self.place(root.position))
    }
}

/// The share of the picture that stays free on each side.
pub const MARGIN: f32 = 0.08;

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::samples;

    #[test]
    fn a_skeleton_without_joints_is_an_empty_stage() {
        let nothing = Motion::new(skeleton::Skeleton::new(), 0, 0.1, Vec::new()).unwrap();
        let stage = Stage::new(nothing, PositionChannels::Replace);
        assert_eq!((stage.size(), stage.anchor(0)), (1.0, Vec3::ZERO));
        assert!(stage.camera(Vec3::ZERO, &[], (100, 100)).distance > 0.0);
    }

    #[test]
    fn a_motion_without_frames_shows_its_rest_pose_above_the_ground() {
        let stage = Stage::new(samples::chain(0, 1.0), PositionChannels::Replace);
        assert_eq!(stage.frame_count(), 1);
        let pose = stage.reference(0);
        let rest = stage.motion().skeleton().rest_positions();
        let places: Vec<Vec3> = pose.transforms().iter().map(|t| t.position).collect();
        assert_eq!(places, rest);
        assert!(places.iter().all(|place| place.y >= stage.ground().height - 0.3 * stage.size()));
    }

    proptest! {
        #[test]
        fn the_first_camera_shows_every_joint_in_any_unit(
            scale in prop_oneof![Just(1e-7f32), Just(0.01), Just(1.0), Just(39.37), Just(1e12)],
            frames in 0usize..40,
            width in 200usize..1500,
            height in 200usize..1500,
        ) {
            let stage = Stage::new(samples::chain(frames, scale), PositionChannels::Replace);
            for frame in 0..stage.frame_count() {
                let view = stage.camera(stage.anchor(frame), &[], (width, height)).view((width, height));
                for transform in stage.reference(frame).transforms() {
                    let spot = view.project(transform.position).expect("in front of the camera");
                    prop_assert!(spot.x > 0.0 && spot.x < width as f32 && spot.y > 0.0 && spot.y < height as f32);
                }
            }
        }

        #[test]
        fn no_numbers_make_it_panic(values in prop::collection::vec(any::<f32>(), 9 * 3)) {
            let skeleton = samples::chain(0, 1.0).skeleton().clone();
            let motion = Motion::new(skeleton, 3, 0.1, values).unwrap();
            let stage = Stage::new(motion, PositionChannels::Add);
            stage.camera(stage.anchor(1), &[Vec3::NAN, Vec3::INFINITY], (100, 100));
        }
    }
}
