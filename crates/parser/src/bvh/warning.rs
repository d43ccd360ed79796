//! What is read although it is not as it should be.

use crate::shown::{Shortest, counted};

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
    /// A joint says nothing about its channels.
    #[error("`{joint}` has no CHANNELS; it was read as a joint that never moves")]
    NoChannels {
        /// The joint's name.
        joint: String,
    },
    /// There is more than one root.
    #[error("this is a second ROOT; every root moves on its own")]
    SeveralRoots,
    /// Several joints have the same name.
    #[error(
        "the name `{name}` was used in line {first_line} already; the joints are told apart by their order"
    )]
    RepeatedName {
        /// The name.
        name: String,
        /// Where it stands first.
        first_line: u64,
    },
    /// The frame time is none that can be played: see [`skeleton::Motion::playable_frame_time`].
    #[error(
        "a Frame Time of {} s cannot be played; 30 frames per second are played instead",
        Shortest(*seconds)
    )]
    FrameTime {
        /// As it was read.
        seconds: f64,
    },
    /// There are frames, but nothing that could move in them.
    #[error(
        "no joint has channels, so that the {} declared can hold no numbers; the motion was read without frames",
        counted(*declared, "frame")
    )]
    EmptyFrames {
        /// Frames that the text declares.
        declared: u64,
    },
    /// As many lines as frames, and in sum the right number of values, but not on every line.
    #[error(
        "this line holds {}, a frame {channels}; the numbers were read on across the line ends, because in sum they \
         are right",
        counted(*width, "number")
    )]
    UnevenRows {
        /// Numbers on the line.
        width: u64,
        /// Numbers of a frame.
        channels: u64,
    },
    /// There are more numbers than the frames need.
    #[error(
        "found {} more than the {} that `Frames:` says; what is too much was left out",
        counted(*surplus, "number"),
        counted(*declared, "frame")
    )]
    MoreRows {
        /// Frames that the text declares.
        declared: u64,
        /// Numbers beyond.
        surplus: u64,
    },
    /// After the last frame there is something that is no number.
    #[error("`{found}` stands behind the last frame; it was left out, and all behind it")]
    Junk {
        /// The first word of it.
        found: String,
    },
}
