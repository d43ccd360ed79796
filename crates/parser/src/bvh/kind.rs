//! What can be wrong, and what to do about it.

use skeleton::{Channel, MotionError, SkeletonError};

use crate::error::{Kind, Problem};
use crate::shown::counted;

/// What is wrong: what was found and what was expected.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ErrorKind {
    /// What can be wrong with a text of any format.
    #[error(transparent)]
    Common(#[from] Problem),
    /// There is no text at all.
    #[error("the file is empty; a BVH file begins with HIERARCHY")]
    Empty,
    /// Something else altogether.
    #[error("this is not a BVH file: it begins with `{found}`{guess}; a BVH file begins with HIERARCHY")]
    NotBvh {
        /// The first word.
        found: String,
        /// What it may be, as ` (…)`, or nothing.
        guess: &'static str,
    },
    /// The first line is missing.
    #[error("found `{found}`, expected HIERARCHY: the first line `HIERARCHY` is missing")]
    NoHierarchy {
        /// The first word.
        found: String,
    },
    /// A joint has no name.
    #[error("found no name behind {keyword}, expected one on the same line")]
    NoName {
        /// `ROOT` or `JOINT`.
        keyword: &'static str,
    },
    /// A name is longer than any name should be.
    #[error("found a name longer than {longest} bytes, expected a shorter one")]
    LongName {
        /// The longest that is read.
        longest: usize,
    },
    /// No channel is called like this.
    #[error("found `{found}`, expected a channel")]
    UnknownChannel {
        /// The word.
        found: String,
    },
    /// A joint lists one channel twice.
    #[error("found {channel} a second time in the same joint, expected another channel")]
    RepeatedChannel {
        /// The channel.
        channel: Channel,
    },
    /// A joint lists more or fewer channels than it says.
    #[error("found {}, expected {declared}, as CHANNELS says", counted(*listed, "channel word"))]
    ChannelCount {
        /// The number behind `CHANNELS`.
        declared: u64,
        /// How many channels follow.
        listed: u64,
    },
    /// A joint is still open where none may be.
    #[error("found {found}, expected `}}`: the joint `{joint}`, opened in line {line}, is not closed")]
    NotClosed {
        /// The word in quotes, or the end of the file.
        found: String,
        /// The innermost open joint's name.
        joint: String,
        /// Where it begins.
        line: u64,
    },
    /// There is one closing brace too many.
    #[error("found `}}`, expected ROOT or MOTION: every joint has been closed before")]
    NothingToClose,
    /// The skeleton does not take a joint.
    #[error("{0}")]
    Skeleton(#[source] SkeletonError),
    /// The numbers do not make whole frames.
    #[error("{0}")]
    Motion(#[source] MotionError),
    /// The rows hold other numbers of values than there are channels.
    #[error(
        "found {} in this line, expected {channels}, one for each channel",
        counted(*width, "number")
    )]
    RowWidth {
        /// Numbers on the line.
        width: u64,
        /// Channels of all joints.
        channels: u64,
    },
    /// The text ends before all frames are there.
    #[error(
        "found {}, expected {}, for {} × {}. {}",
        counted(*found, "number"),
        u128::from(*frames) * u128::from(*channels),
        counted(*frames, "frame"),
        counted(*channels, "channel"),
        about_rows(*odd_line, *found, *channels)
    )]
    TooFewNumbers {
        /// Frames that the text declares.
        frames: u64,
        /// Channels of all joints.
        channels: u64,
        /// Numbers that are there.
        found: u64,
        /// The first line with another count of numbers than there are channels, and its count.
        odd_line: Option<(u64, u64)>,
    },
}

impl Kind for ErrorKind {
    const FORMAT: &'static str = "BVH";

    fn help(&self) -> &'static str {
        match self {
            ErrorKind::Common(problem) => problem.help(),
            ErrorKind::Empty | ErrorKind::NotBvh { .. } => "Check that this is the file you mean.",
            ErrorKind::NoHierarchy { .. } => {
                "Write HIERARCHY above the joints; or get the file again if its beginning is cut off."
            }
            ErrorKind::NoName { .. } => "Write a name behind the word.",
            ErrorKind::LongName { .. } => "Shorten the name; or look for a line break that is missing.",
            ErrorKind::UnknownChannel { .. } => {
                "Write one of Xposition, Yposition, Zposition, Xrotation, Yrotation and Zrotation."
            }
            ErrorKind::RepeatedChannel { .. } => {
                "A joint can have each of the six channels once: correct the word."
            }
            ErrorKind::ChannelCount { .. } => "Make the number and the words behind it agree.",
            ErrorKind::NotClosed { .. } => "Every `{` needs its `}`: write it where the joint ends.",
            ErrorKind::NothingToClose => "Delete it, or look for a `{` that is missing above.",
            ErrorKind::Skeleton(_) | ErrorKind::Motion(_) => "Look at the lines just above.",
            ErrorKind::RowWidth { .. } => {
                "Every frame has one number for each channel. Do the CHANNELS above belong to these frames?"
            }
            ErrorKind::TooFewNumbers { .. } => {
                "Correct the number behind `Frames:`, or get the file again if it is cut off."
            }
        }
    }
}

fn about_rows(odd_line: Option<(u64, u64)>, found: u64, channels: u64) -> String {
    match odd_line {
        Some((line, width)) => {
            format!("Line {line} is the first that holds {} instead of {channels}", counted(width, "number"))
        }
        None if found == 0 => String::from("There are no frames at all"),
        None => format!("Every line holds {}, as it should", counted(channels, "number")),
    }
}
