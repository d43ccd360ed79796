//! Biovision hierarchies: a skeleton and its motion in one text.
//!
//! # The format, as it is read here
//!
//! ```text
//! file      = "HIERARCHY" root+ "MOTION" "Frames" ":" count "Frame" "Time" ":" seconds number*
//! root      = "ROOT" joint
//! joint     = name "{" "OFFSET" x y z "CHANNELS" count channel* ( "JOINT" joint | end )* "}"
//! end       = "End Site" "{" "OFFSET" x y z "}"
//! channel   = "Xposition" | "Yposition" | "Zposition" | "Xrotation" | "Yrotation" | "Zrotation"
//! ```
//!
//! - Words stand apart by blanks, tabs and line breaks, as many as you like; braces and colons stand for
//!   themselves. Upper and lower case are the same in the format's own words. `OFFSET` and `CHANNELS` may change
//!   places.
//! - A name is the rest of its line, whatever letters and blanks it holds; a lone `{` ends it too, and so does one right
//!   behind the name where no other comes (`Hips{`). What stands
//!   behind `End Site` is part of that End Site's name.
//! - After the header the numbers form one stream: frame after frame, each with one number for every channel, in
//!   the order of the hierarchy. Where lines end does not matter as long as the numbers are as many as declared.
//! - Numbers are what [`str::parse`] reads, but finite: `1`, `-0.5`, `.5`, `5.`, `1e-006`.
//! - Texts are UTF-8 with or without a byte order mark, or UTF-16. Lines end with LF, CRLF, or CR alone.
//!
//! What a reader can set right without guessing is read with a [`Warning`]; all else is an [`Error`] that says
//! where, what was found, what was expected, and what to do.
//!
//! What the numbers mean is said at [`skeleton::Channel`] and [`skeleton::Frame`]: rotations in degrees, in the
//! order of the channels; a position channel takes the place of the `OFFSET` on its axis.
//!
//! The format was made by Biovision and has no standard. The common reference is M. Meredith and S. Maddock,
//! *Motion Capture File Formats Explained* (University of Sheffield, 2001). What goes beyond it here (one or two
//! rotation channels, position channels on any joint, leaf joints without an End Site, everything about blanks
//! and line ends) is what files of other programs hold.

mod hierarchy;
mod kind;
mod motion;
mod rows;
mod warning;
mod write;

use std::io::Read;
use std::path::Path;

use skeleton::Motion;

use crate::source::{Source, Syntax};
use crate::text;

pub use kind::ErrorKind;
pub use warning::WarningKind;
pub use write::{WriteError, Writer, write};

/// Why a text is not BVH, and where.
pub type Error = crate::Error<ErrorKind>;

/// Why a file cannot be read as BVH.
pub type FileError = crate::FileError<ErrorKind>;

/// Something odd in a BVH text that could be read all the same.
pub type Warning = crate::Warning<WarningKind>;

/// A motion that has been read, and what was odd about its file.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading {
    /// The skeleton and its frames.
    pub motion: Motion,
    /// What was read although it is not as it should be; at most one of each kind.
    pub warnings: Vec<Warning>,
}

/// Reads a whole BVH text.
///
/// `source` is read in chunks and needs no buffer of its own. Memory is taken for what has been read, never for
/// what the text says is to come.
///
/// # Errors
///
/// When the text is not BVH, holds too few numbers, or cannot be read. See [`ErrorKind`].
pub fn read(source: impl Read) -> Result<Reading, Error> {
    text::read(source, SYNTAX, WarningKind::Utf16, read_text)
}

/// Reads a BVH file. See [`read`].
///
/// # Errors
///
/// When the file cannot be opened, or [`read`] fails. The message begins with the path and, where there is one, the
/// place: `walk.bvh:12:26: …`
pub fn read_file(path: impl AsRef<Path>) -> Result<Reading, FileError> {
    text::read_file(path.as_ref(), read)
}

/// Braces and colons are words of their own.
const SYNTAX: Syntax = Syntax { marks: b"{}:", comment: None };

fn read_text(source: &mut Source, mut warnings: Vec<Warning>) -> Result<Reading, Error> {
    let skeleton = hierarchy::read(source, &mut warnings)?;
    let motion = motion::read(source, skeleton, &mut warnings)?;
    let warnings = text::finish(source, warnings, WarningKind::LoneReturn)?;
    Ok(Reading { motion, warnings })
}
