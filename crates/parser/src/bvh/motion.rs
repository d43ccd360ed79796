//! The lower part of the text: the frames.

use skeleton::{Motion, Skeleton};

use super::rows::Rows;
use super::{Error, ErrorKind, Warning, WarningKind};
use crate::error::is_conflict_mark;
use crate::number::{self, BadNumber};
use crate::snippet::printable_start;
use crate::source::{Lines, Place, Source, WholeWords, is_blank};
use crate::warning::warn;
use crate::words;

/// The fewest numbers that room is made for at once.
const LEAST_ROOM: usize = 16 * 1024;

/// Reads everything behind `MOTION`.
pub(super) fn read(
    source: &mut Source,
    skeleton: Skeleton,
    warnings: &mut Vec<Warning>,
) -> Result<Motion, Error> {
    let declared = frame_count(source)?;
    let (frame_time, place_of_time) = frame_time(source)?;
    let mut numbers = Numbers::new(declared, skeleton.channel_count() as u64);
    numbers.read(source, warnings)?;
    numbers.check(source, warnings)?;
    let Numbers { values, .. } = numbers;
    // The numbers are there, so their count, and with it that of the frames, is one that memory can hold.
    let frames = values.len().checked_div(skeleton.channel_count()).unwrap_or(0);
    if frames as u64 != declared {
        warn(warnings, source.place(), WarningKind::EmptyFrames { declared });
    }
    let motion = Motion::new(skeleton, frames, frame_time, values)
        .map_err(|error| Error::here(source, ErrorKind::Motion(error)))?;
    if motion.playable_frame_time() != frame_time {
        warn(warnings, place_of_time, WarningKind::FrameTime { seconds: frame_time });
    }
    Ok(motion)
}

/// Reads `Frames: 120`.
fn frame_count(source: &mut Source) -> Result<u64, Error> {
    for word in ["Frames", ":"] {
        words::take(source, word, "`Frames:` and the number of frames")?;
    }
    words::count(source, "the number of frames, a whole number").map(|(count, _)| count)
}

/// Reads `Frame Time: 0.0333`. Gives where the number stands, too.
fn frame_time(source: &mut Source) -> Result<(f64, Place), Error> {
    for word in ["Frame", "Time", ":"] {
        words::take(source, word, "`Frame Time:` and the seconds from one frame to the next")?;
    }
    source.peek();
    let place = source.place();
    Ok((words::number(source)?, place))
}

/// The numbers of all frames.
struct Numbers {
    declared: u64,
    channels: u64,
    /// How many numbers the frames need. More than memory can hold is as good as endless.
    wanted: usize,
    values: Vec<f32>,
    /// How many values may come until it is time to make room, or to stop.
    limit: usize,
    /// Numbers beyond those wanted, and the place of the first.
    surplus: u64,
    first_surplus: Option<Place>,
    rows: Rows,
}

impl Numbers {
    fn new(declared: u64, channels: u64) -> Self {
        let wanted = usize::try_from(declared.saturating_mul(channels)).unwrap_or(usize::MAX);
        let rows = Rows::new(channels);
        let (values, limit, surplus, first_surplus) = (Vec::new(), 0, 0, None);
        Numbers { declared, channels, wanted, values, limit, surplus, first_surplus, rows }
    }

    /// Reads numbers up to the end of the text, or up to the first word behind the last frame that is none.
    fn read(&mut self, source: &mut Source, warnings: &mut Vec<Warning>) -> Result<(), Error> {
        loop {
            let words = source.whole_words();
            let (text, at) = (words.text, *words.at);
            if at == text.len() {
                break;
            }
            let Err((problem, word)) = self.take_all(words) else { continue };
            let is_conflict = is_conflict_mark(&word);
            if self.values.len() < self.wanted || is_conflict {
                return Err(Error::bad_number(source, &word, problem));
            }
            warn(warnings, source.place(), WarningKind::Junk { found: printable_start(&word) });
            break;
        }
        self.rows.end_line(source.place().line, self.count());
        Ok(())
    }

    /// Takes numbers as long as there are numbers. Otherwise gives the word that is none, and what it is.
    fn take_all(&mut self, words: WholeWords) -> Result<(), (BadNumber, Vec<u8>)> {
        let WholeWords { text, at, lines } = words;
        let mut rest = &text[*at..];
        let result = loop {
            match rest {
                [] => break Ok(()),
                [b' ', behind @ ..] => rest = behind,
                [b'\n' | b'\r', ..] => {
                    self.rows.end_line(lines.line, self.count());
                    let end = lines.take_break(text, text.len() - rest.len());
                    rest = &text[end..];
                }
                [byte, behind @ ..] if is_blank(*byte) => rest = behind,
                _ => match number::leading(rest) {
                    Ok((number, behind)) => {
                        if self.values.len() < self.limit || self.make_room() {
                            self.values.push(number);
                        } else {
                            self.count_surplus(text, text.len() - rest.len(), lines);
                        }
                        rest = behind;
                    }
                    Err(problem) => break Err((problem, rest[..number::word_length(rest)].to_vec())),
                },
            }
        };
        *at = text.len() - rest.len();
        result
    }

    /// Makes room for some more values. Gives false if no more are wanted.
    #[cold]
    fn make_room(&mut self) -> bool {
        let step = LEAST_ROOM.max(self.values.len()).min(self.wanted - self.values.len());
        self.values.reserve_exact(step);
        self.limit = self.values.len() + step;
        step > 0
    }

    #[cold]
    fn count_surplus(&mut self, text: &[u8], at: usize, lines: &Lines) {
        self.first_surplus.get_or_insert_with(|| lines.place(text, at));
        self.surplus += 1;
    }

    /// How many numbers there have been.
    fn count(&self) -> u64 {
        self.values.len() as u64 + self.surplus
    }

    /// Whether the numbers are as many as they should be, and in lines that make sense.
    fn check(&self, source: &mut Source, warnings: &mut Vec<Warning>) -> Result<(), Error> {
        let (frames, channels) = (self.declared, self.channels);
        if self.values.len() < self.wanted {
            let odd_line = self.rows.odd_line();
            let kind = ErrorKind::TooFewNumbers { frames, channels, found: self.count(), odd_line };
            return Err(match odd_line {
                Some((line, _)) => Error::before(Place { line, column: 1 }, None, source, kind),
                None => Error::here(source, kind),
            });
        }
        if let Some(place) = self.first_surplus {
            if let Some((line, width)) = self.rows.unfit_line(frames) {
                return Err(Error::before(
                    Place { line, column: 1 },
                    None,
                    source,
                    ErrorKind::RowWidth { width, channels },
                ));
            }
            warn(warnings, place, WarningKind::MoreRows { declared: frames, surplus: self.surplus });
        } else if let Some((line, width)) = self.rows.uneven_line(frames) {
            warn(warnings, Place { line, column: 1 }, WarningKind::UnevenRows { width, channels });
        }
        Ok(())
    }
}
