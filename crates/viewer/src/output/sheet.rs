//! Contact sheets: many small pictures on one.

use crate::draw::Painter;
use crate::draw::canvas::{Canvas, Color, MAX_SIDE, Weight};

/// The height of the strip below each tile in which its caption stands, in pixels.
const STRIP: usize = 22;

/// How wide the lines between tiles are, in pixels.
const LINE: usize = 1;

/// The shorter side of tiles is not made smaller than this, in pixels.
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
        let scaled = |scale: f64| {
            let side = |side: usize| ((side as f64 * scale) as usize).max(1);
            (side(wanted.0), side(wanted.1))
        };
        // The scale at which so many tiles stand beside each other or, with their captions, below each other.
        let share = |number: usize, side: usize, extra: usize| {
            ((MAX_SIDE - LINE) / number).saturating_sub(extra + LINE) as f64 / side as f64
        };
        let shared =
            |columns: usize, rows: usize| share(columns, wanted.0, 0).min(share(rows, wanted.1, STRIP));
        let least = (SMALLEST as f64 / wanted.0.min(wanted.1) as f64).min(shared(1, 1)).min(1.0);

        let smallest = scaled(least);
        let most_columns = (MAX_SIDE - LINE) / (smallest.0 + LINE);
        let most_rows = (MAX_SIDE - LINE) / (smallest.1 + STRIP + LINE);
        // More columns than look well are better than fewer tiles, if nobody has said how many.
        let chosen = || near_aspect(count, wanted).max(count.div_ceil(most_rows));
        let columns = columns.unwrap_or_else(chosen).clamp(1, count.min(most_columns));
        let count = count.min(columns * most_rows);
        let scale = shared(columns, count.div_ceil(columns)).min(1.0).max(least);
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
        let empty = columns as f64 * rows as f64 / count as f64 - 1.0;
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
    (0..count).map(|i| first + ((i * steps + gaps / 2) / gaps) as usize).collect()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn a_sheet_is_about_as_wide_as_a_display() {
        let shape = |count| Sheet::new(count, (32, 18), None).columns_and_rows();
        assert_eq!([1, 2, 3, 4].map(shape), [(1, 1), (2, 1), (3, 1), (4, 1)]);
        // Low tiles have captions of their own height: more beside each other than below.
        assert_eq!([12, 20].map(shape), [(6, 2), (7, 3)]);
        let large = |count| Layout::new(count, (320, 180), None);
        assert_eq!([1, 4, 9, 12, 16, 20].map(|count| large(count).columns), [1, 2, 3, 4, 4, 5]);
    }

    #[test]
    fn tiles_that_do_not_fit_are_made_smaller_and_then_fewer() {
        let fits = Layout::new(12, (320, 180), Some(4));
        assert_eq!((fits.count, fits.tile, fits.columns), (12, (320, 180), 4));
        let smaller = Layout::new(1000, (1280, 720), None);
        assert_eq!(smaller.count, 1000);
        assert!(smaller.tile.0 < 320 && smaller.tile.0.abs_diff(smaller.tile.1 * 16 / 9) <= 2, "{smaller:?}");
        let fewer = Layout::new(1000, (1280, 720), Some(1));
        assert_eq!((fewer.count, fewer.tile), (115, (85, 48)));
        assert_eq!(Layout::new(0, (320, 180), Some(0)).count, 1);
    }

    #[test]
    fn pictures_lie_on_their_tiles_with_their_captions_below() {
        let mut painter = Painter::new();
        let mut sheet = Sheet::new(3, (60, 50), Some(2));
        let empty = sheet.clone().finish();
        let mut picture = Canvas::new(70, 90);
        picture.clear(Color::BLACK);
        sheet.place(1, &picture, "frame 120 and much more than fits", &mut painter);
        sheet.place(3, &picture, "the fourth of three", &mut painter);
        let canvas = sheet.finish();
        assert_eq!(canvas.size(), (2 * 61 + 1, 2 * 73 + 1));
        let mut written = 0;
        for y in 0..canvas.size().1 {
            for x in 0..canvas.size().0 {
                let (now, before) = (canvas.pixel(x, y), empty.pixel(x, y));
                match (62..122).contains(&x) {
                    true if (1..51).contains(&y) => assert_eq!(now, Some(Color::BLACK)),
                    true if (51..73).contains(&y) => written += usize::from(now != before),
                    _ => assert_eq!(now, before, "{x} {y}"),
                }
            }
        }
        assert!(written > 60, "there is a caption: {written}");
    }

    proptest! {
        #[test]
        fn no_side_is_too_long_and_no_tiles_overlap(
            count in prop_oneof![0usize..50, any::<usize>()],
            tile in (1usize..=MAX_SIDE, 1usize..=MAX_SIDE),
            columns in proptest::option::of(prop_oneof![0usize..50, any::<usize>()]),
        ) {
            let layout = Layout::new(count, tile, columns);
            let (width, height) = layout.size();
            prop_assert!(width <= MAX_SIDE && height <= MAX_SIDE, "{layout:?}");
            prop_assert!(layout.count >= 1 && layout.count <= count.max(1));
            prop_assert!(layout.tile.0 <= tile.0 && layout.tile.1 <= tile.1);
            let mut taken = std::collections::HashSet::new();
            for index in 0..layout.count {
                let (left, top) = layout.place(index);
                prop_assert!(taken.insert((left, top)));
                prop_assert!(left + layout.tile.0 < width && top + layout.tile.1 + STRIP < height);
                // On a grid whose meshes are larger than a tile: none can reach into another.
                let (right, down) = layout.pitch();
                prop_assert!(right > layout.tile.0 && down > layout.tile.1 + STRIP);
                prop_assert!((left - LINE).is_multiple_of(right) && (top - LINE).is_multiple_of(down));
            }
        }

        #[test]
        fn frames_are_spread_evenly_with_both_ends(
            first in 0usize..1000,
            length in 0usize..1000,
            count in 0usize..100,
        ) {
            let last = first + length;
            let frames = spread(first, last, count);
            prop_assert_eq!(frames.len(), count.min(length + 1));
            prop_assert_eq!(frames.first(), (count > 0).then_some(&first));
            prop_assert!(count < 2 || frames.last() == Some(&last));
            let gaps: Vec<usize> = frames.windows(2).map(|pair| pair[1] - pair[0]).collect();
            if let (Some(least), Some(most)) = (gaps.iter().min(), gaps.iter().max()) {
                prop_assert!(*least > 0 && most - least <= 1, "{gaps:?}");
            }
        }
    }

    #[test]
    fn the_largest_frames_can_be_spread() {
        assert_eq!(spread(0, usize::MAX, 3), [0, usize::MAX / 2 + 1, usize::MAX]);
        assert_eq!(spread(7, 3, 5), [7]);
    }
}
