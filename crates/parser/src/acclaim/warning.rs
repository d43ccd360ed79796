//! What is odd, but readable.

use crate::shown::counted;

/// What is odd, and what has been made of it.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum WarningKind {
    /// The text is UTF-16.
    #[error("the text is UTF-16; it was converted. Save it as UTF-8 so that other programs can read it")]
    Utf16,
    /// Lines end with a carriage return alone.
    #[error("lines end with CR alone, this one first; they were read as lines all the same")]
    LoneReturn,
    /// A name is not UTF-8.
    #[error("the name `{name}` is not UTF-8; what cannot be read of it was replaced")]
    NameEncoding {
        /// The name as it was read.
        name: String,
    },
    /// A section, or a line at the top of a motion, that the format does not know.
    #[error("`{found}` is not known here; it was left out")]
    UnknownSection {
        /// The keyword.
        found: String,
    },
    /// A line in a section that the format does not know.
    #[error("`{found}` is not known here; the line was left out")]
    UnknownLine {
        /// The first word.
        found: String,
    },
    /// The root does not say which of its numbers is which.
    #[error("the root has no `order`; it was read as TX TY TZ RX RY RZ")]
    NoOrder,
    /// A bone does not say how its axes are turned.
    #[error("the bone `{bone}` has no `axis`; it was read as 0 0 0 XYZ")]
    NoAxis {
        /// The bone's name.
        bone: String,
    },
    /// A direction is not as long as it should be.
    #[error("the direction of `{bone}` is {length} long instead of 1; the bone is as much longer or shorter")]
    Direction {
        /// The bone's name.
        bone: String,
        /// How long the direction is.
        length: f32,
    },
    /// The limits do not belong to the dofs.
    #[error("`{bone}` has {} for its limits instead of two for each of {}; limits that are missing were left open", counted(*found as u64, "number"), counted(*dofs as u64, "dof"))]
    Limits {
        /// The bone's name.
        bone: String,
        /// How many numbers there are.
        found: usize,
        /// How many dofs there are.
        dofs: usize,
    },
    /// Frames are not numbered one by one.
    #[error(
        "frame {found} stands where frame {expected} should; the frames were read in the order of the file"
    )]
    FrameNumber {
        /// The number that is there.
        found: u64,
        /// The one behind the number before.
        expected: u64,
    },
    /// Bones of the skeleton are missing in the motion.
    #[error("the motion has no line for `{bone}`{}; what has no line stays as it is at rest", others(*count))]
    StillBones {
        /// The first of them.
        bone: String,
        /// How many there are.
        count: usize,
    },
    /// There is no frame.
    #[error("there are no frames; the motion was read without any")]
    NoFrames,
}

fn others(count: usize) -> String {
    match count {
        0 | 1 => String::new(),
        count => format!(" and {} more", counted(count as u64 - 1, "bone")),
    }
}
