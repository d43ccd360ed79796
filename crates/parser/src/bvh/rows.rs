//! Do the lines of a motion fit its frames?

/// Counts the numbers of each line. Lines do not matter to a motion, so that they are looked at only if the count
/// of numbers is not right.
#[derive(Debug)]
pub(super) struct Rows {
    /// Numbers of a frame.
    channels: u64,
    /// Numbers up to the end of the line before.
    counted: u64,
    /// Lines that hold numbers.
    lines: u64,
    /// The first line that holds another count of numbers than there are channels, and its count.
    odd: Option<(u64, u64)>,
    /// The first line in the middle of which a frame would begin, and its count of numbers.
    broken: Option<(u64, u64)>,
}

impl Rows {
    pub fn new(channels: u64) -> Self {
        Rows { channels, counted: 0, lines: 0, odd: None, broken: None }
    }

    /// Line `line` ends when there have been `numbers` numbers in all.
    pub fn end_line(&mut self, line: u64, numbers: u64) {
        let width = numbers - self.counted;
        if width == self.channels && self.odd.is_none() {
            self.lines += 1;
            self.counted = numbers;
        } else if width > 0 {
            self.end_odd_line(line, width);
        }
    }

    #[cold]
    fn end_odd_line(&mut self, line: u64, width: u64) {
        if width != self.channels {
            self.odd.get_or_insert((line, width));
        }
        let into_frame = self.counted.checked_rem(self.channels).unwrap_or(0);
        let whole_frames = into_frame == 0 && width.checked_rem(self.channels) == Some(0);
        if !whole_frames && into_frame + width > self.channels {
            self.broken.get_or_insert((line, width));
        }
        self.lines += 1;
        self.counted += width;
    }

    /// The first line that holds another count of numbers than there are channels, and its count.
    pub fn odd_line(&self) -> Option<(u64, u64)> {
        self.odd
    }

    /// The line that shows, when there are more numbers than `frames` need, that the rows are not this skeleton's,
    /// and its count: a frame would begin in the middle of it, or the lines are as many as the frames, so that each
    /// should be one. A single line may hold all frames, and says nothing as long as they are whole.
    pub fn unfit_line(&self, frames: u64) -> Option<(u64, u64)> {
        self.broken.or(self.uneven_line(frames).filter(|_| self.lines > 1))
    }

    /// The first line of another width, if the lines are as many as the frames, so that each should be one.
    pub fn uneven_line(&self, frames: u64) -> Option<(u64, u64)> {
        self.odd.filter(|_| self.lines == frames)
    }
}
