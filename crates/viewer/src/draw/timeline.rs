//! The bar at the bottom of the picture that shows the frame among all frames, and where to press to go to one.

use super::canvas::{Canvas, Color, Typeface, Weight};
use super::colors::{BACKDROP, BACKDROP_OPACITY, QUIET, RIGHT, WARNING, color_of};
use super::usable_scale;
use crate::scene::{Timeline, Tint};

/// Lengths in pixels, for an ordinary display.
const HEIGHT: f32 = 38.0;
const ASIDE: f32 = 26.0;
const TRACK: f32 = 5.0;
const TRACK_DOWN: f32 = 13.0;
const TEXT_SIZE: f32 = 11.0;
const TICKS_APART: f32 = 64.0;
const KEYFRAME: (f32, f32) = (2.0, 8.0);

/// The least picture that has a bar.
const LEAST: (f32, f32) = (160.0, 140.0);

const GROOVE: Color = Color(0x4A_55_63);
const IN_RANGE: Color = Color(0x8C_98_A6);

/// Where the bar is in a picture. Places are in pixels from the left and from the top.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bar {
    /// The top of the bar, which reaches down to the bottom of the picture.
    pub top: f32,
    /// Where the first frame is.
    pub first: f32,
    /// Where the last frame is.
    pub last: f32,
    size: (usize, usize),
    count: usize,
    scale: f32,
}

impl Bar {
    /// The bar for `timeline` in a picture of `size` pixels with texts this large
    /// ([`Scene::text_scale`](crate::scene::Scene::text_scale)). `None` when there are fewer than two frames, or the
    /// picture is too small.
    pub fn new(timeline: &Timeline, size: (usize, usize), text_scale: f32) -> Option<Bar> {
        let scale = usable_scale(text_scale);
        let (width, height) = (size.0 as f32, size.1 as f32);
        let fits = timeline.count >= 2 && width >= LEAST.0 * scale && height >= LEAST.1 * scale;
        fits.then_some(Bar {
            top: (height - HEIGHT * scale).floor(),
            first: (ASIDE * scale).round(),
            last: (width - ASIDE * scale).round(),
            size,
            count: timeline.count,
            scale,
        })
    }

    /// Whether a place in the picture is on the bar.
    pub fn contains(&self, x: f32, y: f32) -> bool {
        (0.0..self.size.0 as f32).contains(&x) && (self.top..self.size.1 as f32).contains(&y)
    }

    /// The frame that is nearest to a place on the bar, from 0: outside of it the first or the last one.
    pub fn frame_at(&self, x: f32) -> usize {
        let share = f64::from(x - self.first) / f64::from(self.last - self.first);
        // A cast makes zero of NaN.
        ((share.clamp(0.0, 1.0) * (self.count - 1) as f64).round() as usize).min(self.count - 1)
    }

    /// Where a frame is, from the left.
    pub fn place_of(&self, frame: usize) -> f32 {
        let share = frame.min(self.count - 1) as f64 / (self.count - 1) as f64;
        self.first + (share * f64::from(self.last - self.first)) as f32
    }

    /// Draws the bar on top of everything, with a mark at each of `keyframes`, which are in ascending order.
    pub(crate) fn draw(
        &self,
        timeline: &Timeline,
        keyframes: &[usize],
        typeface: &mut Typeface,
        canvas: &mut Canvas,
    ) {
        let pixels = |length: f32| (length * self.scale).round() as i32;
        let (width, height) = (self.size.0 as i32, self.size.1 as i32);
        canvas.rectangle((0, self.top as i32), (width, height), BACKDROP, BACKDROP_OPACITY);

        let thick = pixels(TRACK).max(2);
        let middle = self.top as i32 + pixels(TRACK_DOWN);
        let mut track = |from: f32, to: f32, color| {
            let (from, to) = (from.round() as i32, to.round() as i32);
            canvas.rectangle((from, middle - thick / 2), (to - from, thick), color, 1.0);
        };
        let end = self.count - 1;
        let (start, stop) = (timeline.range.0.min(end), timeline.range.1.min(end));
        let place = |frame| self.place_of(frame);
        track(self.first, self.last, GROOVE);
        track(place(start), place(stop), IN_RANGE);
        track(place(start), place(timeline.frame.min(stop)), RIGHT);
        self.ticks(middle + pixels(TRACK), typeface, canvas);
        self.keyframes(keyframes, middle - thick / 2, canvas);
        if (start, stop) != (0, end) {
            for (frame, inwards) in [(start, 1), (stop, -1)] {
                self.bracket((place(frame).round() as i32, middle), inwards, canvas);
            }
        }
        // A full knob while it is playing, a ring while it rests.
        let knob = (place(timeline.frame), middle as f32);
        canvas.disc(knob, 8.0 * self.scale, Color::WHITE);
        let inner = if timeline.playing { RIGHT } else { BACKDROP };
        canvas.disc(knob, 4.5 * self.scale, inner);
    }

    /// A bracket around the range that is played: a post with two feet that point inwards.
    fn bracket(&self, (x, middle): (i32, i32), inwards: i32, canvas: &mut Canvas) {
        let pixels = |length: f32| ((length * self.scale).round() as i32).max(1);
        let (half, foot, thick) = (pixels(9.0), pixels(5.0), pixels(2.0));
        let left = |length: i32| if inwards > 0 { x } else { x - length };
        canvas.rectangle((left(thick), middle - half), (thick, 2 * half), WARNING, 1.0);
        for top in [middle - half, middle + half - thick] {
            canvas.rectangle((left(foot), top), (foot, thick), WARNING, 1.0);
        }
    }

    /// Posts at keyframes that stand on the track, whose top is given. Where they are many, they are thin.
    fn keyframes(&self, keyframes: &[usize], bottom: i32, canvas: &mut Canvas) {
        let pixels = |length: f32| ((length * self.scale).round() as i32).max(1);
        let room = (self.last - self.first) / keyframes.len().max(1) as f32;
        let width = if room < 3.0 * KEYFRAME.0 * self.scale { 1 } else { pixels(KEYFRAME.0) };
        let height = pixels(KEYFRAME.1);
        let mut before = None;
        for frame in keyframes.iter().filter(|frame| **frame < self.count) {
            let left = self.place_of(*frame).round() as i32 - width / 2;
            if before != Some(left) {
                canvas.rectangle((left, bottom - height), (width, height), color_of(Tint::Keyframe), 1.0);
                before = Some(left);
            }
        }
    }

    /// Numbers of frames below the track.
    fn ticks(&self, top: i32, typeface: &mut Typeface, canvas: &mut Canvas) {
        let pixels = |length: f32| ((length * self.scale).round() as i32).max(1);
        let size = pixels(TEXT_SIZE).unsigned_abs();
        let end = self.count - 1;
        let step = self.step();
        let mut buffer = [0; 20];
        let mut write = |frame: usize, free_until: i32| {
            let text = digits(frame, &mut buffer);
            let width = typeface.width(text, size, Weight::Regular) as i32;
            let middle = self.place_of(frame).round() as i32;
            let left = (middle - width / 2).clamp(2, (self.size.0 as i32 - width - 2).max(2));
            if left + width <= free_until {
                canvas.rectangle((middle, top), (pixels(1.0), pixels(4.0)), QUIET, 1.0);
                let baseline = top + pixels(5.0) + size as i32;
                canvas.text(typeface, text, (left, baseline), size, Weight::Regular, QUIET);
            }
            left
        };
        let last = write(end, i32::MAX);
        for frame in (0..end).step_by(step) {
            write(frame, last - pixels(6.0));
        }
    }

    /// Between two ticks: the least of 1, 2 and 5 times a power of ten that leaves room for the numbers.
    fn step(&self) -> usize {
        let most = ((self.last - self.first) / (TICKS_APART * self.scale)).max(1.0) as usize;
        let least = (self.count - 1).div_ceil(most).max(1);
        let mut power = 1usize;
        loop {
            for digit in [1, 2, 5] {
                let step = power.saturating_mul(digit);
                if step >= least {
                    return step;
                }
            }
            power = power.saturating_mul(10);
        }
    }
}

/// `number` in digits, without any new memory.
fn digits(mut number: usize, buffer: &mut [u8; 20]) -> &str {
    let mut start = buffer.len();
    loop {
        start -= 1;
        buffer[start] = b'0' + (number % 10) as u8;
        number /= 10;
        if number == 0 || start == 0 {
            break;
        }
    }
    str::from_utf8(&buffer[start..]).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    const WHOLE: Timeline = Timeline { frame: 0, count: 1377, range: (0, 1376), playing: false };

    proptest! {
        #[test]
        fn where_a_frame_is_there_is_that_frame(
            count in 2usize..1500, frame in 0usize..1500, width in 400usize..4000, scale in 0.5f32..2.0,
        ) {
            let bar = Bar::new(&Timeline { count, ..WHOLE }, (width, 800), scale).unwrap();
            let frame = frame.min(count - 1);
            let off = bar.frame_at(bar.place_of(frame)).abs_diff(frame);
            prop_assert!(off == 0, "{off} frames off");
            prop_assert!(bar.contains(bar.place_of(frame), 799.0));
        }

        #[test]
        fn no_numbers_make_it_panic(
            raw in any::<[f32; 3]>(), frame in any::<usize>(), count in any::<usize>(),
            range in any::<(usize, usize)>(), size in (1usize..300, 1usize..300),
        ) {
            let timeline = Timeline { frame, count, range, playing: true };
            if let Some(bar) = Bar::new(&timeline, size, raw[0]) {
                bar.contains(raw[1], raw[2]);
                prop_assert!(bar.frame_at(raw[1]) < count);
                let keyframes = [0, frame, count];
                bar.draw(&timeline, &keyframes, &mut Typeface::without_letters(), &mut Canvas::new(size.0, size.1));
            }
        }
    }

    #[test]
    fn outside_of_the_bar_are_the_first_and_the_last_frame() {
        let bar = Bar::new(&WHOLE, (800, 600), 1.0).unwrap();
        assert_eq!((bar.frame_at(-50.0), bar.frame_at(1e9)), (0, 1376));
        assert_eq!(bar.frame_at(f32::NAN), 0);
        assert!(bar.contains(400.0, 590.0) && !bar.contains(400.0, 500.0) && !bar.contains(900.0, 590.0));
    }

    #[test]
    fn a_single_frame_or_a_small_picture_has_no_bar() {
        assert_eq!(Bar::new(&Timeline { count: 1, ..WHOLE }, (800, 600), 1.0), None);
        assert_eq!(Bar::new(&Timeline { count: 0, ..WHOLE }, (800, 600), 1.0), None);
        assert_eq!(Bar::new(&WHOLE, (100, 600), 1.0), None);
        assert_eq!(Bar::new(&WHOLE, (16, 16), 1.0), None);
    }

    #[test]
    fn the_knob_is_where_the_frame_is_and_brackets_show_a_range() {
        let drawn = |timeline: Timeline| {
            let mut canvas = Canvas::new(800, 200);
            let bar = Bar::new(&timeline, canvas.size(), 1.0).unwrap();
            bar.draw(&timeline, &[], &mut Typeface::without_letters(), &mut canvas);
            (bar, canvas)
        };
        let columns = |canvas: &Canvas, color: Color| {
            let pixels = canvas.pixels().iter().enumerate().filter(|(_, pixel)| **pixel == color.0);
            pixels.map(|(index, _)| index % 800).collect::<Vec<_>>()
        };
        let (bar, canvas) = drawn(Timeline { frame: 700, ..WHOLE });
        let white = columns(&canvas, Color::WHITE);
        let (low, high) = (white.iter().min().unwrap(), white.iter().max().unwrap());
        assert!(((low + high + 1) as f32 / 2.0 - bar.place_of(700)).abs() < 1.5);
        assert!(columns(&canvas, WARNING).is_empty());
        let (bar, canvas) = drawn(Timeline { frame: 700, range: (200, 900), ..WHOLE });
        let brackets = columns(&canvas, WARNING);
        assert!((*brackets.iter().min().unwrap() as f32 - bar.place_of(200)).abs() < 1.5);
        assert!((*brackets.iter().max().unwrap() as f32 + 1.0 - bar.place_of(900)).abs() < 1.5);
    }

    /// In the columns of the keyframes, and in no other; crowded ones stay apart.
    #[test]
    fn keyframes_are_posts_on_the_track_at_their_frames() {
        let (few, many) = (vec![0, 100, 101, 800, 1376], (0..1377).step_by(7).collect::<Vec<usize>>());
        for keyframes in [few, many] {
            let mut canvas = Canvas::new(1280, 200);
            let bar = Bar::new(&WHOLE, canvas.size(), 1.0).unwrap();
            bar.draw(&WHOLE, &keyframes, &mut Typeface::without_letters(), &mut canvas);
            // Above the track and beside the knob.
            let row = bar.top as usize + 5;
            let green = |x: usize| canvas.pixel(x, row) == Some(color_of(Tint::Keyframe));
            let near = |x: usize, frame: &usize| (bar.place_of(*frame) - x as f32).abs() < 1.6;
            for frame in keyframes.iter().filter(|frame| bar.place_of(**frame) > bar.first + 12.0) {
                assert!((0..1280).any(|x| green(x) && near(x, frame)), "{frame}");
            }
            let stray = (0..1280).filter(|x| green(*x) && !keyframes.iter().any(|frame| near(*x, frame)));
            assert_eq!(stray.count(), 0);
            let gaps = (0..1280).filter(|x| green(*x) && !green(*x + 1)).count();
            assert!(gaps + 3 >= keyframes.len(), "{gaps} posts for {} keyframes", keyframes.len());
        }
    }

    #[test]
    fn numbers_are_written_in_digits() {
        for number in [0, 7, 10, 1376, usize::MAX] {
            assert_eq!(digits(number, &mut [0; 20]), number.to_string());
        }
    }
}
