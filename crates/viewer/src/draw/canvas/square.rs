//! Squares that face the camera: the joints.

use super::{Canvas, Color, covered};
use crate::camera::Spot;

impl Canvas {
    /// Draws a square of `side` pixels with its centre at `centre`, and a border of one pixel inside of it, where
    /// nothing nearer is in the way.
    pub fn square(&mut self, centre: Spot, side: f32, fill: Color, border: Color) {
        let half = 0.5 * side.clamp(0.0, 1000.0);
        if !(centre.x.is_finite() && centre.y.is_finite()) {
            return;
        }
        // How much of the pixel around `at` lies within `half` of `middle`, in one direction.
        let inside = |at: f32, middle: f32, half: f32| (half + 0.5 - (at - middle).abs()).clamp(0.0, 1.0);
        for y in covered(centre.y - half - 0.5, centre.y + half + 0.5, self.height) {
            for x in covered(centre.x - half - 0.5, centre.x + half + 0.5, self.width) {
                let (at_x, at_y) = (x as f32 + 0.5, y as f32 + 0.5);
                let outer = inside(at_x, centre.x, half) * inside(at_y, centre.y, half);
                let inner = inside(at_x, centre.x, half - 1.0) * inside(at_y, centre.y, half - 1.0);
                self.blend(x, y, centre.nearness, border.mix(fill, inner), outer);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn its_centre_is_where_it_was_put(x in 10.0f32..54.0, y in 10.0f32..54.0, side in 3.0f32..12.0) {
            let mut canvas = Canvas::new(64, 64);
            canvas.square(Spot { x, y, nearness: 1.0 }, side, Color::WHITE, Color::WHITE);
            let (mut sum, mut at_x, mut at_y) = (0.0, 0.0, 0.0);
            for (index, pixel) in canvas.pixels().iter().enumerate() {
                let light = (pixel & 0xFF) as f32 / 255.0;
                sum += light;
                at_x += light * ((index % 64) as f32 + 0.5);
                at_y += light * ((index / 64) as f32 + 0.5);
            }
            prop_assert!((sum / (side * side) - 1.0).abs() < 0.05, "its area is {sum}");
            prop_assert!((at_x / sum - x).abs() < 0.1 && (at_y / sum - y).abs() < 0.1);
        }

        #[test]
        fn no_numbers_make_it_panic(raw in any::<[f32; 4]>()) {
            let mut canvas = Canvas::new(33, 17);
            canvas.square(Spot { x: raw[0], y: raw[1], nearness: raw[2] }, raw[3], Color::WHITE, Color::BLACK);
        }
    }
}
