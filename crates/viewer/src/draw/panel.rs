//! Blocks of text in the corners of the picture.

use std::ops::Range;

use super::canvas::{Canvas, Color, Typeface, Weight};
use super::colors::{BACKDROP, BACKDROP_OPACITY, PLAIN, QUIET, RIGHT, WARNING, color_of};
use super::plot;
use crate::scene::{Corner, Line, Panel, Plot};

/// Lengths in pixels, for an ordinary display.
const TEXT_SIZE: f32 = 14.0;
const LINE_HEIGHT: f32 = 20.0;
const PADDING: f32 = 10.0;
const MARGIN: f32 = 12.0;
const SWATCH: f32 = 24.0;
const WIDEST: f32 = 560.0;

/// In pictures smaller than this, texts are smaller too, down to a share.
const ROOMY: (f32, f32) = (480.0, 320.0);
const SMALLEST: f32 = 0.72;

/// The share of the picture that panels may cover, in a small picture and in others, and the least picture that has any.
const MOST_COVERED: (f32, f32) = (0.38, 0.5);
const LEAST: (f32, f32) = (96.0, 64.0);

/// Lays panels over pictures, and keeps the memory for this.
#[derive(Default)]
pub(crate) struct Panels {
    rows: Vec<Row>,
    ranges: Vec<Range<usize>>,
    placed: Vec<Rectangle>,
}

/// A part of a panel's line.
struct Row {
    /// Which line of the panel it belongs to, and whether it is the first of it.
    line: usize,
    is_first: bool,
    /// Where it is in the line's text.
    text: Range<usize>,
}

/// A part of the picture, in pixels.
#[derive(Clone, Copy)]
pub(super) struct Rectangle {
    pub left: i32,
    pub top: i32,
    pub width: i32,
    pub height: i32,
}

impl Rectangle {
    fn meets(&self, other: &Rectangle, apart: i32) -> bool {
        self.left < other.left + other.width + apart
            && other.left < self.left + self.width + apart
            && self.top < other.top + other.height + apart
            && other.top < self.top + self.height + apart
    }

    fn area(&self) -> i64 {
        i64::from(self.width) * i64::from(self.height)
    }
}

/// Lengths in pixels for one picture.
#[derive(Clone, Copy)]
struct Measures {
    /// How large things are, 1 for an ordinary display.
    fit: f32,
    text: u32,
    line: i32,
    padding: i32,
    margin: i32,
    swatch: i32,
    widest: i32,
    /// How many pixels panels may cover.
    room: i64,
}

/// How large texts are in a picture of `size` pixels, 1 for an ordinary display, where they have the size `scale` in a large one.
pub fn fit(size: (usize, usize), scale: f32) -> f32 {
    let (width, height) = (size.0 as f32 / scale, size.1 as f32 / scale);
    (width / ROOMY.0).min(height / ROOMY.1).clamp(SMALLEST, 1.0) * scale
}

impl Measures {
    /// `None` when the picture is too small for any text.
    fn new(size: (usize, usize), scale: f32) -> Option<Measures> {
        let (width, height) = (size.0 as f32 / scale, size.1 as f32 / scale);
        if width < LEAST.0 || height < LEAST.1 {
            return None;
        }
        let fit = fit(size, scale);
        let pixels = |length: f32| (length * fit).round() as i32;
        let margin = pixels(MARGIN);
        let share = if fit < scale { MOST_COVERED.0 } else { MOST_COVERED.1 };
        Some(Measures {
            fit,
            text: pixels(TEXT_SIZE).unsigned_abs(),
            line: pixels(LINE_HEIGHT),
            padding: pixels(PADDING),
            margin,
            swatch: pixels(SWATCH),
            widest: pixels(WIDEST).min(size.0 as i32 - 2 * margin),
            room: (share * size.0 as f32 * size.1 as f32) as i64,
        })
    }
}

impl Panels {
    /// Lays `panels` over the picture, none of them lower than `bottom`. What finds no room is cut or left out, the
    /// last ones first.
    pub fn draw(
        &mut self,
        (panels, plot): (&[Panel], Option<&Plot>),
        scale: f32,
        bottom: i32,
        typeface: &mut Typeface,
        canvas: &mut Canvas,
    ) {
        let Some(measures) = Measures::new(canvas.size(), scale) else { return };
        self.placed.clear();
        for (index, panel) in panels.iter().enumerate() {
            if let Some(plot) = plot.filter(|plot| plot.behind == index) {
                self.plot(plot, measures, bottom, typeface, canvas);
            }
            let width = self.break_lines(panel, measures, typeface);
            if let Some((place, rows)) = self.place(panel.corner, width, measures, bottom, canvas.size()) {
                self.placed.push(place);
                self.draw_one(panel, place, rows, measures, typeface, canvas);
            }
        }
        if let Some(plot) = plot.filter(|plot| plot.behind >= panels.len()) {
            self.plot(plot, measures, bottom, typeface, canvas);
        }
    }

    /// Where a plot begins in a picture of `size` pixels if it finds room, or where the picture ends: from the left.
    pub fn left_of_plot(plot: Option<&Plot>, scale: f32, size: (usize, usize)) -> i32 {
        let right = size.0 as i32;
        let Some((plot, measures)) = plot.zip(Measures::new(size, scale)) else { return right };
        right - measures.margin - plot::size(plot, measures.fit).0
    }

    /// Draws the plot where there is room for all of it.
    fn plot(
        &mut self,
        plot: &Plot,
        measures: Measures,
        bottom: i32,
        typeface: &mut Typeface,
        canvas: &mut Canvas,
    ) {
        let size = plot::size(plot, measures.fit);
        if let Some(place) = self.spot(Corner::BottomRight, size, measures, bottom, canvas.size()) {
            self.placed.push(place);
            plot::draw(plot, place, measures.fit, typeface, canvas);
        }
    }

    /// Breaks the lines of a panel into rows and gives its width.
    fn break_lines(&mut self, panel: &Panel, measures: Measures, typeface: &mut Typeface) -> i32 {
        self.rows.clear();
        let (column, mut width) = (column(panel, measures, typeface), 0);
        for (index, (line, text)) in panel.lines().enumerate() {
            let (indent, weight, _) = look(line, column, measures);
            let room = measures.widest - 2 * measures.padding - indent;
            self.ranges.clear();
            typeface.wrap(text, measures.text, weight, room as f32, &mut self.ranges);
            for (row, range) in self.ranges.iter().enumerate() {
                let words = text[range.clone()].trim_end();
                width = width.max(indent + typeface.width(words, measures.text, weight).ceil() as i32);
                self.rows.push(Row { line: index, is_first: row == 0, text: range.clone() });
            }
        }
        width + 2 * measures.padding
    }

    /// Where there is room for the rows, and for how many of them.
    fn place(
        &self,
        corner: Corner,
        width: i32,
        measures: Measures,
        bottom: i32,
        size: (usize, usize),
    ) -> Option<(Rectangle, usize)> {
        // What is cut ends in dots; dots alone say nothing.
        for rows in (1..=self.rows.len()).rev().filter(|rows| *rows > 1 || self.rows.len() == 1) {
            let height = rows as i32 * measures.line + 2 * measures.padding - measures.line / 5;
            if let Some(place) = self.spot(corner, (width, height), measures, bottom, size) {
                return Some((place, rows));
            }
        }
        None
    }

    /// Where in its corner there is room for a rectangle of this width and height.
    fn spot(
        &self,
        corner: Corner,
        (width, height): (i32, i32),
        measures: Measures,
        bottom: i32,
        size: (usize, usize),
    ) -> Option<Rectangle> {
        let left = match corner {
            Corner::TopLeft | Corner::BottomLeft => measures.margin,
            Corner::TopRight | Corner::BottomRight => size.0 as i32 - measures.margin - width,
        };
        let from_top = matches!(corner, Corner::TopLeft | Corner::TopRight);
        let mut place = Rectangle { left, top: measures.margin, width, height };
        let covered: i64 = self.placed.iter().map(Rectangle::area).sum();
        if place.area() > measures.room - covered || left < measures.margin {
            return None;
        }
        if !from_top {
            place.top = bottom - measures.margin - height;
        }
        // Those that are there push it away from its corner.
        for _ in 0..self.placed.len() {
            let Some(other) = self.placed.iter().find(|other| place.meets(other, measures.margin)) else {
                break;
            };
            place.top = match from_top {
                true => other.top + other.height + measures.margin,
                false => other.top - measures.margin - height,
            };
        }
        let inside = place.top >= measures.margin && place.top + height <= bottom - measures.margin;
        let free = !self.placed.iter().any(|other| place.meets(other, measures.margin));
        (inside && free).then_some(place)
    }

    fn draw_one(
        &self,
        panel: &Panel,
        place: Rectangle,
        count: usize,
        measures: Measures,
        typeface: &mut Typeface,
        canvas: &mut Canvas,
    ) {
        let (left, size) = (place.left + measures.padding, measures.text);
        canvas.rectangle((place.left, place.top), (place.width, place.height), BACKDROP, BACKDROP_OPACITY);
        let mut baseline = place.top + measures.padding + size as i32 - 2;
        let column = column(panel, measures, typeface);
        let mut lines = panel.lines().enumerate();
        let mut current = lines.next();
        for (index, row) in self.rows[..count].iter().enumerate() {
            while current.as_ref().is_some_and(|(index, _)| *index < row.line) {
                current = lines.next();
            }
            let Some((_, (line, text))) = current else { break };
            if index + 1 == count && count < self.rows.len() {
                canvas.text(typeface, "…", (left, baseline), size, Weight::Bold, QUIET);
                break;
            }
            let (indent, weight, color) = look(line, column, measures);
            match line {
                Line::Key(key) if row.is_first => {
                    canvas.text(typeface, key, (left, baseline), size, Weight::Bold, Color::WHITE);
                }
                Line::Legend(tint) if row.is_first => {
                    // On a light ground, as in the scene: some of these colours are dark.
                    let share = |part: i32| measures.swatch * part / 24;
                    let (x, y) = (left, baseline - share(11));
                    canvas.rectangle((x, y), (share(16), share(13)), Color(0xD6_D9_DB), 1.0);
                    let inner = (share(16) - 2 * share(2), share(13) - 2 * share(2));
                    canvas.rectangle((x + share(2), y + share(2)), inner, color_of(tint), 1.0);
                }
                _ => {}
            }
            let words = &text[row.text.clone()];
            canvas.text(typeface, words, (left + indent, baseline), size, weight, color);
            baseline += measures.line;
        }
    }
}

/// Where the texts of keys start.
fn column(panel: &Panel, measures: Measures, typeface: &mut Typeface) -> i32 {
    let keys = panel.lines().filter_map(|(line, _)| match line {
        Line::Key(key) => Some(typeface.width(key, measures.text, Weight::Bold) as i32),
        _ => None,
    });
    keys.max().unwrap_or(0) + measures.swatch * 2 / 3
}

/// How far a line is indented, and how it is written.
fn look(line: Line, column: i32, measures: Measures) -> (i32, Weight, Color) {
    match line {
        Line::Heading => (0, Weight::Bold, Color::WHITE),
        Line::Text => (0, Weight::Regular, PLAIN),
        Line::Quiet => (0, Weight::Regular, QUIET),
        Line::Right => (0, Weight::Regular, RIGHT),
        Line::Trouble => (0, Weight::Regular, WARNING),
        Line::Key(_) => (column, Weight::Regular, QUIET),
        Line::Legend(_) => (measures.swatch, Weight::Regular, QUIET),
    }
}
