//! Small motions for tests.

use glam::Vec3;
use skeleton::{Channel, Motion, Skeleton};

/// A root that walks along X and bobs, a left and a right limb on it, and a tip each.
pub fn chain(frames: usize, scale: f32) -> Motion {
    let channels =
        |words: &str| -> Vec<Channel> { words.split(' ').filter_map(Channel::from_word).collect() };
    let mut skeleton = Skeleton::new();
    let six = channels("Xposition Yposition Zposition Zrotation Xrotation Yrotation");
    let root = skeleton.add_joint(None, "Hips", Vec3::ZERO, six).unwrap();
    let offset = Vec3::new(0.2, -0.1, 0.0) * scale;
    let left =
        skeleton.add_joint(Some(root), "LeftLeg", offset, channels("Zrotation Yrotation Xrotation")).unwrap();
    skeleton.add_end_site(left, "End Site", Vec3::new(0.0, -0.8, 0.1) * scale).unwrap();
    let right = skeleton.add_joint(Some(root), "RightLeg", offset * Vec3::new(-1.0, 1.0, 1.0), []).unwrap();
    skeleton.add_end_site(right, "End Site", Vec3::new(0.0, -0.8, 0.1) * scale).unwrap();
    let row = |i: usize| {
        let t = i as f32;
        let place = [0.1 * t * scale, (0.9 + 0.02 * (t * 0.7).sin()) * scale, 0.0];
        place.into_iter().chain([2.0 * t, 5.0, 90.0, 30.0 * (t * 0.4).sin(), 0.0, 10.0])
    };
    Motion::new(skeleton, frames, 0.1, (0..frames).flat_map(row).collect()).unwrap()
}
