//! Which frame is shown: stepped through, or played at the motion's own speed, forwards or backwards, within a range.

/// The speeds that can be chosen, as multiples of the motion's own.
pub const SPEEDS: [f64; 9] = [0.1, 0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 4.0];

/// Where the motion's own speed stands among them.
const OWN_SPEED: usize = 4;

/// Goes through the frames of a motion. It may go on with a longer one: then the last frame stays until that is at its end.
#[derive(Clone, Debug, PartialEq)]
pub struct Player {
    /// The frame of the longer motion.
    frame: usize,
    /// How many frames the motion has.
    count: usize,
    /// How many frames the longer motion has; the same when there is none.
    length: usize,
    /// Seconds from one frame to the next.
    frame_time: f64,
    playing: bool,
    backwards: bool,
    looping: bool,
    /// An index of [`SPEEDS`].
    speed: usize,
    /// The first and the last frame that are played.
    range: (usize, usize),
    /// Seconds for which the frame has been shown already, at the motion's own speed.
    shown_for: f64,
    /// The frame at which traces begin: the last wrap or reversal, or else as early as can be.
    traced_from: usize,
}

impl Player {
    /// Stands at frame 0 of `count` (at least 1), which follow each other after `frame_time` seconds (positive).
    pub fn new(count: usize, frame_time: f64) -> Player {
        let count = count.max(1);
        Player {
            frame: 0,
            count,
            length: count,
            frame_time,
            playing: false,
            backwards: false,
            looping: true,
            speed: OWN_SPEED,
            range: (0, count - 1),
            shown_for: 0.0,
            traced_from: 0,
        }
    }

    /// The same settings for a motion that has changed: as near to the same frame as there is one.
    pub fn for_motion(&self, count: usize, frame_time: f64) -> Player {
        Player { frame_time, ..self.waiting(count, count) }
    }

    /// The same for a motion of `count` frames that goes on with one of `length` frames: at the same time, if there is such a
    /// time in the longer one.
    #[must_use]
    pub fn waiting(&self, count: usize, length: usize) -> Player {
        let count = count.max(1);
        let length = length.max(count);
        let last = length - 1;
        let range =
            if self.has_range() { (self.range.0.min(last), self.range.1.min(last)) } else { (0, last) };
        let (frame, traced_from) = (self.frame.min(last), self.traced_from.min(last));
        let playing = self.playing && length > 1;
        Player { count, length, frame, range, traced_from, playing, ..self.clone() }
    }

    /// The frame to show, from 0.
    pub fn frame(&self) -> usize {
        self.frame.min(self.count - 1)
    }

    /// How many frames have passed since the beginning: those for which the last one has stayed are counted too.
    pub fn time(&self) -> usize {
        self.frame
    }

    /// Whether the last frame stays until a longer motion is at its end.
    pub fn is_waiting(&self) -> bool {
        self.frame >= self.count
    }

    /// How many frames there are, at least 1.
    pub fn count(&self) -> usize {
        self.count
    }

    /// How many frames the longer motion has with which this one goes on; its own, when there is none.
    pub fn length(&self) -> usize {
        self.length
    }

    /// Whether it is playing.
    pub fn is_playing(&self) -> bool {
        self.playing
    }

    /// Whether it plays from the end to the beginning.
    pub fn is_backwards(&self) -> bool {
        self.backwards
    }

    /// Whether it begins again at the end.
    pub fn is_looping(&self) -> bool {
        self.looping
    }

    /// How fast it plays, as a multiple of the motion's own speed.
    pub fn speed(&self) -> f64 {
        SPEEDS[self.speed]
    }

    /// The first and the last frame that are played.
    pub fn range(&self) -> (usize, usize) {
        (self.range.0.min(self.count - 1), self.range.1.min(self.count - 1))
    }

    /// Whether only a part of the motion is played.
    pub fn has_range(&self) -> bool {
        self.range != (0, self.length - 1)
    }

    /// The frames whose traces are shown, at most `most` of them and the oldest first: from the last wrap or reversal,
    /// or from before the present frame when somebody has gone to it, up to the present one.
    pub fn traced(&self, most: usize) -> impl Iterator<Item = usize> + use<> {
        let (from, to) = (self.traced_from.min(self.count - 1), self.frame());
        let length = from.abs_diff(to).min(most.saturating_sub(1));
        let forwards = from <= to;
        (0..=length).rev().map(move |back| if forwards { to - back } else { to + back })
    }

    /// Plays, or pauses.
    pub fn toggle(&mut self) {
        self.set_playing(!self.playing);
    }

    /// Plays, or does not. A single frame cannot be played.
    pub fn set_playing(&mut self, playing: bool) {
        self.playing = playing && self.length > 1;
        self.shown_for = 0.0;
        let (first, last) = self.range;
        // Who is at the end, or outside of what is to be played, wants to see it from its beginning.
        let at_end = !self.looping && self.frame == if self.backwards { first } else { last };
        if self.playing && (at_end || !(first..=last).contains(&self.frame)) {
            self.frame = if self.backwards { last } else { first };
            self.traced_from = self.frame;
        }
    }

    /// Plays in the other direction from now on.
    pub fn reverse(&mut self) {
        self.backwards = !self.backwards;
        self.traced_from = self.frame;
        self.shown_for = 0.0;
    }

    /// Begins again at the end, or stops there.
    pub fn toggle_loop(&mut self) {
        self.looping = !self.looping;
    }

    /// The next higher speed, or the next lower one.
    pub fn change_speed(&mut self, faster: bool) {
        self.speed =
            if faster { (self.speed + 1).min(SPEEDS.len() - 1) } else { self.speed.saturating_sub(1) };
    }

    /// Plays from this frame on; from the motion's beginning if that was so already.
    pub fn begin_range(&mut self) {
        let first = if self.range.0 == self.frame { 0 } else { self.frame };
        let last = if self.range.1 < first { self.length - 1 } else { self.range.1 };
        self.range = (first, last);
    }

    /// Plays up to this frame; to the motion's end if that was so already.
    pub fn end_range(&mut self) {
        let last = if self.range.1 == self.frame { self.length - 1 } else { self.frame };
        let first = if self.range.0 > last { 0 } else { self.range.0 };
        self.range = (first, last);
    }

    /// Pauses and goes to `frame`, or to the last one that there is, of the longer motion.
    pub fn go_to(&mut self, frame: usize) {
        self.frame = frame.min(self.length - 1);
        self.playing = false;
        self.shown_for = 0.0;
        self.traced_from = if self.backwards { self.length - 1 } else { 0 };
    }

    /// Pauses and goes `frames` further, or back when it is negative. The first frame follows the last.
    pub fn step(&mut self, frames: isize) {
        let length = self.length as i128;
        self.go_to((self.frame as i128 + frames as i128).rem_euclid(length) as usize);
    }

    /// Lets `seconds` pass. Frames that do not fit between two pictures are left out, so that the motion keeps its
    /// speed on every display.
    pub fn advance(&mut self, seconds: f64) {
        if !self.playing {
            return;
        }
        // No clock lets a year pass between two pictures; beyond that there would be no fractions left.
        self.shown_for += seconds.clamp(0.0, 3e7) * self.speed();
        let steps = (self.shown_for / self.frame_time).floor();
        self.shown_for -= steps * self.frame_time;

        let (first, last) = self.range;
        let length = last - first + 1;
        let left =
            if self.backwards { self.frame.saturating_sub(first) } else { last.saturating_sub(self.frame) };
        if steps <= left as f64 {
            let steps = steps as usize;
            self.frame = if self.backwards { self.frame - steps } else { self.frame + steps };
        } else if self.looping {
            let over = ((steps - left as f64 - 1.0).max(0.0) % length as f64) as usize;
            (self.traced_from, self.frame) = match self.backwards {
                true => (last, last - over.min(length - 1)),
                false => (first, first + over.min(length - 1)),
            };
        } else {
            self.frame = if self.backwards { first } else { last };
            self.playing = false;
        }
    }
}

#[cfg(test)]
mod tests;
