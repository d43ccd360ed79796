//! A motion: a skeleton and one row of numbers per frame.

use std::ops::Range;

use super::{BoneId, Posture, Skeleton};
use crate::{Axis, Channel, MotionError};

/// What each number of a frame's row means: for every bone that moves one column for each of its dofs, in the order of
/// the bones.
#[derive(Clone, Debug, PartialEq)]
pub struct Columns {
    skeleton: Skeleton,
    /// The bones that have dofs but no numbers, in order: they stay as they are at rest.
    still: Vec<BoneId>,
    three_angles: bool,
    channels: Vec<Channel>,
    /// Where the columns of each bone begin, and at last where those of all end.
    starts: Vec<usize>,
}

impl Columns {
    /// One column for each dof of each bone.
    pub fn new(skeleton: Skeleton) -> Self {
        Columns { skeleton, still: Vec::new(), three_angles: false, channels: Vec::new(), starts: Vec::new() }
            .build()
    }

    /// The same without columns for these `bones`, which stay as they are at rest.
    #[must_use]
    pub fn without(mut self, bones: &[BoneId]) -> Self {
        let has_dofs = |id: &BoneId| self.skeleton.get(*id).is_some_and(|bone| !bone.dofs.is_empty());
        self.still.extend(bones.iter().copied().filter(has_dofs));
        self.still.sort_unstable();
        self.still.dedup();
        self.build()
    }

    /// The same with columns for all three rotations of every bone that has any dof: behind those of its dofs come the
    /// missing rotations, in the order X, Y, Z. Some programs write motions like this.
    #[must_use]
    pub fn with_three_angles(mut self) -> Self {
        self.three_angles = true;
        self.build()
    }

    fn build(mut self) -> Self {
        self.channels.clear();
        self.starts.clear();
        let mut still = self.still.iter().peekable();
        for bone in self.skeleton.bones() {
            self.starts.push(self.channels.len());
            if still.next_if_eq(&&bone.id).is_some() || bone.dofs.is_empty() {
                continue;
            }
            self.channels.extend(bone.dofs.iter().map(|dof| dof.channel));
            let has = |channel| bone.dofs.iter().any(|dof| dof.channel == channel);
            let rotations = Axis::ALL.into_iter().map(Channel::Rotation);
            self.channels.extend(rotations.filter(|&channel| self.three_angles && !has(channel)));
        }
        self.starts.push(self.channels.len());
        self
    }

    /// The skeleton that moves.
    pub fn skeleton(&self) -> &Skeleton {
        &self.skeleton
    }

    /// How many numbers a frame holds.
    pub fn len(&self) -> usize {
        self.channels.len()
    }

    /// Whether nothing moves.
    pub fn is_empty(&self) -> bool {
        self.channels.is_empty()
    }

    /// Which of a row's numbers are those of `bone`; none for a bone that does not move.
    pub fn range(&self, bone: BoneId) -> Range<usize> {
        match self.starts.get(bone.0..) {
            Some(&[start, end, ..]) => start..end,
            _ => 0..0,
        }
    }

    /// What the numbers of `bone` mean.
    pub fn channels(&self, bone: BoneId) -> &[Channel] {
        &self.channels[self.range(bone)]
    }

    /// The bones that have dofs but no columns, in order.
    pub fn still(&self) -> &[BoneId] {
        &self.still
    }

    /// Whether there are columns for all three rotations of every bone that moves.
    pub fn has_three_angles(&self) -> bool {
        self.three_angles
    }
}

/// A skeleton and its movement: for every frame one row of numbers. The format says nothing about time.
#[derive(Clone, Debug, PartialEq)]
pub struct Motion {
    columns: Columns,
    frame_count: usize,
    values: Vec<f32>,
}

impl Motion {
    /// `values` holds `frame_count` rows of [`Columns::len`] numbers: angles in degrees, translations in the file's
    /// unit. A motion without frames leaves no bone still.
    ///
    /// # Errors
    ///
    /// When the number of values is not frames × columns.
    pub fn new(columns: Columns, frame_count: usize, values: Vec<f32>) -> Result<Self, MotionError> {
        let channels = columns.len();
        if frame_count.checked_mul(channels) != Some(values.len()) {
            return Err(MotionError { frames: frame_count, channels, values: values.len() });
        }
        let columns = match frame_count {
            0 if !columns.still.is_empty() => Columns { still: Vec::new(), ..columns }.build(),
            _ => columns,
        };
        Ok(Motion { columns, frame_count, values })
    }

    /// The skeleton that moves.
    pub fn skeleton(&self) -> &Skeleton {
        &self.columns.skeleton
    }

    /// What each number of a row means.
    pub fn columns(&self) -> &Columns {
        &self.columns
    }

    /// How many frames there are; may be 0.
    pub fn frame_count(&self) -> usize {
        self.frame_count
    }

    /// All rows, one behind the other.
    pub fn values(&self) -> &[f32] {
        &self.values
    }

    /// The row of frame `index`, counted from 0; `None` behind the last frame.
    pub fn row(&self, index: usize) -> Option<&[f32]> {
        if index >= self.frame_count {
            return None;
        }
        let width = self.columns.len();
        self.values.get(index * width..(index + 1) * width)
    }

    /// Sorts the row of frame `index` (from 0) by bones, into `posture`, whose memory is used again. The root's position
    /// is added to its translation. After the last frame, `posture` becomes the rest pose.
    pub fn read_posture(&self, index: usize, posture: &mut Posture) {
        posture.reset(self.skeleton());
        let Some(row) = self.row(index) else { return };
        let bones = posture.angles.iter_mut().zip(&mut posture.translations).enumerate();
        for (id, (angles, translation)) in bones {
            let range = self.columns.range(BoneId(id));
            for (channel, value) in self.columns.channels[range.clone()].iter().zip(&row[range]) {
                match channel {
                    Channel::Rotation(axis) => angles[axis.index()] = *value,
                    Channel::Position(axis) => translation[axis.index()] += *value,
                }
            }
        }
    }

    /// Frame `index` (from 0), sorted by bones.
    pub fn posture(&self, index: usize) -> Posture {
        let mut posture = Posture::default();
        self.read_posture(index, &mut posture);
        posture
    }
}
