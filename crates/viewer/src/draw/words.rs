//! Letters and words in the world.

use super::AXES;
use super::colors::{PAPER, color_of};
use crate::camera::{Spot, View};
use crate::draw::canvas::{Canvas, Color, Pen, Typeface, Weight};
use crate::scene::{Figure, Mark, Tint};

/// The height of letters in the world, in pixels.
const TEXT_SIZE: f32 = 15.0;

/// Writes letters of one size.
pub(super) struct Writer<'a> {
    pub typeface: &'a mut Typeface,
    pub view: &'a View,
    pub scale: f32,
}

impl Writer<'_> {
    fn size(&self) -> u32 {
        (TEXT_SIZE * self.scale).round() as u32
    }

    /// Writes the letters at the axes of a figure.
    pub fn axes(&mut self, figure: &Figure, canvas: &mut Canvas) {
        for axes in figure.axes.iter().filter(|axes| axes.lettered) {
            for (unit, tint) in AXES {
                let tip = axes.origin + axes.rotation * unit * axes.length * 1.22;
                let letter = match tint {
                    Tint::X => "X",
                    Tint::Y => "Y",
                    _ => "Z",
                };
                if let Some(spot) = self.view.project(tip) {
                    let aside = (5.0 * self.scale) as i32;
                    let place =
                        ((spot.x as i32).saturating_sub(aside), (spot.y as i32).saturating_add(aside));
                    self.haloed(letter, place, color_of(tint), canvas);
                }
            }
        }
    }

    /// Writes what stands beside a mark.
    pub fn mark(&mut self, mark: &Mark, canvas: &mut Canvas) {
        let Some(spot) = self.view.project(mark.to) else { return };
        if mark.text.is_empty() {
            return;
        }
        let scaled = |length: i32| (length as f32 * self.scale) as i32;
        let (right, down) = (scaled(mark.text_offset.0), scaled(mark.text_offset.1));
        let below = scaled(5);
        let far = down.unsigned_abs() > scaled(20).unsigned_abs();
        let width = self.typeface.width(&mark.text, self.size(), Weight::Bold) as i32;
        let start = match right.signum() {
            -1 => right.saturating_sub(width),
            0 => -width / 2,
            _ => right,
        };
        if far {
            let toward = Spot {
                x: spot.x + 0.9 * right as f32,
                y: spot.y + 0.65 * down as f32,
                nearness: spot.nearness,
            };
            canvas.line(spot, toward, Pen { width: self.scale, color: color_of(mark.tint), opacity: 0.6 });
        }
        let left = (spot.x as i32).saturating_add(start);
        let baseline = (spot.y as i32).saturating_add(down.saturating_add(below));
        self.haloed(&mark.text, (left, baseline), color_of(mark.tint), canvas);
    }

    /// Bold text with a light edge, so that it can be read on anything. Nothing, where it would be outside of the
    /// picture.
    fn haloed(&mut self, text: &str, (x, y): (i32, i32), color: Color, canvas: &mut Canvas) {
        let (size, weight) = (self.size(), Weight::Bold);
        let (width, height) = (canvas.size().0 as i32, canvas.size().1 as i32);
        let (room, tall) = (self.typeface.width(text, size, weight) as i32 + 2, size as i32 + 2);
        if !(-room..=width).contains(&x) || !(-tall..=height + tall).contains(&y) {
            return;
        }
        let edge = self.scale.round().max(1.0) as i32;
        for (right, down) in [(-1, -1), (1, -1), (-1, 1), (1, 1), (0, -1), (0, 1), (-1, 0), (1, 0)] {
            let place = (x.saturating_add(edge * right), y.saturating_add(edge * down));
            canvas.text(self.typeface, text, place, size, weight, PAPER);
        }
        canvas.text(self.typeface, text, (x, y), size, weight, color);
    }
}
