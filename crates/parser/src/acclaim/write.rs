//! Writes skeletons and motions of bones.

use std::fmt;
use std::io::{self, Write};

use skeleton::Channel;
use skeleton::acclaim::{AngleUnit, Bone, Columns, DegreeOfFreedom, Motion, Skeleton};

use crate::shown::Shortest;
use crate::source::{LONGEST_WORD, is_blank};

/// Writes `skeleton` as ASF: [`read_skeleton`](super::read_skeleton) makes the same skeleton of it, to the last bit.
///
/// Numbers are written in the shortest way that reads back as the same number, angles in the skeleton's unit, and lines
/// end with LF.
///
/// # Errors
///
/// When `out` fails; or, with [`io::ErrorKind::InvalidInput`] and a [`WriteError`] inside, when the format cannot
/// hold the skeleton. Then nothing has been written.
pub fn write_skeleton(skeleton: &Skeleton, out: impl Write) -> io::Result<()> {
    check_skeleton(skeleton).map_err(refused)?;
    let mut out = io::BufWriter::new(out);
    writeln!(out, ":version 1.10")?;
    if !skeleton.name.is_empty() {
        writeln!(out, ":name {}", skeleton.name)?;
    }
    let units = skeleton.units;
    writeln!(out, ":units\n  mass {}\n  length {}", Shortest(units.mass), Shortest(units.length))?;
    writeln!(out, "  angle {}", if units.angle == AngleUnit::Degrees { "deg" } else { "rad" })?;
    write_root(skeleton, &mut out)?;
    writeln!(out, ":bonedata")?;
    for bone in skeleton.bones().iter().filter(|bone| !bone.is_root()) {
        write_bone(bone, units.angle, &mut out)?;
    }
    write_hierarchy(skeleton, &mut out)?;
    out.flush()
}

fn write_root(skeleton: &Skeleton, out: &mut impl Write) -> io::Result<()> {
    let root = skeleton.root();
    write!(out, ":root\n  order")?;
    for dof in &root.dofs {
        write!(out, " {}", dof.to_string().to_uppercase())?;
    }
    writeln!(out, "\n  axis {}", root.axis.letters())?;
    writeln!(out, "  position {}", Three(skeleton.position().to_array().map(Shortest)))?;
    let angles = root.axis.angles.map(|degrees| Angle(degrees, skeleton.units.angle));
    writeln!(out, "  orientation {}", Three(angles))
}

fn write_bone(bone: &Bone, unit: AngleUnit, out: &mut impl Write) -> io::Result<()> {
    writeln!(out, "  begin\n    id {}\n    name {}", bone.id.0, bone.name)?;
    writeln!(out, "    direction {}", Three(bone.direction.to_array().map(Shortest)))?;
    writeln!(out, "    length {}", Shortest(bone.length))?;
    let angles = bone.axis.angles.map(|degrees| Angle(degrees, unit));
    writeln!(out, "    axis {} {}", Three(angles), bone.axis.letters())?;
    if !bone.dofs.is_empty() {
        write!(out, "    dof")?;
        for dof in &bone.dofs {
            write!(out, " {dof}")?;
        }
        writeln!(out)?;
    }
    if bone.dofs.iter().any(DegreeOfFreedom::is_limited) {
        let mut gap = "    limits";
        for dof in &bone.dofs {
            let unit = if matches!(dof.channel, Channel::Rotation(_)) { unit } else { AngleUnit::Degrees };
            writeln!(out, "{gap} ({} {})", Angle(dof.low, unit), Angle(dof.high, unit))?;
            gap = "          ";
        }
    }
    writeln!(out, "  end")
}

fn write_hierarchy(skeleton: &Skeleton, out: &mut impl Write) -> io::Result<()> {
    writeln!(out, ":hierarchy\n  begin")?;
    for bone in skeleton.bones().iter().filter(|bone| bone.child.is_some()) {
        write!(out, "    {}", bone.name)?;
        for child in skeleton.children(bone.id) {
            write!(out, " {}", child.name)?;
        }
        writeln!(out)?;
    }
    writeln!(out, "  end")
}

/// Writes `motion` as AMC: [`read_motion`](super::read_motion), with the same skeleton, makes the same motion of it, to
/// the last bit.
///
/// Numbers are written in the shortest way that reads back as the same number, angles in the skeleton's unit, frames
/// with the numbers from 1, and lines end with LF.
///
/// # Errors
///
/// When `out` fails; or, with [`io::ErrorKind::InvalidInput`] and a [`WriteError`] inside, when a number is not finite.
/// Then nothing has been written.
pub fn write_motion(motion: &Motion, out: impl Write) -> io::Result<()> {
    let (columns, mut rows) = (motion.columns(), (0..motion.frame_count()).map(|frame| motion.row(frame)));
    let bad = rows.find_map(|row| unwritable(columns, row.unwrap_or_default()));
    if let Some(bone) = bad {
        let frame = motion.frame_count() - rows.len();
        return Err(refused(WriteError::Value { frame, bone }));
    }
    let mut writer = MotionWriter::new(columns, out)?;
    for frame in 0..motion.frame_count() {
        writer.write_row(motion.row(frame).unwrap_or_default())?;
    }
    writer.finish()
}

/// Writes a motion as AMC row by row, as [`write_motion`] does: for one that is never in memory as a whole.
#[derive(Debug)]
pub struct MotionWriter<'a, W: Write> {
    columns: &'a Columns,
    /// The bones that have numbers.
    moving: Vec<&'a Bone>,
    out: io::BufWriter<W>,
    written: usize,
}

impl<'a, W: Write> MotionWriter<'a, W> {
    /// Writes everything in front of the first frame.
    ///
    /// # Errors
    ///
    /// When `out` fails.
    pub fn new(columns: &'a Columns, out: W) -> io::Result<MotionWriter<'a, W>> {
        let mut out = io::BufWriter::new(out);
        writeln!(out, ":FULLY-SPECIFIED")?;
        if columns.has_three_angles() {
            writeln!(out, ":FORCE-ALL-JOINTS-BE-3DOF")?;
        }
        let skeleton = columns.skeleton();
        let degrees = skeleton.units.angle == AngleUnit::Degrees;
        writeln!(out, "{}", if degrees { ":DEGREES" } else { ":RADIANS" })?;
        let moving = skeleton.bones().iter().filter(|bone| !columns.range(bone.id).is_empty()).collect();
        Ok(MotionWriter { columns, moving, out, written: 0 })
    }

    /// Writes the next frame: one number for every column, angles in degrees.
    ///
    /// # Errors
    ///
    /// When `out` fails; or, with [`io::ErrorKind::InvalidInput`] and a [`WriteError`] inside, when there are more or fewer
    /// numbers than columns, or one of them is not finite. Then nothing of the frame has been written.
    pub fn write_row(&mut self, row: &[f32]) -> io::Result<()> {
        let MotionWriter { columns, moving, out, written } = self;
        let frame = *written + 1;
        if row.len() != columns.len() {
            return Err(refused(WriteError::Row { frame, columns: columns.len(), found: row.len() }));
        }
        if let Some(bone) = unwritable(columns, row) {
            return Err(refused(WriteError::Value { frame, bone }));
        }
        let unit = columns.skeleton().units.angle;
        writeln!(out, "{frame}")?;
        for bone in moving {
            write!(out, "{}", bone.name)?;
            for (channel, &value) in columns.channels(bone.id).iter().zip(&row[columns.range(bone.id)]) {
                match channel {
                    Channel::Rotation(_) => write!(out, " {}", Angle(value, unit))?,
                    Channel::Position(_) => write!(out, " {}", Shortest(value))?,
                }
            }
            writeln!(out)?;
        }
        *written = frame;
        Ok(())
    }

    /// To be called behind the last frame.
    ///
    /// # Errors
    ///
    /// When `out` fails.
    pub fn finish(mut self) -> io::Result<()> {
        self.out.flush()
    }
}

/// The bone of the first number of a row that is not finite.
fn unwritable(columns: &Columns, row: &[f32]) -> Option<String> {
    let column = row.iter().position(|value| !value.is_finite())?;
    let bone = columns.skeleton().bones().iter().find(|bone| columns.range(bone.id).contains(&column));
    Some(bone.map(|bone| bone.name.clone()).unwrap_or_default())
}

fn refused(error: WriteError) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidInput, error)
}

/// Three numbers with blanks between them.
struct Three<T>([T; 3]);

impl<T: fmt::Display> fmt::Display for Three<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y, z] = &self.0;
        write!(f, "{x} {y} {z}")
    }
}

/// An angle, given in degrees, in the unit of a file.
struct Angle(f32, AngleUnit);

impl fmt::Display for Angle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Angle(degrees, unit) = *self;
        if unit == AngleUnit::Degrees || degrees.is_infinite() {
            return write!(f, "{}", Shortest(degrees));
        }
        // Few digits where they are enough to give back the same degrees, and all that there are otherwise.
        let radians = f64::from(degrees).to_radians();
        let few = Shortest(radians as f32).to_string();
        let is_enough =
            |text: &str| text.parse().is_ok_and(|radians: f64| radians.to_degrees() as f32 == degrees);
        if is_enough(&few) { f.write_str(&few) } else { write!(f, "{}", Shortest(radians)) }
    }
}

/// Why the format cannot hold a skeleton or a motion.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum WriteError {
    /// The skeleton's name would not be read back as it is.
    #[error(
        "the skeleton's name {name:?} cannot be written: it must not be longer than {LONGEST_WORD} bytes, begin or end \
         with a blank, or hold a line break or a word that begins with `#`"
    )]
    Name {
        /// The name.
        name: String,
    },
    /// A number of the skeleton is NaN or infinite.
    #[error("a number of `{bone}` is not finite")]
    Bone {
        /// The bone's name.
        bone: String,
    },
    /// A unit is NaN or infinite.
    #[error("a unit is not finite")]
    Units,
    /// A value is NaN or infinite.
    #[error("a number of `{bone}` in frame {frame} (counted from 1) is not finite")]
    Value {
        /// The frame, from 1.
        frame: usize,
        /// The bone's name.
        bone: String,
    },
    /// A row that does not fit the columns.
    #[error("frame {frame} (counted from 1) has {found} numbers, and the bones that move have {columns}")]
    Row {
        /// The frame, from 1.
        frame: usize,
        /// Columns of the motion.
        columns: usize,
        /// Numbers in the row.
        found: usize,
    },
}

fn check_skeleton(skeleton: &Skeleton) -> Result<(), WriteError> {
    if !is_line(&skeleton.name) {
        return Err(WriteError::Name { name: skeleton.name.clone() });
    }
    if !(skeleton.units.mass.is_finite() && skeleton.units.length.is_finite()) {
        return Err(WriteError::Units);
    }
    let is_finite = |bone: &Bone| {
        let numbers = bone.axis.angles.into_iter().chain(bone.direction.to_array()).chain([bone.length]);
        let limits = bone.dofs.iter().flat_map(|dof| [dof.low, dof.high]);
        numbers.chain(skeleton.position().to_array()).all(f32::is_finite)
            && !limits.into_iter().any(f32::is_nan)
    };
    match skeleton.bones().iter().find(|bone| !is_finite(bone)) {
        Some(bone) => Err(WriteError::Bone { bone: bone.name.clone() }),
        None => Ok(()),
    }
}

/// Whether a text is the same after it has been written behind a keyword and read.
fn is_line(text: &str) -> bool {
    let bytes = text.as_bytes();
    let edges = [bytes.first(), bytes.last()];
    let is_comment = |word: &[u8]| word.starts_with(b"#");
    bytes.len() <= LONGEST_WORD
        && edges.into_iter().flatten().all(|&byte| !is_blank(byte))
        && !bytes.contains(&b'\n')
        && !bytes.contains(&b'\r')
        && !bytes.split(|&byte| is_blank(byte)).any(is_comment)
}
