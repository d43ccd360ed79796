//! `X.bvh.expected.json`: where all joints of a motion are, computed in a second way.
//!
//! The file is for tests of a reader and of forward kinematics. Its numbers come from products of double-precision
//! matrices, from the channel values as the motion stores them, and are rounded to nine decimals. Three frames
//! stand in it: the first, the one in the middle and the last.

use serde::Serialize;
use skeleton::{Channel, Motion, PositionChannels};

use crate::Error;
use crate::matrix::{IDENTITY, Matrix, Vector, apply, product, quaternion_wxyz, rotation};

/// What the numbers in the file mean.
const SEMANTICS: &str = "positions: a position channel replaces the OFFSET component on its axis; positions_add, only \
    where it differs: OFFSET + channel. Local rotation: the product of the rotation channels in the order of the \
    channels (column vectors, right-handed, degrees). Global: parent's position + parent's rotation * local position. \
    Unit: that of the motion.";

#[derive(Serialize)]
struct Expected<'a> {
    file: &'a str,
    frames_declared: usize,
    frames_used: usize,
    channels_per_frame: usize,
    frame_time: &'a str,
    semantics: &'a str,
    nodes: Vec<Node<'a>>,
    frames: Vec<Frame>,
}

#[derive(Serialize)]
struct Node<'a> {
    index: usize,
    kind: &'static str,
    name: &'a str,
    parent: i64,
}

#[derive(Serialize)]
struct Frame {
    frame: usize,
    positions: Vec<Vector>,
    global_quat_wxyz: Vec<[f64; 4]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    positions_add: Option<Vec<Vector>>,
}

/// The expected values of `motion`, which is written in `file` as the BVH `text`.
///
/// # Errors
///
/// When the values cannot be written as JSON, which only numbers that are not finite could cause.
pub fn expected(file: &str, motion: &Motion, text: &str) -> Result<Vec<u8>, Error> {
    let skeleton = motion.skeleton();
    let nodes = skeleton.joints().iter().map(|joint| Node {
        index: joint.id.0,
        kind: match joint.parent {
            None => "root",
            Some(_) if joint.is_end_site => "end",
            Some(_) => "joint",
        },
        name: if joint.is_end_site { "" } else { &joint.name },
        parent: joint.parent.map_or(-1, |parent| parent.0 as i64),
    });
    let frame_time = text.lines().find_map(|line| line.strip_prefix("Frame Time: ")).unwrap_or_default();
    let last = motion.frame_count().saturating_sub(1);
    let expected = Expected {
        file,
        frames_declared: motion.frame_count(),
        frames_used: motion.frame_count(),
        channels_per_frame: skeleton.channel_count(),
        frame_time,
        semantics: SEMANTICS,
        nodes: nodes.collect(),
        frames: [0, motion.frame_count() / 2, last].into_iter().map(|index| frame(motion, index)).collect(),
    };
    let mut json = serde_json::to_vec(&expected).map_err(std::io::Error::from)?;
    json.push(b'\n');
    Ok(json)
}

fn frame(motion: &Motion, index: usize) -> Frame {
    let (rotations, positions) = global_transforms(motion, index, PositionChannels::Replace);
    let (_, added) = global_transforms(motion, index, PositionChannels::Add);
    Frame {
        frame: index,
        positions_add: (added != positions).then(|| added.into_iter().map(rounded).collect()),
        positions: positions.into_iter().map(rounded).collect(),
        global_quat_wxyz: rotations.iter().map(quaternion_wxyz).map(rounded).collect(),
    }
}

/// The global rotations and positions of all joints in frame `index`, in the order of the joints.
pub fn global_transforms(
    motion: &Motion,
    index: usize,
    channels: PositionChannels,
) -> (Vec<Matrix>, Vec<Vector>) {
    let mut row = motion.row(index).unwrap_or_default().iter().map(|value| f64::from(*value));
    let mut rotations: Vec<Matrix> = Vec::new();
    let mut positions: Vec<Vector> = Vec::new();
    for joint in motion.skeleton().joints() {
        let offset = joint.offset.to_array().map(f64::from);
        let mut translation = offset;
        let mut local = IDENTITY;
        for channel in &joint.channels {
            let value = row.next().unwrap_or_default();
            match (channel, channels) {
                (Channel::Rotation(axis), _) => local = product(&local, &rotation(axis.index(), value)),
                (Channel::Position(axis), PositionChannels::Replace) => translation[axis.index()] = value,
                (Channel::Position(axis), PositionChannels::Add) => {
                    translation[axis.index()] = offset[axis.index()] + value;
                }
            }
        }
        let (rotation, position) = match joint.parent {
            None => (local, translation),
            Some(parent) => {
                let moved = apply(&rotations[parent.0], translation);
                let start = positions[parent.0];
                let position = [start[0] + moved[0], start[1] + moved[1], start[2] + moved[2]];
                (product(&rotations[parent.0], &local), position)
            }
        };
        rotations.push(rotation);
        positions.push(position);
    }
    (rotations, positions)
}

/// All numbers to nine decimals, and none of them −0.
pub(crate) fn rounded<const N: usize>(numbers: [f64; N]) -> [f64; N] {
    numbers.map(|number| libm::round(number * 1e9) / 1e9 + 0.0)
}
