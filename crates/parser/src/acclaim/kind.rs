//! What can be wrong, and what to do about it.

use std::io;

use skeleton::MotionError;
use skeleton::acclaim::SkeletonError;

use crate::error::{Common, Kind, Problem};
use crate::number::BadNumber;
use crate::shown::counted;

/// What is wrong: what was found and what was expected.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ErrorKind {
    /// The system could not read on.
    #[error("cannot be read: {0}")]
    Io(#[source] io::Error),
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
    /// Version control has left its marks.
    #[error("found `{found}`, expected Acclaim: this marks a merge conflict that has not been resolved")]
    MergeConflict {
        /// The mark.
        found: String,
    },
    /// Another word was expected.
    #[error("found `{found}`, expected {expected}")]
    Unexpected {
        /// The word that is there.
        found: String,
        /// What could stand there.
        expected: &'static str,
    },
    /// The text ends too soon.
    #[error("the file ends here, expected {expected}")]
    Ended {
        /// What could stand there.
        expected: &'static str,
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
    /// A count is larger than any that can be held.
    #[error("found `{found}`, which is too large, expected {expected}")]
    LargeCount {
        /// The word.
        found: String,
        /// What is counted.
        expected: &'static str,
    },
    /// A number does not look like one.
    #[error("found `{found}`, expected a number")]
    NotANumber {
        /// The word.
        found: String,
    },
    /// A number with a comma or a semicolon.
    #[error("found `{found}`, expected a number without a comma or a semicolon")]
    Separator {
        /// The word.
        found: String,
    },
    /// NaN, or infinity, or too large to be held.
    #[error("found `{found}`, expected a finite number")]
    NotFinite {
        /// The word.
        found: String,
    },
    /// Something is longer than any number.
    #[error("found more than {longest} characters without a blank, expected a number")]
    LongNumber {
        /// The longest that is read.
        longest: usize,
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

impl From<Problem> for ErrorKind {
    fn from(Problem(problem): Problem) -> Self {
        match problem {
            Common::Io(cause) => ErrorKind::Io(cause),
            Common::Ended { expected } => ErrorKind::Ended { expected },
            Common::Unexpected { found, expected } => ErrorKind::Unexpected { found, expected },
            Common::MergeConflict { found } => ErrorKind::MergeConflict { found },
            Common::LargeCount { found, expected } => ErrorKind::LargeCount { found, expected },
            Common::BadNumber { found, problem, longest } => match problem {
                BadNumber::NotANumber => ErrorKind::NotANumber { found },
                BadNumber::Separator => ErrorKind::Separator { found },
                BadNumber::NotFinite => ErrorKind::NotFinite { found },
                BadNumber::TooLong => ErrorKind::LongNumber { longest },
            },
        }
    }
}

impl Kind for ErrorKind {
    fn help(&self) -> &'static str {
        match self {
            ErrorKind::Io(_) => "Check that the file is a file, and that you may read it.",
            ErrorKind::Empty { .. } | ErrorKind::NotAcclaim { .. } => "Check that this is the file you mean.",
            ErrorKind::MergeConflict { .. } => {
                "Keep one of the two versions, and delete the lines that begin with <<<<<<<, ======= and >>>>>>>."
            }
            ErrorKind::Unexpected { .. } => {
                "Look for a word that is missing, misspelt or too many, here or just above."
            }
            ErrorKind::Ended { .. } => "The file seems to be cut off: get it again from where it came from.",
            ErrorKind::RepeatedSection { .. } | ErrorKind::RepeatedPart { .. } => {
                "Keep the one that is right, and delete the other."
            }
            ErrorKind::SectionOrder { .. } | ErrorKind::LateRadians => {
                "Move it: the sections are :version, :name, :units, :documentation, :root, :bonedata and :hierarchy."
            }
            ErrorKind::NotClosed { .. } => "Every `begin` needs its `end`, on a line of its own.",
            ErrorKind::MissingPart { .. } => {
                "Every bone has a `name`, a `direction` and a `length`: add the line."
            }
            ErrorKind::NoName => "Write a name behind the word.",
            ErrorKind::LongName { .. } => "Shorten the name; or look for a line break that is missing.",
            ErrorKind::NameOfWords { .. } => "Join the words with `_`, here and wherever the bone is meant.",
            ErrorKind::RepeatedName { .. } => {
                "Bones are known by their names, in which upper and lower case are the same: call one of them otherwise."
            }
            ErrorKind::AxisOrder { .. } => "Write each of X, Y and Z once, without blanks between them.",
            ErrorKind::AngleUnit { .. } => "Write `angle deg` for degrees or `angle rad` for radians.",
            ErrorKind::UnknownDof { .. } => "Correct the word; t is for translation, r for rotation.",
            ErrorKind::LengthDof => {
                "Take `l` out of the list, and its number out of every frame of the motion."
            }
            ErrorKind::RepeatedDof { .. } => "A bone can have each of the six dofs once: correct the word.",
            ErrorKind::UnknownBone { .. } => {
                "Correct the name, here or where the skeleton gives it; or use the skeleton that belongs to the motion."
            }
            ErrorKind::SecondParent { .. } => "Delete the bone in one of the two lines.",
            ErrorKind::RootAsChild { .. } => "Delete it there.",
            ErrorKind::Unattached { .. } => {
                "Write it behind the bone at whose end it starts, or behind `root`, in `:hierarchy`."
            }
            ErrorKind::Cycle { .. } => {
                "Look in `:hierarchy` for the line in which one of them should hang on another bone."
            }
            ErrorKind::NoFrameNumber { .. } => {
                "Write 1 above the first frame, or look for a word that is misspelt."
            }
            ErrorKind::TooFewNumbers { .. } | ErrorKind::TooManyNumbers { .. } => {
                "Every bone has a line with one number for each of its dofs. Does the motion belong to this skeleton?"
            }
            ErrorKind::RepeatedBone { .. } => {
                "Delete one of the two lines, or look for a frame number that is missing."
            }
            ErrorKind::MissingBone { .. } => {
                "Every frame has the same bones: add the line, or get the file again if it is cut off."
            }
            ErrorKind::NewBone { .. } => {
                "Every frame has the same bones: add a line to the first frame, or delete this one."
            }
            ErrorKind::LargeCount { .. } => "Number the frames one by one, from 1.",
            ErrorKind::NotANumber { .. } => "Write a number such as -12.5 or 1e-6.",
            ErrorKind::Separator { .. } => {
                "Write a point in numbers (1.5, not 1,5), and put blanks between numbers, not commas or semicolons."
            }
            ErrorKind::NotFinite { .. } => {
                "Such a number has no place in a skeleton. Put the right number there."
            }
            ErrorKind::LongNumber { .. } => "Look for a blank that is missing.",
            ErrorKind::Skeleton(_) => "Call it otherwise, here and wherever it is meant.",
            ErrorKind::Motion(_) => "Look at the lines just above.",
        }
    }
}
