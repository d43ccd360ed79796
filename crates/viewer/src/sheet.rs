//! Contact sheets: many small pictures on one.

use crate::canvas::{Canvas, Color, MAX_SIDE, Weight};
use crate::draw::Painter;

/// The height of the strip below each tile in which its caption stands, in pixels.
const STRIP: usize = 22;

/// How wide the lines between tiles are, in pixels.
const LINE: usize = 1;

/// Tiles are not made smaller than this in width or height, in pixels, unless smaller ones are wanted.
const SMALLEST: usize = 48;

/// Width to height of a sheet whose columns nobody has chosen, about: that of most displays.
const ASPECT: f64 = 16.0 / 9.0;

const PAPER: Color = Color(0xF4_F6_F7);
const RULE: Color = Color(0x9A_A4_AF);

/// A sheet that is filled tile by tile, row by row from the upper left.
///
/// No side of it is longer than [`MAX_SIDE`]. When the wanted tiles do not fit, they are made smaller, in the same
/// aspect; when even small ones do not, there are fewer: [`Sheet::tile`] and [`Sheet::count`] say what it came to.
#[derive(Clone, Debug)]
pub struct Sheet {
    layout: Layout,
    canvas: Canvas,
    /// A tile and its caption, cut to their size.
    stamp: Canvas,
}

impl Sheet {
    /// A sheet for `count` tiles of the size `tile`, in so many `columns` or in as many as make the sheet about as wide
    /// as a display. 0 columns or tiles count as 1.
    pub fn new(count: usize, tile: (usize, usize), columns: Option<usize>) -> Sheet {
        let layout = Layout::new(count, Canvas::clamped(tile), columns);
        let (width, height) = layout.size();
        let mut canvas = Canvas::new(width, height);
        canvas.clear(RULE);
        let mut stamp = Canvas::new(layout.tile.0, layout.tile.1 + STRIP);
        stamp.clear(PAPER);
        for index in 0..layout.columns * layout.rows() {
            let (left, top) = layout.place(index);
            canvas.paste(&stamp, left, top);
        }
        Sheet { layout, canvas, stamp }
    }

    /// How many tiles there are.
    pub fn count(&self) -> usize {
        self.layout.count
    }

    /// Width and height of each, in pixels: the size to draw pictures in.
    pub fn tile(&self) -> (usize, usize) {
        self.layout.tile
    }

    /// Columns and rows.
    pub fn columns_and_rows(&self) -> (usize, usize) {
        (self.layout.columns, self.layout.rows())
    }

    /// Puts `picture` on a tile, and `caption` below it. What is larger than a tile is cut off; a tile that is not there
    /// is passed over.
    pub fn place(&mut self, index: usize, picture: &Canvas, caption: &str, painter: &mut Painter) {
        if index >= self.layout.count {
            return;
        }
        let height = self.layout.tile.1;
        self.stamp.clear(PAPER);
        // Below the picture, so that one that is too large does not cover it.
        self.stamp.paste(picture, 0, 0);
        self.stamp.rectangle((0, height as i32), (MAX_SIDE as i32, STRIP as i32), PAPER, 1.0);
        let baseline = (height + STRIP - 7) as i32;
        painter.caption(caption, (6, baseline), 13, Weight::Regular, &mut self.stamp);
        let (left, top) = self.layout.place(index);
        self.canvas.paste(&self.stamp, left, top);
    }

    /// The sheet as a picture.
    pub fn finish(self) -> Canvas {
        self.canvas
    }
}

/// Where tiles lie.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Layout {
    count: usize,
    tile: (usize, usize),
    columns: usize,
}

impl Layout {
    fn new(count: usize, wanted: (usize, usize), columns: Option<usize>) -> Layout {
        let count = count.max(1);
        // Tiles of the wanted aspect, at most as large as wanted; how large, follows from how many there are in a row or
        // a column.
        let scaled = |scale: f64| {
            let side = |side: usize| ((side as f64 * scale) as usize).clamp(SMALLEST.min(side), side);
            (side(wanted.0), side(wanted.1))
        };
        let room = |side: usize, extra: usize| (MAX_SIDE - LINE) / (side + extra + LINE);
        let smallest = scaled(0.0);
        let most_columns = room(smallest.0, 0).max(1);
        let most_rows = room(smallest.1, STRIP).max(1);
        let columns = columns.unwrap_or_else(|| near_aspect(count, wanted)).clamp(1, count.min(most_columns));
        // More columns than wanted are better than fewer tiles, if nobody has said how many.
        let count = count.min(columns.saturating_mul(most_rows));
        let rows = count.div_ceil(columns);

        let share = |number: usize, side: usize, extra: usize| {
            let own = (MAX_SIDE - LINE) / number;
            own.saturating_sub(extra + LINE) as f64 / side as f64
        };
        let scale = share(columns, wanted.0, 0).min(share(rows, wanted.1, STRIP)).min(1.0);
        Layout { count, tile: scaled(scale), columns }
    }

    fn rows(&self) -> usize {
        self.count.div_ceil(self.columns)
    }

    /// Width and height of the sheet.
    fn size(&self) -> (usize, usize) {
        let (width, height) = self.pitch();
        (self.columns * width + LINE, self.rows() * height + LINE)
    }

    /// From one tile to the next, to the right and downwards.
    fn pitch(&self) -> (usize, usize) {
        (self.tile.0 + LINE, self.tile.1 + STRIP + LINE)
    }

    /// The upper left corner of a tile.
    fn place(&self, index: usize) -> (usize, usize) {
        let (width, height) = self.pitch();
        (index % self.columns * width + LINE, index / self.columns * height + LINE)
    }
}

/// How many columns bring a sheet near to [`ASPECT`], with few places left empty.
fn near_aspect(count: usize, (width, height): (usize, usize)) -> usize {
    let (width, height) = ((width + LINE) as f64, (height + STRIP + LINE) as f64);
    let ideal = (count as f64 * ASPECT * height / width).sqrt();
    // A little more or less, if that fills the last row.
    let around = [ideal.floor(), ideal.ceil(), ideal.floor() - 1.0, ideal.ceil() + 1.0];
    let badness = |columns: usize| {
        let rows = count.div_ceil(columns);
        let aspect = columns as f64 * width / (rows as f64 * height);
        let empty = (columns * rows - count) as f64 / count as f64;
        (aspect / ASPECT).ln().abs() + empty
    };
    around
        .into_iter()
        .map(|columns| (columns.max(1.0) as usize).min(count))
        .min_by(|a, b| badness(*a).total_cmp(&badness(*b)))
        .unwrap_or(1)
}

/// At most `count` frames, spread evenly from `first` to `last`, both included; fewer when there are not so many. One
/// frame is the first; none is none.
pub fn spread(first: usize, last: usize, count: usize) -> Vec<usize> {
    let steps = last.saturating_sub(first) as u128;
    let count = (count as u128).min(steps + 1);
    let gaps = count.saturating_sub(1).max(1);
    // Rounded to the nearest; nothing is counted twice, as the steps are at least as many as the gaps.
    (0..count).map(|i| first + ((2 * i * steps + gaps) / (2 * gaps)) as usize).collect()
}
