//! Acclaim files: a skeleton in one text (`.asf`), and motions of it in others (`.amc`).
//!
//! # The skeleton, as it is read here
//!
//! ```text
//! file      = ":version" text  ":name" text  ":units" unit*  ":documentation" text
//!             ":root" root  ":bonedata" bone*  ":hierarchy" "begin" line* "end"  ":skin" text
//! unit      = "mass" x | "length" x | "angle" ( "deg" | "rad" )
//! root      = "order" dof*  "axis" order  "position" x y z  "orientation" x y z
//! bone      = "begin"  "id" text  "name" word  "direction" x y z  "length" x  "axis" x y z order
//!             "dof" dof*  "limits" ( "(" x x ")" )*  "end"
//! line      = parent child*
//! dof       = "tx" | "ty" | "tz" | "rx" | "ry" | "rz"
//! order     = "XYZ" | "XZY" | "YXZ" | "YZX" | "ZXY" | "ZYX"
//! ```
//!
//! # The motion
//!
//! ```text
//! file      = flag* frame*
//! flag      = ":FULLY-SPECIFIED" | ":DEGREES" | ":RADIANS" | ":FORCE-ALL-JOINTS-BE-3DOF"
//! frame     = number ( name x* )*
//! ```
//!
//! - Words stand apart by blanks and tabs. Upper and lower case are the same, in names too. `#` at the beginning of a
//!   word begins a comment, which ends with the line; `#!OML:ASF …` is one.
//! - A name, a list of dofs, a parent with its children, a frame number, and a bone with its numbers stand on one line
//!   each. Parts of the root and of a bone may come in any order. Brackets and commas between limits are like blanks; a
//!   limit may be `inf` or `-inf`.
//! - `:units`, `:name`, `:version` and `:documentation` may be missing. What other sections and lines say is left
//!   out: with a warning, unless the format's definition knows them (`:skin`, `bodymass`, `cofmass`).
//! - Bones may be listed in any order; they come out with parents in front of their children.
//! - A bone without dofs needs no line in a motion. Bones with dofs that have no line in the first frame stay as they are
//!   at rest, with a warning; all frames have the same bones.
//! - Brackets and commas around numbers and dofs are left out. A comma in front of a digit is not: it may be meant as a
//!   decimal point, and is an error.
//! - Texts are UTF-8 with or without a byte order mark, or UTF-16. Lines end with LF, CRLF, or CR alone.
//!
//! What a reader can set right without guessing is read with a [`Warning`]; all else is an [`Error`] that says
//! where, what was found, what was expected, and what to do.
//!
//! What the numbers mean is said at [`skeleton::acclaim`].
//!
//! [`to_joints`] and [`to_bones`] lead to the words of BVH and back.
//!
//! The format was defined by M. Schafer at Acclaim (*Acclaim Skeleton File Definition V1.10*, 1995). What goes beyond it
//! here (`:DEGREES`, `:RADIANS`, `:FORCE-ALL-JOINTS-BE-3DOF`, comments anywhere) is what files of other programs hold.

mod bones;
mod convert;
mod frames;
mod help;
mod hierarchy;
mod kind;
mod near;
mod root;
mod sections;
mod warning;
mod words;
mod write;

use std::io::Read;
use std::path::Path;

use skeleton::acclaim::{Motion, Skeleton};

use crate::source::Syntax;
use crate::text;

pub use convert::{ConvertError, depth_first, to_bones, to_bones_by_joint, to_joints};
pub use kind::{ErrorKind, Which};
pub use warning::WarningKind;
pub use write::{MotionWriter, WriteError, write_motion, write_skeleton};

/// Why a text is not Acclaim, and where.
pub type Error = crate::Error<ErrorKind>;

/// Why a file cannot be read as Acclaim.
pub type FileError = crate::FileError<ErrorKind>;

/// Something odd in an Acclaim text that could be read all the same.
pub type Warning = crate::Warning<WarningKind>;

/// A skeleton that has been read, and what was odd about its file.
#[derive(Clone, Debug, PartialEq)]
pub struct SkeletonReading {
    /// The root and the bones.
    pub skeleton: Skeleton,
    /// What was read although it is not as it should be; at most one of each kind.
    pub warnings: Vec<Warning>,
}

/// A motion that has been read, and what was odd about its file.
#[derive(Clone, Debug, PartialEq)]
pub struct MotionReading {
    /// The frames, and the skeleton that they move.
    pub motion: Motion,
    /// What was read although it is not as it should be; at most one of each kind.
    pub warnings: Vec<Warning>,
}

/// Words stand apart by blanks alone.
const SYNTAX: Syntax = Syntax { marks: b"", comment: Some(b'#') };

/// Reads a whole ASF text.
///
/// `source` is read in chunks and needs no buffer of its own. Memory is taken for what has been read.
///
/// # Errors
///
/// When the text is not ASF or cannot be read. See [`ErrorKind`].
pub fn read_skeleton(source: impl Read) -> Result<SkeletonReading, Error> {
    text::read(source, SYNTAX, WarningKind::Utf16, |source, mut warnings| {
        let skeleton = sections::read(source, &mut warnings)?;
        let warnings = text::finish(source, warnings, WarningKind::LoneReturn)?;
        Ok(SkeletonReading { skeleton, warnings })
    })
}

/// Reads a whole AMC text, a motion of `skeleton`.
///
/// `source` is read in chunks and needs no buffer of its own. Memory is taken for what has been read.
///
/// # Errors
///
/// When the text is not AMC, does not fit the skeleton, or cannot be read. See [`ErrorKind`].
pub fn read_motion(source: impl Read, skeleton: &Skeleton) -> Result<MotionReading, Error> {
    text::read(source, SYNTAX, WarningKind::Utf16, |source, mut warnings| {
        let motion = frames::read(source, skeleton, &mut warnings)?;
        let warnings = text::finish(source, warnings, WarningKind::LoneReturn)?;
        Ok(MotionReading { motion, warnings })
    })
}

/// Reads an ASF file. See [`read_skeleton`].
///
/// # Errors
///
/// When the file cannot be opened, or [`read_skeleton`] fails. The message begins with the path and, where there is
/// one, the place: `walk.asf:12:26: …`
pub fn read_skeleton_file(path: impl AsRef<Path>) -> Result<SkeletonReading, FileError> {
    text::read_file(path.as_ref(), read_skeleton)
}

/// Reads an AMC file. See [`read_motion`].
///
/// # Errors
///
/// When the file cannot be opened, or [`read_motion`] fails. The message begins with the path and, where there is one,
/// the place: `walk.amc:12:26: …`
pub fn read_motion_file(path: impl AsRef<Path>, skeleton: &Skeleton) -> Result<MotionReading, FileError> {
    text::read_file(path.as_ref(), |file| read_motion(file, skeleton))
}
