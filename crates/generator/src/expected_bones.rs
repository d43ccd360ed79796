//! `X.amc.expected.json`: where all bones of a motion are, computed in a second way.
//!
//! As for joints (see the module `expected`): products of double-precision matrices, from the values as skeleton and
//! motion store them, rounded to nine decimals, for the first frame, the one in the middle and the last.

use serde::Serialize;
use skeleton::Channel;
use skeleton::acclaim::{Bone, Motion};

use crate::Error;
use crate::expected::rounded;
use crate::matrix::{IDENTITY, Matrix, Vector, apply, product, rotation, transposed};

/// What the numbers in the file mean.
const SEMANTICS: &str = "C: the rotation of a bone's axis, for XYZ Rz*Ry*Rx. M: the product of its dofs' rotations, the \
    last one leftmost. G(bone) = G(parent)*C*M*C^-1 (column vectors, right-handed, degrees). end = start + \
    G*(length*direction). The root starts and ends at its position. Unit: that of the file.";

#[derive(Serialize)]
struct Expected<'a> {
    asf: &'a str,
    amc: &'a str,
    frames_total: usize,
    semantics: &'a str,
    bones: Vec<&'a str>,
    frames: Vec<Frame>,
}

#[derive(Serialize)]
struct Frame {
    frame: usize,
    frame_number_in_file: usize,
    start: Vec<Vector>,
    end: Vec<Vector>,
}

/// Where a bone is.
pub struct PlacedBone {
    /// G: how it is turned in the world against its rest pose.
    pub rotation: Matrix,
    /// Where it starts, in the file's unit.
    pub start: Vector,
    /// Where it ends, in the file's unit.
    pub end: Vector,
}

/// The expected values of `motion`, which is written in the files `asf` and `amc`.
///
/// # Errors
///
/// When the values cannot be written as JSON, which only numbers that are not finite could cause.
pub fn expected_bones(asf: &str, amc: &str, motion: &Motion) -> Result<Vec<u8>, Error> {
    let last = motion.frame_count().saturating_sub(1);
    let expected = Expected {
        asf,
        amc,
        frames_total: motion.frame_count(),
        semantics: SEMANTICS,
        bones: motion.skeleton().bones().iter().map(|bone| bone.name.as_str()).collect(),
        frames: [0, motion.frame_count() / 2, last].into_iter().map(|index| frame(motion, index)).collect(),
    };
    let mut json = serde_json::to_vec(&expected).map_err(std::io::Error::from)?;
    json.push(b'\n');
    Ok(json)
}

fn frame(motion: &Motion, index: usize) -> Frame {
    let bones = place_bones(motion, index);
    Frame {
        frame: index,
        frame_number_in_file: index + 1,
        start: bones.iter().map(|bone| rounded(bone.start)).collect(),
        end: bones.iter().map(|bone| rounded(bone.end)).collect(),
    }
}

/// Where the root and all bones are in frame `index`, in the order of the skeleton.
pub fn place_bones(motion: &Motion, index: usize) -> Vec<PlacedBone> {
    let skeleton = motion.skeleton();
    let row = motion.row(index).unwrap_or_default();
    let mut placed: Vec<PlacedBone> = Vec::new();
    for bone in skeleton.bones() {
        let (above, start) = match bone.parent {
            Some(parent) => (placed[parent.0].rotation, placed[parent.0].end),
            None => (IDENTITY, skeleton.position().to_array().map(f64::from)),
        };
        let axis = axis_rotation(bone);
        let (mut own, mut translation) = (IDENTITY, [0.0; 3]);
        let numbers = row.get(motion.columns().range(bone.id)).unwrap_or_default();
        for (channel, &number) in motion.columns().channels(bone.id).iter().zip(numbers) {
            match channel {
                Channel::Rotation(axis) => own = product(&rotation(axis.index(), f64::from(number)), &own),
                Channel::Position(axis) => translation[axis.index()] = f64::from(number),
            }
        }
        let turned = product(&product(&product(&above, &axis), &own), &transposed(&axis));
        let length = f64::from(bone.length);
        let way = apply(&turned, bone.direction.to_array().map(|part| length * f64::from(part)));
        let end = std::array::from_fn(|i| start[i] + way[i] + translation[i]);
        // The root is a place: it starts where it ends.
        let start = if bone.is_root() { end } else { start };
        placed.push(PlacedBone { rotation: turned, start, end });
    }
    placed
}

/// C: the rotation from the world's axes to the bone's own.
fn axis_rotation(bone: &Bone) -> Matrix {
    let turns = bone.axis.order.axes().into_iter().flatten();
    let turn = |axis: usize| rotation(axis, f64::from(bone.axis.angles[axis]));
    turns.map(|axis| turn(axis.index())).fold(IDENTITY, |all, next| product(&all, &next))
}
