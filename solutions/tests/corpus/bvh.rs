//! BVH files: skeleton and motion in one.

use std::fs;
use std::path::Path;

use parser::bvh;
use serde::Deserialize;
use skeleton::{Frame, Joint, Motion, Pose, PositionChannels, pose_frame};

use super::{POSITION_TOLERANCE, ROTATION_TOLERANCE, Reading, Worst, distance, larger, refused, same};

/// Reads a file, and compares it with what `json` says of it, if there is one.
pub fn check(file: &Path, json: Option<&Path>) -> Reading {
    match bvh::read_file(file) {
        Ok(reading) => Reading::Read(json.map(|json| compare(&reading.motion, json))),
        Err(error) => refused(&error, file),
    }
}

/// What is known of a motion file from elsewhere.
#[derive(Deserialize)]
struct Expected {
    /// Frames in the motion: those declared.
    frames_used: usize,
    channels_per_frame: usize,
    /// As it is written in the file.
    frame_time: String,
    /// In the order of the file.
    nodes: Vec<ExpectedNode>,
    /// Some of the frames.
    frames: Vec<ExpectedFrame>,
}

#[derive(Deserialize)]
struct ExpectedNode {
    /// `root`, `joint` or `end`.
    kind: String,
    /// Empty for an End Site.
    name: String,
    /// −1 for a root.
    parent: i64,
}

#[derive(Deserialize)]
struct ExpectedFrame {
    /// From 0.
    frame: usize,
    /// Where each node is when position channels replace offsets.
    positions: Vec<[f64; 3]>,
    /// Where each node is when position channels add to offsets, if that is elsewhere.
    positions_add: Option<Vec<[f64; 3]>>,
    /// How each node is turned in the world.
    global_quat_wxyz: Vec<[f64; 4]>,
}

/// Compares `motion` with what `json` says of it. Gives how far off the worst joint is, or what is wrong.
fn compare(motion: &Motion, json: &Path) -> Result<Worst, String> {
    let text = fs::read_to_string(json).map_err(|error| error.to_string())?;
    let expected: Expected = serde_json::from_str(&text).map_err(|error| error.to_string())?;
    let skeleton = motion.skeleton();
    same("frames", &motion.frame_count(), &expected.frames_used)?;
    same("channels", &skeleton.channel_count(), &expected.channels_per_frame)?;
    same("frame time", &Ok(motion.frame_time()), &expected.frame_time.parse::<f64>())?;
    same("nodes", &skeleton.len(), &expected.nodes.len())?;
    for (joint, node) in skeleton.joints().iter().zip(&expected.nodes) {
        same("node", &describe(joint), &(node.kind.as_str(), node.name.as_str(), node.parent))?;
    }

    let extent = f64::from(skeleton.extent());
    let unit = if extent > 0.0 { extent } else { 1.0 };
    let mut worst = Worst::default();
    for frame in &expected.frames {
        let replaced = pose(motion, frame.frame, PositionChannels::Replace);
        let added = pose(motion, frame.frame, PositionChannels::Add);
        let positions_add = frame.positions_add.as_ref().unwrap_or(&frame.positions);
        same("positions", &skeleton.len(), &frame.positions.len())?;
        same("positions_add", &skeleton.len(), &positions_add.len())?;
        same("rotations", &skeleton.len(), &frame.global_quat_wxyz.len())?;
        for (id, joint) in skeleton.joints().iter().enumerate() {
            let (got, got_add) = (&replaced.transforms()[id], &added.transforms()[id]);
            let position = distance(got.position.to_array(), frame.positions[id]) / unit;
            let position_add = distance(got_add.position.to_array(), positions_add[id]) / unit;
            let rotation = angle(got.rotation.to_array(), frame.global_quat_wxyz[id]);
            let position = larger(position, position_add);
            worst.include(Worst { position, rotation });
            // Written so that NaN is wrong, too.
            if !(position <= POSITION_TOLERANCE && rotation <= ROTATION_TOLERANCE) {
                let label = skeleton.label(joint.id);
                return Err(format!(
                    "frame {}, {label}: off by {position:.1e} of the extent and {rotation:.1e} degrees",
                    frame.frame
                ));
            }
        }
    }
    if expected.frames.is_empty() { Err("no frames to compare".into()) } else { Ok(worst) }
}

fn describe(joint: &Joint) -> (&str, &str, i64) {
    let parent = joint.parent.map_or(-1, |parent| parent.0 as i64);
    match joint {
        Joint { is_end_site: true, .. } => ("end", "", parent),
        Joint { parent: None, name, .. } => ("root", name, parent),
        Joint { name, .. } => ("joint", name, parent),
    }
}

fn pose(motion: &Motion, index: usize, positions: PositionChannels) -> Pose {
    let (mut frame, mut pose) = (Frame::default(), Pose::default());
    motion.read_frame(index, positions, &mut frame);
    pose_frame(motion.skeleton(), &frame, &solutions::FK, &mut pose);
    pose
}

/// The angle between two rotations, in degrees: twice that of the quaternion which leads from one to the other. The
/// arctangent keeps small angles, which the arccosine of a number close to 1 would lose.
fn angle(got_xyzw: [f32; 4], expected_wxyz: [f64; 4]) -> f64 {
    let [x, y, z, w] = got_xyzw.map(f64::from);
    let [ew, ex, ey, ez] = expected_wxyz;
    // conjugate(expected) * got
    let scalar = ew * w + ex * x + ey * y + ez * z;
    let i = ew * x - ex * w - ey * z + ez * y;
    let j = ew * y + ex * z - ey * w - ez * x;
    let k = ew * z - ex * y + ey * x - ez * w;
    let vector = (i * i + j * j + k * k).sqrt();
    // q and −q are one rotation.
    (2.0 * vector.atan2(scalar.abs())).to_degrees()
}
