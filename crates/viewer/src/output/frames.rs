//! Frames as they are written on a command line: `120`, `100..200`, `100..200/4`.

use std::fmt;
use std::iter::StepBy;
use std::ops::Range;
use std::str::FromStr;

/// Some of a motion's frames. Numbers are those that the window shows: counted from 0, and both ends belong to it.
///
/// | written | frames |
/// |---|---|
/// | `120` | frame 120 alone |
/// | `100..200` | 100 to 200, both included |
/// | `100..` | from 100 to the last |
/// | `..50` | 0 to 50 |
/// | `..` | all |
/// | `100..200/4` | every 4th of them: 100, 104, … 200 |
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FrameRange {
    first: usize,
    /// `None`: the motion's last.
    last: Option<usize>,
    /// At least 1.
    step: usize,
}

/// The numbers of frames, one after the other.
pub type FrameNumbers = StepBy<Range<usize>>;

impl FrameRange {
    /// All frames.
    pub const ALL: FrameRange = FrameRange { first: 0, last: None, step: 1 };

    /// How far it is from one of the frames to the next: 1 unless it was written with a `/`.
    pub fn step(self) -> usize {
        self.step
    }

    /// The numbers of these frames in a motion of `count` frames. A motion without frames shows its rest pose as frame
    /// 0.
    ///
    /// # Errors
    ///
    /// When the first or the last of them does not exist.
    pub fn resolve(self, count: usize) -> Result<FrameNumbers, NoFrame> {
        check(self.first, count)?;
        let last = self.last.unwrap_or(count.max(1) - 1);
        check(last, count)?;
        Ok((self.first..last + 1).step_by(self.step))
    }
}

/// Sees to it that a motion of `count` frames has `frame`.
///
/// # Errors
///
/// When it has not.
pub fn check(frame: usize, count: usize) -> Result<(), NoFrame> {
    if frame < count.max(1) { Ok(()) } else { Err(NoFrame { frame, count }) }
}

/// A frame that does not exist.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub struct NoFrame {
    /// The number that was asked for.
    pub frame: usize,
    /// How many frames there are.
    pub count: usize,
}

impl fmt::Display for NoFrame {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "there is no frame {}: ", self.frame)?;
        match self.count {
            0 => write!(f, "the motion has no frames; its rest pose is frame 0"),
            1 => write!(f, "the motion has one frame, frame 0"),
            count => write!(f, "the motion's frames are counted from 0 to {}", count - 1),
        }
    }
}

/// What is wrong with a text that should say some frames.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum FrameRangeError {
    /// Neither a number nor two with dots between them.
    #[error(
        "write one frame as 120, several as 100..200, 100.. or ..50, and every 4th of them as 100..200/4"
    )]
    Shape,
    /// A part that should be a number.
    #[error("{0:?} is not the number of a frame: frames are counted 0, 1, 2 …, as the window shows them")]
    Number(String),
    /// A last frame before the first.
    #[error("{first}..{last} ends before it begins: write {last}..{first}")]
    Backwards {
        /// The frame before the dots.
        first: usize,
        /// The frame behind the dots.
        last: usize,
    },
    /// Something behind the `/` that nobody can step by.
    #[error("{0:?} is not a step: /4 takes every 4th frame, /1 takes all")]
    Step(String),
}

impl FromStr for FrameRange {
    type Err = FrameRangeError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let text = text.trim();
        let (frames, step) = match text.split_once('/') {
            None => (text, 1),
            // Every 4th of one frame: probably something else was meant.
            Some((frames, _)) if !frames.contains("..") => return Err(FrameRangeError::Shape),
            Some((frames, step)) => (frames, read_step(step.trim())?),
        };
        let Some((first, last)) = frames.split_once("..") else {
            return match read_number(frames) {
                // A word or a range in another notation is better answered with the notation itself.
                Err(_) => Err(FrameRangeError::Shape),
                Ok(frame) => Ok(FrameRange { first: frame, last: Some(frame), step }),
            };
        };
        let given = |text: &str| (!text.trim().is_empty()).then(|| read_number(text)).transpose();
        let (first, last) = (given(first)?.unwrap_or(0), given(last)?);
        match last {
            Some(last) if last < first => Err(FrameRangeError::Backwards { first, last }),
            _ => Ok(FrameRange { first, last, step }),
        }
    }
}

fn read_number(text: &str) -> Result<usize, FrameRangeError> {
    text.trim().parse().map_err(|_| FrameRangeError::Number(text.trim().to_owned()))
}

fn read_step(text: &str) -> Result<usize, FrameRangeError> {
    text.parse().ok().filter(|step| *step > 0).ok_or_else(|| FrameRangeError::Step(text.to_owned()))
}

impl fmt::Display for FrameRange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let FrameRange { first, last, step } = self;
        match last {
            Some(last) if last == first && *step == 1 => return write!(f, "{first}"),
            Some(last) => write!(f, "{first}..{last}")?,
            None => write!(f, "{first}..")?,
        }
        if *step == 1 { Ok(()) } else { write!(f, "/{step}") }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn numbers(text: &str, count: usize) -> Vec<usize> {
        text.parse::<FrameRange>().unwrap().resolve(count).unwrap().collect()
    }

    #[test]
    fn both_ends_belong_to_a_range() {
        assert_eq!(numbers("3", 10), [3]);
        assert_eq!(numbers("3..5", 10), [3, 4, 5]);
        assert_eq!(numbers("3..3", 10), [3]);
        assert_eq!(numbers(" 7 .. ", 10), [7, 8, 9]);
        assert_eq!(numbers("..2", 10), [0, 1, 2]);
        assert_eq!(numbers("..", 3), [0, 1, 2]);
        assert_eq!(numbers("1..9/4", 10), [1, 5, 9]);
        assert_eq!(numbers("../ 4", 10), [0, 4, 8]);
        assert_eq!(numbers("..", 0), [0], "the rest pose");
    }

    #[test]
    fn a_text_that_says_no_frames_is_answered_with_how_to_write_them() {
        let words = |text: &str| text.parse::<FrameRange>().unwrap_err().to_string();
        for shape in ["", "all", "100-200", "100:200", "-5", "7/2", "1,5", "99999999999999999999999"] {
            assert!(words(shape).contains("100..200/4"), "{shape}: {}", words(shape));
        }
        assert!(words("1..x").starts_with("\"x\" is not the number of a frame"), "{}", words("1..x"));
        assert!(words("1..=5").contains("\"=5\""));
        assert!(words("-1..5").contains("\"-1\""));
        assert_eq!(words("200..100"), "200..100 ends before it begins: write 100..200");
        for step in ["1..2/0", "1..2/-1", "1..2/", "1..2/x", "1..2/3/4"] {
            assert!(words(step).contains("every 4th"), "{step}: {}", words(step));
        }
    }

    #[test]
    fn a_frame_that_does_not_exist_is_told_with_those_that_do() {
        let words = |text: &str, count| {
            text.parse::<FrameRange>().unwrap().resolve(count).map(|_| ()).unwrap_err().to_string()
        };
        assert_eq!(words("5..7", 7), "there is no frame 7: the motion's frames are counted from 0 to 6");
        assert_eq!(words("8..", 7), "there is no frame 8: the motion's frames are counted from 0 to 6");
        assert_eq!(words("..1", 1), "there is no frame 1: the motion has one frame, frame 0");
        assert_eq!(words("1", 0), "there is no frame 1: the motion has no frames; its rest pose is frame 0");
        let largest = usize::MAX.to_string();
        assert!(words(&largest, 7).contains(&largest));
    }

    proptest! {
        #[test]
        fn a_range_gives_the_frames_that_it_says(
            first in 0usize..60,
            last in proptest::option::of(0usize..60),
            step in 1usize..9,
            count in 0usize..50,
        ) {
            let range = FrameRange { first, last, step };
            let written = range.to_string().parse::<FrameRange>();
            if last.is_some_and(|last| last < first) {
                prop_assert!(written.is_err());
                return Ok(());
            }
            prop_assert_eq!(written, Ok(range));
            let exist = count.max(1);
            let end = last.unwrap_or(exist - 1);
            match range.resolve(count) {
                Err(missing) => {
                    prop_assert!(first >= exist || end >= exist);
                    prop_assert!(missing.frame >= exist);
                }
                Ok(numbers) => {
                    prop_assert!(first < exist && end < exist);
                    let wanted: Vec<usize> =
                        (0..exist).filter(|i| (first..=end).contains(i) && (i - first) % step == 0).collect();
                    prop_assert_eq!(numbers.collect::<Vec<_>>(), wanted);
                }
            }
        }

        #[test]
        fn no_text_makes_it_panic(text in "[0-9./ x-]{0,24}|.{0,12}", count in any::<usize>()) {
            if let Ok(range) = text.parse::<FrameRange>() {
                let _ = range.resolve(count).map(|mut numbers| numbers.next());
            }
        }
    }
}
