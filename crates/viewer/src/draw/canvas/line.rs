//! Lines with round ends, anti-aliased and tested against the depth.

use glam::Vec2;

use super::{Canvas, Color, covered};
use crate::camera::Spot;

/// How a line is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pen {
    /// In pixels.
    pub width: f32,
    /// The colour.
    pub color: Color,
    /// From 0, invisible, to 1, opaque.
    pub opacity: f32,
}

impl Canvas {
    /// Draws the line from `from` to `to`, with round ends, where nothing nearer is in the way. Both may be anywhere.
    pub fn line(&mut self, from: Spot, to: Spot, pen: Pen) {
        self.stroke::<true>(from, to, pen);
    }

    /// The same with straight ends: each pixel belongs to at most one of two pieces that go on in a straight line, so
    /// that a translucent line can be drawn in pieces.
    pub fn piece(&mut self, from: Spot, to: Spot, pen: Pen) {
        self.stroke::<false>(from, to, pen);
    }

    fn stroke<const ROUND: bool>(&mut self, from: Spot, to: Spot, pen: Pen) {
        let reach = 0.5 * pen.width.clamp(0.0, 1000.0) + 0.5;
        let Some((from, to)) = self.clip(from, to, reach) else { return };
        let (start, along) = (Vec2::new(from.x, from.y), Vec2::new(to.x - from.x, to.y - from.y));
        let length_squared = along.length_squared();
        let per_length = if length_squared > 0.0 { along / length_squared } else { Vec2::ZERO };
        let most = pen.opacity * pen.width.min(1.0);

        for y in covered(from.y.min(to.y) - reach, from.y.max(to.y) + reach, self.height) {
            let centre_y = y as f32 + 0.5;
            // The part of the line that can touch this row, as shares of its length.
            let share = |edge: f32| ((edge - from.y) / along.y).clamp(0.0, 1.0);
            let (first, last) = match along.y.abs() < 1e-3 {
                true => (0.0, 1.0),
                false => (share(centre_y - reach), share(centre_y + reach)),
            };
            let (left, right) = (from.x + first * along.x, from.x + last * along.x);
            for x in covered(left.min(right) - reach, left.max(right) + reach, self.width) {
                let to_pixel = Vec2::new(x as f32 + 0.5, centre_y) - start;
                let share = to_pixel.dot(per_length);
                if !ROUND && !(0.0..1.0).contains(&share) {
                    continue;
                }
                let share = share.clamp(0.0, 1.0);
                let coverage = reach - to_pixel.distance(along * share);
                if coverage > 0.0 {
                    let nearness = from.nearness + share * (to.nearness - from.nearness);
                    self.blend(x, y, nearness, pen.color, coverage.min(1.0) * most);
                }
            }
        }
    }

    /// The part of the line that is inside the picture or less than `reach` pixels outside (Liang and Barsky, 1984).
    /// In double precision: the ends may be very far away.
    fn clip(&self, from: Spot, to: Spot, reach: f32) -> Option<(Spot, Spot)> {
        let (mut first, mut last) = (0.0f64, 1.0f64);
        for (start, end, length) in [(from.x, to.x, self.width), (from.y, to.y, self.height)] {
            let (start, along) = (f64::from(start), f64::from(end) - f64::from(start));
            let (low, high) = (-f64::from(reach) - start, length as f64 + f64::from(reach) - start);
            if along == 0.0 {
                if !(low <= 0.0 && 0.0 <= high) {
                    return None;
                }
            } else {
                let (a, b) = (low / along, high / along);
                first = first.max(a.min(b));
                last = last.min(a.max(b));
            }
        }
        let numbers = [from.x, from.y, from.nearness, to.x, to.y, to.nearness];
        if first > last || !numbers.iter().all(|number| number.is_finite()) {
            return None;
        }
        let between = |start: f32, end: f32, share: f64| {
            (f64::from(start) * (1.0 - share) + f64::from(end) * share) as f32
        };
        let at = |share: f64| Spot {
            x: between(from.x, to.x, share),
            y: between(from.y, to.y, share),
            nearness: between(from.nearness, to.nearness, share),
        };
        Some((at(first), at(last)))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    const RED: Pen = Pen { width: 3.0, color: Color(0xFF_00_00), opacity: 1.0 };
    const BLUE: Pen = Pen { width: 3.0, color: Color(0x00_00_FF), opacity: 1.0 };

    fn spot(x: f32, y: f32, nearness: f32) -> Spot {
        Spot { x, y, nearness }
    }

    #[test]
    fn a_near_line_hides_a_far_one_whatever_comes_first() {
        let near = (spot(0.0, 10.0, 1.0), spot(20.0, 10.0, 1.0), RED);
        let far = (spot(10.0, 0.0, 0.5), spot(10.0, 20.0, 0.5), BLUE);
        for order in [[near, far], [far, near]] {
            let mut canvas = Canvas::new(20, 20);
            for (from, to, pen) in order {
                canvas.line(from, to, pen);
            }
            assert_eq!(canvas.pixel(10, 10), Some(RED.color));
            assert_eq!(canvas.pixel(10, 2), Some(BLUE.color));
        }
    }

    #[test]
    fn two_lines_that_pass_through_each_other_change_places_in_the_middle() {
        let mut canvas = Canvas::new(41, 5);
        canvas.line(spot(0.0, 2.5, 1.0), spot(41.0, 2.5, 0.5), RED);
        canvas.line(spot(0.0, 2.5, 0.5), spot(41.0, 2.5, 1.0), BLUE);
        assert_eq!(canvas.pixel(5, 2), Some(RED.color));
        assert_eq!(canvas.pixel(35, 2), Some(BLUE.color));
    }

    #[test]
    fn a_line_is_as_dark_as_it_is_wide() {
        for (from, to) in [
            (spot(10.3, 50.2, 1.0), spot(90.6, 50.2, 1.0)),
            (spot(50.7, 10.4, 1.0), spot(50.7, 90.1, 1.0)),
            (spot(10.0, 20.0, 1.0), spot(90.0, 70.0, 1.0)),
            (spot(80.0, 20.5, 1.0), spot(20.0, 80.5, 1.0)),
        ] {
            let mut canvas = Canvas::new(100, 100);
            canvas.line(from, to, Pen { width: 2.0, color: Color::WHITE, opacity: 1.0 });
            let light: f32 = canvas.pixels().iter().map(|p| (p & 0xFF) as f32 / 255.0).sum();
            let length = Vec2::new(from.x - to.x, from.y - to.y).length();
            let expected = 2.0 * length + std::f32::consts::PI;
            assert!((light / expected - 1.0).abs() < 0.04, "{light} instead of {expected}");
        }
    }

    proptest! {
        #[test]
        fn no_numbers_make_it_panic(raw in any::<[f32; 6]>(), width in any::<f32>(), opacity in any::<f32>()) {
            let mut canvas = Canvas::new(33, 17);
            let pen = Pen { width, color: Color::WHITE, opacity };
            canvas.line(spot(raw[0], raw[1], raw[2]), spot(raw[3], raw[4], raw[5]), pen);
        }

        #[test]
        fn what_is_cut_off_outside_does_not_change_what_is_inside(
            a in (-300.0f32..400.0, -300.0f32..400.0),
            b in (-300.0f32..400.0, -300.0f32..400.0),
        ) {
            let mut small = Canvas::new(64, 64);
            let mut large = Canvas::new(1000, 1000);
            small.line(spot(a.0, a.1, 1.0), spot(b.0, b.1, 1.0), RED);
            large.line(spot(a.0 + 400.0, a.1 + 400.0, 1.0), spot(b.0 + 400.0, b.1 + 400.0, 1.0), RED);
            for y in 0..64 {
                for x in 0..64 {
                    let [one, two] = [small.pixel(x, y), large.pixel(x + 400, y + 400)].map(|p| p.unwrap().channels()[0]);
                    prop_assert!(one.abs_diff(two) <= 2, "({x}, {y}): {one} and {two}");
                }
            }
        }
    }
}
