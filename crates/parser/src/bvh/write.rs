//! Writes a motion as BVH.

use std::io::{self, Write};

use glam::Vec3;
use skeleton::{Joint, JointId, Motion, Skeleton};

use crate::shown::Shortest;
use crate::source::{LONGEST_WORD, is_blank};

/// Writes `motion` as BVH: [`read`](super::read) makes the same motion of it, to the last bit.
///
/// Numbers are written in the shortest way that reads back as the same number, lines end with LF.
///
/// # Errors
///
/// When `out` fails; or, with [`io::ErrorKind::InvalidInput`] and a [`WriteError`] inside, when the format cannot
/// hold the motion. Then nothing has been written.
pub fn write(motion: &Motion, out: impl Write) -> io::Result<()> {
    let channels = motion.skeleton().channel_count();
    if let Some(at) = motion.values().iter().position(|value| !value.is_finite()) {
        return Err(refused(WriteError::Value { frame: at / channels + 1, column: at % channels + 1 }));
    }
    let mut writer = Writer::new(motion.skeleton(), motion.frame_count(), motion.frame_time(), out)?;
    for frame in 0..motion.frame_count() {
        writer.write_row(motion.row(frame).unwrap_or_default())?;
    }
    writer.finish()
}

/// Writes a motion as BVH row by row, as [`write()`] does: for one that is never in memory as a whole.
#[derive(Debug)]
pub struct Writer<W: Write> {
    out: io::BufWriter<W>,
    channels: usize,
    frames: usize,
    written: usize,
}

impl<W: Write> Writer<W> {
    /// Writes everything in front of the first row of a motion of `frames` frames, with `frame_time` seconds from one to the
    /// next.
    ///
    /// # Errors
    ///
    /// When `out` fails; or, with [`io::ErrorKind::InvalidInput`] and a [`WriteError`] inside, when the format cannot
    /// hold such a motion. Then nothing has been written.
    pub fn new(skeleton: &Skeleton, frames: usize, frame_time: f64, out: W) -> io::Result<Writer<W>> {
        check(skeleton, frames, frame_time).map_err(refused)?;
        let mut out = io::BufWriter::new(out);
        write_hierarchy(skeleton, &mut out)?;
        writeln!(out, "MOTION\nFrames: {frames}\nFrame Time: {}", Shortest(frame_time))?;
        Ok(Writer { out, channels: skeleton.channel_count(), frames, written: 0 })
    }

    /// Writes the next frame: one number for every channel, in the order of the skeleton.
    ///
    /// # Errors
    ///
    /// When `out` fails; or, with [`io::ErrorKind::InvalidInput`] and a [`WriteError`] inside, when there are more or fewer
    /// numbers than channels, one of them is not finite, or all frames are there already. Then nothing of the row has been
    /// written.
    pub fn write_row(&mut self, row: &[f32]) -> io::Result<()> {
        self.check_row(row).map_err(refused)?;
        let mut gap = "";
        for &value in row {
            write!(self.out, "{gap}{}", Shortest(value))?;
            gap = " ";
        }
        writeln!(self.out)?;
        self.written += 1;
        Ok(())
    }

    /// To be called behind the last row.
    ///
    /// # Errors
    ///
    /// When `out` fails; or, with [`io::ErrorKind::InvalidInput`] and [`WriteError::Frames`] inside, when rows are missing.
    pub fn finish(mut self) -> io::Result<()> {
        let Writer { frames, written, .. } = self;
        if written != frames {
            return Err(refused(WriteError::Frames { declared: frames, found: written }));
        }
        self.out.flush()
    }

    fn check_row(&self, row: &[f32]) -> Result<(), WriteError> {
        let frame = self.written + 1;
        if frame > self.frames {
            return Err(WriteError::Frames { declared: self.frames, found: frame });
        }
        if row.len() != self.channels {
            return Err(WriteError::Row { frame, channels: self.channels, found: row.len() });
        }
        match row.iter().position(|value| !value.is_finite()) {
            Some(at) => Err(WriteError::Value { frame, column: at + 1 }),
            None => Ok(()),
        }
    }
}

fn refused(error: WriteError) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidInput, error)
}

fn write_hierarchy(skeleton: &Skeleton, out: &mut impl Write) -> io::Result<()> {
    writeln!(out, "HIERARCHY")?;
    // The joints whose `}` is still to be written.
    let mut open: Vec<JointId> = Vec::new();
    for joint in skeleton.joints() {
        close_down_to(joint.parent, &mut open, out)?;
        write_joint(joint, open.len(), out)?;
        open.push(joint.id);
    }
    close_down_to(None, &mut open, out)
}

fn write_joint(joint: &Joint, depth: usize, out: &mut impl Write) -> io::Result<()> {
    let Vec3 { x, y, z } = joint.offset;
    indent(depth, out)?;
    match joint {
        Joint { is_end_site: true, name, .. } => writeln!(out, "{name}")?,
        Joint { parent: None, name, .. } => writeln!(out, "ROOT {name}")?,
        Joint { name, .. } => writeln!(out, "JOINT {name}")?,
    }
    indent(depth, out)?;
    writeln!(out, "{{")?;
    indent(depth + 1, out)?;
    writeln!(out, "OFFSET {} {} {}", Shortest(x), Shortest(y), Shortest(z))?;
    if !joint.is_end_site {
        indent(depth + 1, out)?;
        write!(out, "CHANNELS {}", joint.channels.len())?;
        for channel in &joint.channels {
            write!(out, " {channel}")?;
        }
        writeln!(out)?;
    }
    Ok(())
}

/// Closes the innermost joints until `parent` is the innermost open one.
fn close_down_to(parent: Option<JointId>, open: &mut Vec<JointId>, out: &mut impl Write) -> io::Result<()> {
    while open.last().copied() != parent && open.pop().is_some() {
        indent(open.len(), out)?;
        writeln!(out, "}}")?;
    }
    Ok(())
}

/// Indents a line, but not farther than somebody would look: a skeleton can be a million joints deep.
fn indent(depth: usize, out: &mut impl Write) -> io::Result<()> {
    const TABS: [u8; 100] = [b'\t'; 100];
    out.write_all(&TABS[..depth.min(TABS.len())])
}

/// Why the format cannot hold a motion.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum WriteError {
    /// There is no joint.
    #[error("a BVH file needs at least one joint, and the skeleton has none")]
    NoJoints,
    /// A name that would not be read back as it is.
    #[error(
        "the name {name:?} cannot be written: a name must not be empty or longer than {LONGEST_WORD} bytes, begin or \
         end with a blank, or hold a line break or a lone `{{`"
    )]
    Name {
        /// The name.
        name: String,
    },
    /// An End Site that is called something else.
    #[error("the End Site name {name:?} cannot be written: it must begin with `End Site`")]
    EndSiteName {
        /// The name.
        name: String,
    },
    /// A joint that does not stand with the other joints of its branch.
    #[error("`{joint}` stands too late in the skeleton: write a joint's children before its siblings")]
    Order {
        /// The joint's name.
        joint: String,
    },
    /// A joint's offset is NaN or infinite.
    #[error("the offset of `{joint}` is not finite")]
    Offset {
        /// The joint's name.
        joint: String,
    },
    /// A value is NaN or infinite.
    #[error("number {column} of frame {frame} (both counted from 1) is not finite")]
    Value {
        /// The frame, from 1.
        frame: usize,
        /// The place in the frame, from 1.
        column: usize,
    },
    /// The frame time is NaN or infinite.
    #[error("the frame time is not finite")]
    FrameTime,
    /// Frames of a skeleton that has no channels.
    #[error("a skeleton without channels cannot have frames in a BVH file, and there are {frames}")]
    EmptyFrames {
        /// Frames of the motion.
        frames: usize,
    },
    /// A row that does not fit the skeleton.
    #[error("frame {frame} (counted from 1) has {found} numbers, and the skeleton has {channels} channels")]
    Row {
        /// The frame, from 1.
        frame: usize,
        /// Channels of the skeleton.
        channels: usize,
        /// Numbers in the row.
        found: usize,
    },
    /// More or fewer rows than were declared.
    #[error("{declared} frames were declared, and there are {found}")]
    Frames {
        /// Frames that the text's beginning speaks of.
        declared: usize,
        /// Frames that there are, at least.
        found: usize,
    },
}

fn check(skeleton: &Skeleton, frames: usize, frame_time: f64) -> Result<(), WriteError> {
    check_skeleton(skeleton)?;
    if !frame_time.is_finite() {
        return Err(WriteError::FrameTime);
    }
    match skeleton.channel_count() {
        0 if frames > 0 => Err(WriteError::EmptyFrames { frames }),
        _ => Ok(()),
    }
}

fn check_skeleton(skeleton: &Skeleton) -> Result<(), WriteError> {
    let mut open: Vec<JointId> = Vec::new();
    for joint in skeleton.joints() {
        let name = joint.name.clone();
        while open.last().copied() != joint.parent && open.pop().is_some() {}
        if open.last().copied() != joint.parent {
            return Err(WriteError::Order { joint: name });
        }
        open.push(joint.id);
        if !joint.offset.is_finite() {
            return Err(WriteError::Offset { joint: name });
        }
        if !is_name(&name) {
            return Err(WriteError::Name { name });
        }
        if joint.is_end_site && !super::hierarchy::is_end_site(name.as_bytes()) {
            return Err(WriteError::EndSiteName { name });
        }
    }
    if skeleton.is_empty() { Err(WriteError::NoJoints) } else { Ok(()) }
}

/// Whether `name` is the same after it has been written and read.
fn is_name(name: &str) -> bool {
    let bytes = name.as_bytes();
    let edges = [bytes.first(), bytes.last()];
    (1..=LONGEST_WORD).contains(&bytes.len())
        && edges.into_iter().flatten().all(|&byte| !is_blank(byte))
        && !bytes.contains(&b'\n')
        && !bytes.contains(&b'\r')
        && super::hierarchy::lone_brace(bytes).is_none()
}
