//! What the handout says of the motions in `data/`: quaternions do not always come closer to the original.
#![allow(clippy::unwrap_used)] // Helpers of tests.

use std::fs;
use std::path::Path;

use glam::Vec3;
use skeleton::{Frame, LocalPose, Representation, Skeleton, Transform};
use solutions::interpolation::interpolate_frame;

/// Every so manieth frame is a keyframe.
const GAP: usize = 4;

#[test]
fn no_representation_wins() {
    let run = larger_with_quaternions("running.bvh");
    assert!((-0.01..0.0).contains(&run), "less than 1% smaller: {run}");
    let dance = larger_with_quaternions("dance.bvh");
    assert!((-0.075..-0.065).contains(&dance), "7% smaller: {dance}");
    let arm = larger_with_quaternions("arm.bvh");
    assert!((0.045..0.055).contains(&arm), "5% larger: {arm}");
}

/// By which part the squared errors of quaternions, all added up, are larger than those of Euler angles.
fn larger_with_quaternions(name: &str) -> f64 {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data").join(name);
    let motion = parser::bvh::read(&*fs::read(path).unwrap()).unwrap().motion;
    let frames: Vec<Frame> = (0..motion.frame_count()).map(|index| motion.frame(index)).collect();
    let [euler, quaternion] = Representation::ALL.map(|of| error(motion.skeleton(), &frames, of));
    quaternion / euler - 1.0
}

fn error(skeleton: &Skeleton, frames: &[Frame], representation: Representation) -> f64 {
    let tips = |from, to, t| tips(skeleton, &interpolate_frame(skeleton, from, to, t, representation));
    let squared = |(a, b): (Vec3, Vec3)| f64::from(a.distance_squared(b));
    let mut sum = 0.0;
    for between in frames.windows(GAP + 1).step_by(GAP) {
        for (step, original) in between.iter().enumerate() {
            let made = tips(&between[0], &between[GAP], step as f32 / GAP as f32);
            sum += tips(original, original, 0.0).into_iter().zip(made).map(squared).sum::<f64>();
        }
    }
    sum
}

/// Where the joints are that nothing hangs on.
fn tips(skeleton: &Skeleton, local: &LocalPose) -> Vec<Vec3> {
    let mut pose: Vec<Transform> = Vec::new();
    let mut is_tip = vec![true; skeleton.len()];
    for (joint, (rotation, position)) in
        skeleton.joints().iter().zip(local.rotations.iter().zip(&local.positions))
    {
        let parent = joint.parent.map_or(Transform::IDENTITY, |parent| {
            is_tip[parent.0] = false;
            pose[parent.0]
        });
        pose.push(Transform {
            rotation: parent.rotation * *rotation,
            position: parent.position + parent.rotation * *position,
        });
    }
    pose.into_iter().zip(is_tip).filter(|(_, is_tip)| *is_tip).map(|(joint, _)| joint.position).collect()
}
