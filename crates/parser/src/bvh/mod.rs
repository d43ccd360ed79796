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

mod error;
mod hierarchy;
mod kind;
mod motion;
mod rows;
mod warning;
mod words;
mod write;

use std::fs::File;
use std::io::{Chain, Read};
use std::path::{Path, PathBuf};

use skeleton::Motion;

use crate::encoding::{self, Encoding, FromUtf16};
use crate::source::Source;

pub use error::{Error, FileError};
pub use kind::ErrorKind;
pub use warning::{Warning, WarningKind};
pub use write::{WriteError, write};

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
    let mut source = source;
    let mut first = Vec::with_capacity(4);
    source.by_ref().take(4).read_to_end(&mut first).map_err(Error::unread)?;
    let (encoding, mark) = encoding::detect(&first);
    let mut text: Chain<&[u8], _> = first[mark..].chain(source);
    match encoding {
        Encoding::Utf8 => read_text(Source::new(&mut text), Vec::new()),
        Encoding::Utf16 { little_endian } => {
            let warning = Warning { line: 1, column: 1, kind: WarningKind::Utf16 };
            read_text(Source::new(&mut FromUtf16::new(text, little_endian)), vec![warning])
        }
    }
}

/// Reads a BVH file. See [`read`].
///
/// # Errors
///
/// When the file cannot be opened, or [`read`] fails. The message begins with the path and, where there is one, the
/// place: `walk.bvh:12:26: …`
pub fn read_file(path: impl AsRef<Path>) -> Result<Reading, FileError> {
    let path = path.as_ref();
    let file = File::open(path).map_err(|cause| FileError::Open { path: PathBuf::from(path), cause })?;
    read(file).map_err(|cause| FileError::Read { path: PathBuf::from(path), cause })
}

fn read_text(mut source: Source, mut warnings: Vec<Warning>) -> Result<Reading, Error> {
    let skeleton = hierarchy::read(&mut source, &mut warnings)?;
    let motion = motion::read(&mut source, skeleton, &mut warnings)?;
    if let Some(line) = source.lone_return() {
        warnings.push(Warning { line, column: 1, kind: WarningKind::LoneReturn });
    }
    if let Some(cause) = source.take_failure() {
        return Err(Error::here(&mut source, ErrorKind::Io(cause)));
    }
    warnings.sort_by_key(|warning| (warning.line, warning.column));
    Ok(Reading { motion, warnings })
}
