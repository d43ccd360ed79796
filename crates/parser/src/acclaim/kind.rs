//! What can be wrong.

use skeleton::MotionError;
use skeleton::acclaim::SkeletonError;

use crate::error::Problem;
use crate::shown::counted;

/// What is wrong: what was found and what was expected.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ErrorKind {
    /// What can be wrong with a text of any format.
    #[error(transparent)]
    Common(#[from] Problem),
    /// There is no text at all.
    #[error("the file is empty; {} begins with {}", which.name(), which.beginning())]
    Empty {
        /// What it should be.
        which: Which,
    },
    /// Something else altogether.
    #[error("this is not {}: it begins with `{found}`{guess}; it should begin with {}", which.name(), which.beginning())]
    NotAcclaim {
        /// What it should be.
        which: Which,
        /// The first word.
        found: String,
        /// What it may be, as ` (…)`, or nothing.
        guess: &'static str,
    },
    /// A section comes a second time.
    #[error("found `{section}` a second time, expected another section: the first is in line {line}")]
    RepeatedSection {
        /// Its keyword.
        section: &'static str,
        /// Where it was before.
        line: u64,
    },
    /// A section comes before one that it needs.
    #[error("found `{section}`, expected `{before}` above it")]
    SectionOrder {
        /// Its keyword.
        section: &'static str,
        /// What should stand above.
        before: &'static str,
    },
    /// Angles turn out to be radians when some have been read as degrees.
    #[error("found `rad`, expected it above the first angle: some have been read as degrees")]
    LateRadians,
    /// A bone or the hierarchy is still open where it may not be.
    #[error("found {found}, expected `end`: {what}, begun in line {line}, has none")]
    NotClosed {
        /// The word in quotes, or the end of the file.
        found: String,
        /// What is open.
        what: String,
        /// Where it begins.
        line: u64,
    },
    /// A bone has no name, direction or length.
    #[error("found the end of a bone, begun in line {line}, expected its `{part}`")]
    MissingPart {
        /// The keyword of what is missing.
        part: &'static str,
        /// Where the bone begins.
        line: u64,
    },
    /// A bone or the root says one thing twice.
    #[error("found `{part}` a second time, expected it once")]
    RepeatedPart {
        /// The keyword.
        part: &'static str,
    },
    /// There is nothing behind the word `name`.
    #[error("found no name, expected one on the same line")]
    NoName,
    /// A name is longer than any name should be.
    #[error("found a name longer than {longest} bytes, expected a shorter one")]
    LongName {
        /// The longest that is read.
        longest: usize,
    },
    /// A name has several words.
    #[error("found `{found}` behind the name `{name}`, expected the end of the line: a name is one word")]
    NameOfWords {
        /// The first word of the name.
        name: String,
        /// The second one.
        found: String,
    },
    /// Two bones have the same name.
    #[error("found `{name}`, the name of the bone in line {line}, expected another name")]
    RepeatedName {
        /// The name.
        name: String,
        /// Where the first one is.
        line: u64,
    },
    /// These are no axes in an order.
    #[error("found `{found}`, expected the order of three rotations, such as XYZ")]
    AxisOrder {
        /// The word.
        found: String,
    },
    /// No unit of angles is called like this.
    #[error("found `{found}`, expected deg or rad")]
    AngleUnit {
        /// The word.
        found: String,
    },
    /// No dof is called like this.
    #[error("found `{found}`, expected one of tx, ty, tz, rx, ry and rz")]
    UnknownDof {
        /// The word.
        found: String,
    },
    /// A bone that changes its length.
    #[error(
        "found `l`, expected one of tx, ty, tz, rx, ry and rz: bones that change their length are not read"
    )]
    LengthDof,
    /// One dof is listed twice.
    #[error("found `{dof}` a second time in the same list, expected another dof")]
    RepeatedDof {
        /// The word.
        dof: &'static str,
    },
    /// No bone is called like this.
    #[error("found `{found}`, expected a bone of the skeleton{near}")]
    UnknownBone {
        /// The word.
        found: String,
        /// Names that are nearly the same, as ` (…)`, or nothing.
        near: String,
    },
    /// A bone hangs on two others.
    #[error(
        "found `{bone}` a second time, expected it to have one parent: it hangs on `{parent}` since line {line}"
    )]
    SecondParent {
        /// The bone.
        bone: String,
        /// What it hangs on.
        parent: String,
        /// Where that is said.
        line: u64,
    },
    /// The root hangs on a bone.
    #[error(
        "found `root` behind `{parent}`, expected it only at the beginning of a line: it hangs on nothing"
    )]
    RootAsChild {
        /// The bone.
        parent: String,
    },
    /// A bone hangs on nothing.
    #[error("found `{bone}` nowhere behind another bone in `:hierarchy`, expected it to hang on one")]
    Unattached {
        /// The bone.
        bone: String,
    },
    /// Bones hang on each other.
    #[error("found bones that hang on each other ({bones}), expected all to hang on the root in the end")]
    Cycle {
        /// Their names.
        bones: String,
    },
    /// The frames begin with something else.
    #[error("found `{found}`, expected the number of the first frame, on a line of its own")]
    NoFrameNumber {
        /// The word.
        found: String,
    },
    /// A bone has too few numbers.
    #[error("found {} for `{bone}`, expected {dofs}", counted(*found as u64, "number"))]
    TooFewNumbers {
        /// The bone.
        bone: String,
        /// How many numbers there are.
        found: usize,
        /// How many there should be, and for which dofs.
        dofs: String,
    },
    /// A bone has too many numbers.
    #[error("found `{found}` behind the numbers of `{bone}`, expected {dofs}")]
    TooManyNumbers {
        /// The bone.
        bone: String,
        /// The first word that is too much.
        found: String,
        /// How many numbers there should be, and for which dofs.
        dofs: String,
    },
    /// A bone comes twice in one frame.
    #[error("found `{bone}` a second time in frame {frame}, expected it once")]
    RepeatedBone {
        /// The bone.
        bone: String,
        /// The frame's number in the file.
        frame: u64,
    },
    /// A bone of the first frame is missing in another one.
    #[error("found the end of frame {frame}, expected a line for `{bone}`, which the first frame has")]
    MissingBone {
        /// The bone.
        bone: String,
        /// The frame's number in the file.
        frame: u64,
    },
    /// A bone is in a frame, but not in the first one.
    #[error(
        "found `{bone}` in frame {frame}, expected the bones of the first frame, which has none of this name"
    )]
    NewBone {
        /// The bone.
        bone: String,
        /// The frame's number in the file.
        frame: u64,
    },
    /// The skeleton does not take a bone.
    #[error("{0}")]
    Skeleton(#[source] SkeletonError),
    /// The numbers do not make whole frames.
    #[error("{0}")]
    Motion(#[source] MotionError),
}

/// Which of the two files of a figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Which {
    /// The skeleton, `.asf`.
    Skeleton,
    /// The motion, `.amc`.
    Motion,
}

impl Which {
    fn name(self) -> &'static str {
        match self {
            Which::Skeleton => "an Acclaim skeleton (.asf)",
            Which::Motion => "an Acclaim motion (.amc)",
        }
    }

    fn beginning(self) -> &'static str {
        match self {
            Which::Skeleton => "`:version`",
            Which::Motion => "`:FULLY-SPECIFIED`",
        }
    }
}
