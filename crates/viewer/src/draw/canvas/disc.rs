//! Discs on top of everything.

use super::{Canvas, Color, covered};

impl Canvas {
    /// Lays a disc over everything; its centre and radius in pixels.
    pub fn disc(&mut self, (centre_x, centre_y): (f32, f32), radius: f32, color: Color) {
        let radius = radius.clamp(0.0, 1000.0);
        if !(centre_x.is_finite() && centre_y.is_finite()) {
            return;
        }
        let reach = radius + 0.5;
        for y in covered(centre_y - reach, centre_y + reach, self.height) {
            for x in covered(centre_x - reach, centre_x + reach, self.width) {
                let away = (x as f32 + 0.5 - centre_x).hypot(y as f32 + 0.5 - centre_y);
                let pixel = &mut self.pixels[y * self.width + x];
                *pixel = Color(*pixel).mix(color, (reach - away).clamp(0.0, 1.0)).0;
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
        fn it_covers_its_area(x in 20.0f32..44.0, y in 20.0f32..44.0, radius in 2.0f32..15.0) {
            let mut canvas = Canvas::new(64, 64);
            canvas.disc((x, y), radius, Color::WHITE);
            let light: f32 = canvas.pixels().iter().map(|pixel| (pixel & 0xFF) as f32 / 255.0).sum();
            let area = std::f32::consts::PI * radius * radius;
            prop_assert!((light / area - 1.0).abs() < 0.05, "{light} instead of {area}");
        }

        #[test]
        fn no_numbers_make_it_panic(raw in any::<[f32; 3]>()) {
            Canvas::new(33, 17).disc((raw[0], raw[1]), raw[2], Color::WHITE);
        }
    }
}
