//! From joints to bones.

use glam::Vec3;
use skeleton::acclaim::{BoneData, BoneId, Columns, DegreeOfFreedom, Motion, Root, Skeleton};
use skeleton::{Axis, Channel, Joint, JointId};

use super::ConvertError;
use super::names::Names;

/// The same motion of bones, as Acclaim has it. How much time is between frames is lost.
///
/// The root becomes the root, and every joint a bone from where it is to the next joint or End Site. Where several
/// joints hang on one, or some on the root, a bone without dofs leads to each of them, and the bone of the joint on which
/// they hang has no length. All bones turn about the world's axes. Names become words: blanks become `_`, and joints of
/// one name get numbers.
///
/// # Errors
///
/// When there are several roots or none, or a joint other than the root is moved against its parent.
pub fn to_bones(motion: &skeleton::Motion) -> Result<Motion, ConvertError> {
    to_bones_by_joint(motion).map(|(motion, _)| motion)
}

/// The same as [`to_bones`], and for every joint the bone that turns with it: [`BoneId::ROOT`] for the root and for an End
/// Site. Bones that are none of these were added to lead to a joint or to an End Site.
///
/// # Errors
///
/// As [`to_bones`].
pub fn to_bones_by_joint(motion: &skeleton::Motion) -> Result<(Motion, Vec<BoneId>), ConvertError> {
    let joints = motion.skeleton().joints();
    let Some(root) = joints.first() else { return Err(ConvertError::NoJoints) };
    if let Some(second) = joints[1..].iter().find(|joint| joint.is_root()) {
        return Err(ConvertError::SeveralRoots { root: second.name.clone() });
    }
    let mut builder = Builder::new(motion, root)?;
    for joint in &joints[1..] {
        builder.add(joint)?;
    }
    let Builder { skeleton, sources, bones, .. } = builder;
    let mut values = Vec::with_capacity(sources.len().saturating_mul(motion.frame_count()));
    for frame in 0..motion.frame_count() {
        let row = motion.row(frame).unwrap_or_default();
        values.extend(sources.iter().map(|source| match *source {
            Source::Column(column) => row[column],
            Source::Fixed(value) => value,
        }));
    }
    Ok((Motion::new(Columns::new(skeleton), motion.frame_count(), values)?, bones))
}

/// Where a number of the new rows comes from.
#[derive(Clone, Copy)]
enum Source {
    /// A place in the old row.
    Column(usize),
    Fixed(f32),
}

struct Builder<'a> {
    joints: &'a [Joint],
    /// Where each joint's channels begin in a row.
    starts: Vec<usize>,
    /// How far each joint is from its parent, in all frames.
    offsets: Vec<Vec3>,
    /// What hangs on each joint, if it is one joint or End Site.
    only_children: Vec<Option<JointId>>,
    skeleton: Skeleton,
    names: Names,
    /// The bone that turns with each joint.
    bones: Vec<BoneId>,
    sources: Vec<Source>,
}

impl<'a> Builder<'a> {
    /// With all that is to be known of the joints, and with the root.
    fn new(motion: &'a skeleton::Motion, root: &Joint) -> Result<Self, ConvertError> {
        let joints = motion.skeleton().joints();
        let starts: Vec<usize> = joints
            .iter()
            .scan(0, |next, joint| Some(std::mem::replace(next, *next + joint.channels.len())))
            .collect();
        let offsets = fixed_offsets(motion, &starts)?;
        let (skeleton, sources) = root_of(root)?;
        let (names, bones) = (Names::default(), vec![BoneId::ROOT; joints.len()]);
        let only_children = only_children(joints);
        Ok(Builder { joints, starts, offsets, only_children, skeleton, names, bones, sources })
    }

    /// Adds what leads to a joint, if nothing does yet, and its own bone.
    fn add(&mut self, joint: &Joint) -> Result<(), ConvertError> {
        let parent = joint.parent.unwrap_or(JointId(0));
        let offset = self.offsets[joint.id.0];
        let mut above = self.bones[parent.0];
        let leads_here = parent.0 > 0 && self.only_children[parent.0] == Some(joint.id);
        if !leads_here && offset != Vec3::ZERO {
            let name = if joint.is_end_site { "end" } else { &joint.name };
            let name = self.names.give(&format!("{}_{name}", self.joints[parent.0].name));
            above = self.skeleton.add_bone(above, bone(name, offset, Vec::new()))?;
        }
        if joint.is_end_site {
            return Ok(());
        }
        let along = self.only_children[joint.id.0].map_or(Vec3::ZERO, |child| self.offsets[child.0]);
        let name = self.names.give(&joint.name);
        let mut dofs = Vec::with_capacity(3);
        // Of the rotations of a joint the first is leftmost in the product, and of those of a bone the last.
        for (place, channel) in joint.channels.iter().enumerate().rev() {
            if let Channel::Rotation(_) = channel {
                dofs.push(DegreeOfFreedom::unlimited(*channel));
                self.sources.push(Source::Column(self.starts[joint.id.0] + place));
            }
        }
        self.bones[joint.id.0] = self.skeleton.add_bone(above, bone(name, along, dofs))?;
        Ok(())
    }
}

/// A skeleton of the root alone, which moves along and turns about all axes, and where its numbers come from.
fn root_of(root: &Joint) -> Result<(Skeleton, Vec<Source>), ConvertError> {
    let mut axes = root.rotation_order.axes().unwrap_or([Axis::Z, Axis::Y, Axis::X]);
    axes.reverse();
    let order: Vec<Channel> =
        Axis::ALL.map(Channel::Position).into_iter().chain(axes.map(Channel::Rotation)).collect();
    let source = |channel: &Channel| {
        let place = root.channels.iter().position(|other| other == channel);
        match (place, channel) {
            (Some(place), _) => Source::Column(place),
            (None, Channel::Position(axis)) => Source::Fixed(root.offset[axis.index()]),
            (None, Channel::Rotation(_)) => Source::Fixed(0.0),
        }
    };
    let sources = order.iter().map(source).collect();
    Ok((Skeleton::new(Root { order, ..Root::default() })?, sources))
}

/// For each joint the joint or End Site that hangs on it, if there is one and no other.
fn only_children(joints: &[Joint]) -> Vec<Option<JointId>> {
    let mut counts = vec![0_usize; joints.len()];
    let mut last = vec![None; joints.len()];
    for joint in joints {
        if let Some(parent) = joint.parent {
            counts[parent.0] += 1;
            last[parent.0] = Some(joint.id);
        }
    }
    last.into_iter().zip(counts).map(|(child, count)| child.filter(|_| count == 1)).collect()
}

/// How far each joint is from its parent: the OFFSET, or what its position channels put in its place, if that is the
/// same in all frames. It may differ by as much as nobody could see.
fn fixed_offsets(motion: &skeleton::Motion, starts: &[usize]) -> Result<Vec<Vec3>, ConvertError> {
    let joints = motion.skeleton().joints();
    let mut offsets: Vec<Vec3> = joints.iter().map(|joint| joint.offset).collect();
    let moving: Vec<(&Joint, usize)> = joints
        .iter()
        .filter(|joint| !joint.is_root())
        .flat_map(|joint| {
            joint.channels.iter().enumerate().map(move |(place, channel)| (joint, place, channel))
        })
        .filter_map(|(joint, place, channel)| match (channel, motion.row(0)) {
            (Channel::Position(axis), Some(first)) => {
                let column = starts[joint.id.0] + place;
                offsets[joint.id.0][axis.index()] = first[column];
                Some((joint, column))
            }
            _ => None,
        })
        .collect();
    // Files whose OFFSETs are all zero have only their channels to say how large they are.
    let longest = offsets.iter().skip(1).map(|offset| offset.length()).fold(0.0, f32::max);
    let tolerance = 1e-5 * motion.skeleton().extent().max(longest);
    for (joint, column) in moving {
        let value = |frame: usize| motion.row(frame).map_or(0.0, |row| row[column]);
        let moved = |frame: &usize| (value(*frame) - value(0)).abs() > tolerance;
        if let Some(frame) = (1..motion.frame_count()).find(moved) {
            return Err(ConvertError::MovedJoint { joint: joint.name.clone(), frame: frame + 1 });
        }
    }
    Ok(offsets)
}

/// A bone along `offset` whose axes are the world's.
fn bone(name: String, offset: Vec3, dofs: Vec<DegreeOfFreedom>) -> BoneData {
    let (length, direction) = along(offset);
    BoneData { name, direction, length, dofs, ..BoneData::default() }
}

/// A length and a direction whose product is `offset`: nearly always to the last bit, so that converting to and fro does not move
/// joints little by little. The direction is 1 long, but for a few bits.
fn along(offset: Vec3) -> (f32, Vec3) {
    /// In how many of the last bits the length may be another.
    const NEAR: i32 = 16;
    // The squares of very small and very large lengths do not fit into single precision.
    let parts = offset.to_array().map(f64::from);
    let length = parts[0].hypot(parts[1]).hypot(parts[2]) as f32;
    if length == 0.0 || length.is_infinite() {
        return (length, Vec3::Y);
    }
    let with = |length: f32| (length, Vec3::from(parts.map(|part| (part / f64::from(length)) as f32)));
    let near = (0..=NEAR).flat_map(|bits| [bits, -bits]);
    let mut near = near.map(|bits| with(f32::from_bits(length.to_bits().wrapping_add_signed(bits))));
    near.find(|(length, direction)| *length * *direction == offset).unwrap_or_else(|| with(length))
}
