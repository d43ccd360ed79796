//! The picture: pixels and their depth, and what can be drawn on it.
//!
//! A small software rasteriser. Lines and squares carry a depth and hide what lies behind them; their edges are
//! anti-aliased by the share of each pixel that they cover. Text and panels lie on top of everything.

mod disc;
mod ground;
mod line;
mod square;
mod text;

pub use ground::Ground;
pub(crate) use ground::haze;
pub use line::Pen;
pub use text::{Typeface, Weight};

/// A colour, as red, green and blue of 8 bits each (sRGB) in the low three bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Color(pub u32);

impl Color {
    /// White.
    pub const WHITE: Color = Color(0xFF_FF_FF);
    /// Black.
    pub const BLACK: Color = Color(0);

    /// Red, green and blue, 0 to 255 each.
    pub fn channels(self) -> [u8; 3] {
        let [_, red, green, blue] = self.0.to_be_bytes();
        [red, green, blue]
    }

    /// This colour with `share` (0 to 1) of `other` in it.
    pub fn mix(self, other: Color, share: f32) -> Color {
        self.mix_256ths(other, (share.clamp(0.0, 1.0) * 256.0) as i32 as u32)
    }

    fn mix_256ths(self, other: Color, share: u32) -> Color {
        // Red and blue are calculated at once, 16 bits apart.
        let rest = 256 - share;
        let red_blue = ((self.0 & 0xFF_00_FF) * rest + (other.0 & 0xFF_00_FF) * share) >> 8;
        let green = ((self.0 & 0x00_FF_00) * rest + (other.0 & 0x00_FF_00) * share) >> 8;
        Color((red_blue & 0xFF_00_FF) | (green & 0x00_FF_00))
    }
}

/// The largest width or height of a picture, in pixels.
pub const MAX_SIDE: usize = 8192;

/// Pixels, row by row from the top, and for each of them how near it is to the camera.
#[derive(Clone, Debug)]
pub struct Canvas {
    width: usize,
    height: usize,
    pixels: Vec<u32>,
    /// One over the depth of what was drawn there; 0 where there is only background.
    nearness: Vec<f32>,
}

impl Canvas {
    /// A black picture. Sides of less than 1 or more than [`MAX_SIDE`] pixels are brought into that range.
    pub fn new(width: usize, height: usize) -> Canvas {
        let (width, height) = Canvas::clamped((width, height));
        Canvas { width, height, pixels: vec![0; width * height], nearness: vec![0.0; width * height] }
    }

    /// The size of a picture that was wanted with this width and height.
    pub fn clamped((width, height): (usize, usize)) -> (usize, usize) {
        (width.clamp(1, MAX_SIDE), height.clamp(1, MAX_SIDE))
    }

    /// Width and height in pixels.
    pub fn size(&self) -> (usize, usize) {
        (self.width, self.height)
    }

    /// The pixels, row by row from the top, each a [`Color`]'s number.
    pub fn pixels(&self) -> &[u32] {
        &self.pixels
    }

    /// The colour at column `x` and row `y`; `None` outside of the picture.
    pub fn pixel(&self, x: usize, y: usize) -> Option<Color> {
        let inside = x < self.width && y < self.height;
        inside.then(|| Color(self.pixels[y * self.width + x]))
    }

    /// Makes everything `color` and infinitely far.
    pub fn clear(&mut self, color: Color) {
        self.pixels.fill(color.0);
        self.nearness.fill(0.0);
    }

    /// Lays a rectangle of `color` over everything; `opacity` 1 hides what was there. Corners in pixels; what lies
    /// outside of the picture is left out.
    pub fn rectangle(
        &mut self,
        (left, top): (i32, i32),
        (width, height): (i32, i32),
        color: Color,
        opacity: f32,
    ) {
        let clip = |at: i32, length: usize| at.clamp(0, length as i32) as usize;
        let share = (opacity.clamp(0.0, 1.0) * 256.0) as i32 as u32;
        let columns = clip(left, self.width)..clip(left.saturating_add(width.max(0)), self.width);
        for y in clip(top, self.height)..clip(top.saturating_add(height.max(0)), self.height) {
            for pixel in &mut self.pixels[y * self.width..][columns.clone()] {
                *pixel = Color(*pixel).mix_256ths(color, share).0;
            }
        }
    }

    /// Copies `other` onto this picture, its upper left corner at (`left`, `top`). What does not fit is left out.
    pub fn paste(&mut self, other: &Canvas, left: usize, top: usize) {
        let width = other.width.min(self.width.saturating_sub(left));
        let height = other.height.min(self.height.saturating_sub(top));
        for y in 0..height {
            let from = &other.pixels[y * other.width..][..width];
            self.pixels[(top + y) * self.width + left..][..width].copy_from_slice(from);
        }
    }

    /// The pixels and, for each of them, the nearness of what was drawn there: 0 where there is only background.
    pub(crate) fn layers(&mut self) -> (&mut [u32], &mut [f32]) {
        (&mut self.pixels, &mut self.nearness)
    }

    /// Puts `color` on one pixel if nothing nearer is there. `coverage` is the share of the pixel, 0 to 1.
    fn blend(&mut self, x: usize, y: usize, nearness: f32, color: Color, coverage: f32) {
        let index = y * self.width + x;
        if nearness <= self.nearness[index] {
            return;
        }
        self.pixels[index] = Color(self.pixels[index]).mix(color, coverage).0;
        if coverage > 0.5 {
            self.nearness[index] = nearness;
        }
    }
}

/// The pixels whose centres may lie between `low` and `high`, of `length` pixels in a row or column. Empty for
/// anything that is not a number.
fn covered(low: f32, high: f32, length: usize) -> std::ops::Range<usize> {
    // A float cast keeps to the range of its type and makes zero of NaN.
    let start = (low.floor().max(0.0) as usize).min(length);
    let end = ((high.ceil()).max(0.0) as usize).min(length);
    start..end.max(start)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_colour_mixes_from_none_to_all() {
        let (a, b) = (Color(0x10_20_30), Color(0xF0_E0_D0));
        assert_eq!(a.mix(b, 0.0), a);
        assert_eq!(a.mix(b, 1.0), b);
        assert_eq!(a.mix(b, f32::NAN), a);
        assert_eq!(a.mix(b, 0.5), Color(0x80_80_80));
    }

    #[test]
    fn a_rectangle_is_cut_at_the_borders() {
        let mut canvas = Canvas::new(4, 3);
        canvas.rectangle((-5, 1), (7, i32::MAX), Color::WHITE, 1.0);
        let lit = (0..12).filter(|i| canvas.pixels()[*i] != 0).collect::<Vec<_>>();
        assert_eq!(lit, [4, 5, 8, 9]);
        canvas.rectangle((3, 0), (i32::MIN, 5), Color::WHITE, 1.0);
        assert_eq!(canvas.pixels().iter().filter(|p| **p != 0).count(), 4);
    }

    #[test]
    fn a_pasted_picture_is_cut_at_the_borders() {
        let mut canvas = Canvas::new(4, 3);
        let mut stamp = Canvas::new(2, 2);
        stamp.clear(Color::WHITE);
        canvas.paste(&stamp, 3, 2);
        canvas.paste(&stamp, 9, 9);
        assert_eq!(canvas.pixels().iter().filter(|p| **p != 0).count(), 1);
        assert_eq!(canvas.pixel(3, 2), Some(Color::WHITE));
    }
}
