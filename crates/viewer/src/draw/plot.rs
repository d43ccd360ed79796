//! Curves in a panel: how an error grows, or how a time warp leads from frames to frames.

use glam::Vec2;

use super::canvas::{Canvas, Color, Pen, Typeface, Weight};
use super::colors::{self, BACKDROP, BACKDROP_OPACITY, PLAIN, QUIET, color_of};
use super::panel::Rectangle;
use crate::camera::Spot;
use crate::scene::{Curve, Plot, Stroke, Tint};

/// Lengths in pixels, for an ordinary display.
const SIZE: (f32, f32) = (380.0, 216.0);
const SMALL: (f32, f32) = (244.0, 200.0);
const TEXT_SIZE: f32 = 12.0;
const PADDING: f32 = 10.0;
const GAP: f32 = 6.0;
const LAST: f32 = 11.0;
const LINE: f32 = 15.0;
const PEN: f32 = 2.2;
const FAINT_PEN: f32 = 1.2;
const SAMPLE: f32 = 20.0;

/// Some curves are dashed, so that nobody depends on colours: lengths of a dash and of a gap.
const DASH: (f32, f32) = (7.0, 5.0);
const FAINT_DASH: (f32, f32) = (4.0, 3.0);

/// Steps of less than this are taken together.
const SHORT: f32 = 2.5;

const GRID: Color = Color(0x45_4F_5C);
const AXIS: Color = Color(0x8C_98_A6);

/// How large a plot is, in pixels.
pub(super) fn size(plot: &Plot, fit: f32) -> (i32, i32) {
    let (width, height) = if plot.small { SMALL } else { SIZE };
    ((width * fit).round() as i32, (height * fit).round() as i32)
}

/// Draws the plot and what lies behind it.
pub(super) fn draw(plot: &Plot, place: Rectangle, fit: f32, typeface: &mut Typeface, canvas: &mut Canvas) {
    canvas.rectangle((place.left, place.top), (place.width, place.height), BACKDROP, BACKDROP_OPACITY);
    let mut ink = Ink { fit, typeface, canvas };
    let frame = ink.frame(plot, place);
    let above = ink.above(plot);
    ink.words(&plot.upwards, (place.left as f32 + ink.pixels(PADDING), frame.top - above), PLAIN);
    if frame.width < ink.pixels(4.0 * LINE) || frame.height < ink.pixels(2.0 * LINE) {
        return;
    }
    ink.axes(plot, &frame);
    ink.posts(plot, &frame);
    for (index, curve) in plot.curves.iter().enumerate() {
        ink.curve(curve, &frame, index);
    }
    match plot.small {
        true => ink.names_above(plot, place),
        false => ink.names(plot, &frame),
    }
    if let Some(mark) = plot.mark.and_then(|mark| frame.at(mark)) {
        let ring = (mark.x, mark.y);
        ink.canvas.disc(ring, ink.pixels(5.5), Color::WHITE);
        ink.canvas.disc(ring, ink.pixels(3.0), BACKDROP);
    }
    if plot.curves.is_empty() {
        let middle = frame.top + 0.5 * frame.height;
        ink.words(&plot.note, (frame.left + ink.pixels(PADDING), middle), QUIET);
    }
}

/// Where curves are.
struct Frame {
    left: f32,
    top: f32,
    width: f32,
    height: f32,
}

impl Frame {
    /// Where shares of the width and of the height are; nowhere when they are no numbers.
    fn at(&self, (right, up): (f32, f32)) -> Option<Vec2> {
        let share = |share: f32| (!share.is_nan()).then_some(share.clamp(0.0, 1.0));
        Some(Vec2::new(self.left + share(right)? * self.width, self.top + (1.0 - share(up)?) * self.height))
    }
}

struct Ink<'a> {
    fit: f32,
    typeface: &'a mut Typeface,
    canvas: &'a mut Canvas,
}

impl Ink<'_> {
    fn pixels(&self, length: f32) -> f32 {
        (length * self.fit).round().max(1.0)
    }

    fn text_size(&self) -> u32 {
        self.pixels(TEXT_SIZE) as u32
    }

    fn width(&mut self, text: &str) -> f32 {
        self.typeface.width(text, self.text_size(), Weight::Regular)
    }

    fn words(&mut self, text: &str, (left, baseline): (f32, f32), color: Color) {
        let place = (left.round() as i32, baseline.round() as i32);
        self.canvas.text(self.typeface, text, place, self.text_size(), Weight::Regular, color);
    }

    /// How far what goes upwards stands above the curves. In a small plot the last number stands at their top.
    fn above(&self, plot: &Plot) -> f32 {
        self.pixels(if plot.small { LAST } else { GAP })
    }

    /// What is left for the curves: numbers stand on the left and below, names on the right, what is shown above.
    fn frame(&mut self, plot: &Plot, place: Rectangle) -> Frame {
        let (padding, gap, line) = (self.pixels(PADDING), self.pixels(GAP), self.pixels(LINE));
        let numbers = plot.rows.iter().map(|tick| self.width(&tick.label)).fold(0.0, f32::max);
        let names = plot.curves.iter().map(|curve| self.width(&curve.name));
        let names = if plot.small { 0.0 } else { names.fold(0.0, f32::max) };
        let left = place.left as f32 + padding + numbers.ceil() + gap;
        let rows = if plot.small { 2.0 } else { 1.0 };
        let top = place.top as f32 + padding + rows * line + self.above(plot);
        let right = (place.left + place.width) as f32 - padding - names.ceil() - 1.5 * gap;
        let bottom = (place.top + place.height) as f32 - padding - 2.0 * line - 0.5 * gap;
        Frame { left: left.round(), top, width: (right - left).floor(), height: bottom - top }
    }

    fn axes(&mut self, plot: &Plot, frame: &Frame) {
        let (thin, gap) = (self.pixels(1.0) as i32, self.pixels(GAP));
        let ascent = 0.36 * self.text_size() as f32;
        for tick in &plot.rows {
            let Some(at) = frame.at((0.0, tick.at)) else { continue };
            let line = (at.x as i32, at.y.round() as i32 - thin / 2);
            self.canvas.rectangle(line, (frame.width as i32, thin), GRID, 1.0);
            let left = at.x - gap - self.width(&tick.label);
            self.words(&tick.label, (left, at.y + ascent), QUIET);
        }
        let bottom = frame.top + frame.height;
        let below = bottom + 0.5 * gap + self.text_size() as f32;
        let mut free_until = f32::INFINITY;
        // From the right, so that the last one is there.
        for tick in plot.columns.iter().rev() {
            let Some(at) = frame.at((tick.at, 0.0)) else { continue };
            let width = self.width(&tick.label);
            let mut left = at.x - 0.5 * width;
            if plot.small {
                left = left.min(frame.left + frame.width + 0.8 * self.pixels(PADDING) - width);
            }
            if left + width > free_until {
                continue;
            }
            free_until = left - gap;
            self.canvas.rectangle(
                (at.x.round() as i32 - thin / 2, bottom as i32),
                (thin, gap as i32 / 2),
                AXIS,
                1.0,
            );
            self.words(&tick.label, (left, below), QUIET);
        }
        let long = (frame.width as i32, frame.height as i32);
        self.canvas.rectangle((frame.left as i32, bottom.round() as i32), (long.0, thin), AXIS, 1.0);
        self.canvas.rectangle((frame.left as i32, frame.top as i32), (thin, long.1), AXIS, 1.0);
        let left = frame.left + 0.5 * (frame.width - self.width(&plot.rightwards));
        self.words(&plot.rightwards, (left, below + self.pixels(LINE)), PLAIN);
    }

    fn curve(&mut self, curve: &Curve, frame: &Frame, index: usize) {
        // Nearer than anything in the world, and each nearer than the one before.
        let nearness = 1e36 * (1 + index) as f32;
        let places = curve.points.iter().filter_map(|point| frame.at(*point));
        self.line(curve.stroke, places, nearness);
    }

    /// A line through some places.
    fn line(&mut self, stroke: Stroke, mut places: impl Iterator<Item = Vec2>, nearness: f32) {
        let spot = |place: Vec2| Spot { x: place.x, y: place.y, nearness };
        let (width, (dash, gap), dashed) = match stroke {
            Stroke::Solid => (PEN, DASH, false),
            Stroke::Dashed => (PEN, DASH, true),
            Stroke::Faint => (FAINT_PEN, FAINT_DASH, true),
        };
        let pen = Pen { width: width * self.fit, color: colors::curve(stroke), opacity: 1.0 };
        let (dash, period) = (dash * self.fit, (dash + gap) * self.fit);
        let Some(mut start) = places.next() else { return };
        let mut along = 0.0;
        let mut places = places.peekable();
        while let Some(end) = places.next() {
            let length = start.distance(end);
            if length < SHORT * self.fit && places.peek().is_some() {
                continue;
            }
            if !dashed {
                self.canvas.piece(spot(start), spot(end), pen);
            }
            let mut at = 0.0;
            while dashed && at < length {
                let within = (along + at) % period;
                let until = if within < dash { dash - within } else { period - within };
                let next = (at + until.max(0.5)).min(length);
                if within < dash {
                    let share = |at: f32| spot(start.lerp(end, at / length));
                    self.canvas.piece(share(at), share(next), pen);
                }
                at = next;
            }
            along += length;
            start = end;
        }
    }

    /// The name of each curve at its end, the higher one above the other.
    fn names(&mut self, plot: &Plot, frame: &Frame) {
        let line = self.pixels(LINE);
        let end = |curve: &Curve| curve.points.last().and_then(|point| frame.at(*point));
        for (index, curve) in plot.curves.iter().enumerate() {
            let Some(mut place) = end(curve) else { continue };
            let others = plot.curves.iter().enumerate().filter(|(other, _)| *other != index);
            for (other_index, other) in others.filter_map(|(at, other)| Some((at, end(other)?))) {
                let apart = place.y - other.y;
                if apart.abs() < line {
                    let is_below = if apart == 0.0 { index > other_index } else { apart > 0.0 };
                    let push = 0.5 * (line - apart.abs());
                    place.y += if is_below { push } else { -push };
                }
            }
            let ascent = 0.36 * self.text_size() as f32;
            let color = colors::curve(curve.stroke);
            let left = frame.left + frame.width + 1.5 * self.pixels(GAP);
            self.words(&curve.name, (left, place.y + ascent), color);
        }
    }

    /// The names in one row above all else, each behind a piece of its curve.
    fn names_above(&mut self, plot: &Plot, place: Rectangle) {
        let (padding, gap, sample) = (self.pixels(PADDING), self.pixels(GAP), self.pixels(SAMPLE));
        let baseline = place.top as f32 + padding + 0.75 * self.pixels(LINE);
        let y = (baseline - 0.36 * self.text_size() as f32).round();
        let mut left = place.left as f32 + padding;
        for curve in &plot.curves {
            self.line(curve.stroke, [left, left + sample].map(|x| Vec2::new(x, y)).into_iter(), 1e36);
            left += sample + gap;
            self.words(&curve.name, (left, baseline), colors::curve(curve.stroke));
            left += self.width(&curve.name) + 2.5 * gap;
        }
    }

    /// Where something begins or ends: thin lines upwards, with a foot.
    fn posts(&mut self, plot: &Plot, frame: &Frame) {
        let (thin, foot) = (self.pixels(1.0), self.pixels(GAP));
        let color = color_of(Tint::Keyframe);
        for at in plot.posts.iter().filter_map(|at| frame.at((*at, 0.0))) {
            let line = |height: f32| (thin as i32, height as i32);
            let left = (at.x - 0.5 * thin).round() as i32;
            self.canvas.rectangle((left, frame.top as i32), line(frame.height), color, 0.4);
            self.canvas.rectangle((left, (at.y - foot) as i32), (2 * thin as i32, foot as i32), color, 1.0);
        }
    }
}
