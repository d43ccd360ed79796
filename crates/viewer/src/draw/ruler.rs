//! A ruler in the picture: how long a length of the world is where the camera looks at.

use super::canvas::{Canvas, Typeface, Weight};
use super::colors::{INK, PAPER};
use super::usable_scale;
use crate::camera::{Camera, View};
use crate::scene::ScaleBar;

/// Lengths in pixels, for an ordinary display.
const TEXT_SIZE: f32 = 13.0;
const LONGEST: f32 = 180.0;
const SHORTEST: f32 = 8.0;

/// The share of the picture's width that the ruler never exceeds.
const SHARE: f32 = 1.0 / 3.0;

/// A length that makes a good ruler in a picture of `size` pixels: the largest of 1, 2 and 5 times a power of ten that
/// is not too long, in world units. `None` when there is no such number.
pub fn fitting_length(camera: &Camera, size: (usize, usize), text_scale: f32) -> Option<f32> {
    let per_pixel = camera.distance / camera.view(size).focal;
    let longest = (SHARE * size.0 as f32).min(LONGEST * usable_scale(text_scale)) * per_pixel;
    let power = 10f64.powf(f64::from(longest).log10().floor());
    let steps = [5.0, 2.0, 1.0].map(|digit| (digit * power) as f32);
    steps.into_iter().find(|length| *length <= longest && length.is_normal())
}

/// How long a length of the world is in the picture, in pixels, at the distance of the camera's target.
pub fn pixels(length: f32, camera: &Camera, view: &View) -> f32 {
    length * (view.focal / camera.distance)
}

/// Draws the ruler in the middle, above `bottom`, or farther to the left where that is not left of `right`. One that would be too
/// long or too short to see is left out.
pub(crate) fn draw(
    ruler: &ScaleBar,
    length: f32,
    scale: f32,
    (right, bottom): (i32, i32),
    typeface: &mut Typeface,
    canvas: &mut Canvas,
) {
    let width = canvas.size().0 as f32;
    let fits = length >= SHORTEST * scale && length <= SHARE * width;
    if !fits || bottom < (60.0 * scale) as i32 {
        return;
    }
    let pixels = |length: f32| ((length * scale).round() as i32).max(1);
    let (line, tick) = (pixels(2.0), pixels(9.0));
    let middle = (0.5 * (width - length)).min(right as f32 - length - 2.0 * tick as f32).max(tick as f32);
    let (left, length) = (middle.round() as i32, length.round() as i32);
    let foot = bottom - pixels(12.0);
    let bars = [
        ((left, foot - line), (length, line)),
        ((left, foot - tick), (line, tick)),
        ((left + length - line, foot - tick), (line, tick)),
    ];
    for (color, edge) in [(PAPER, pixels(1.0)), (INK, 0)] {
        for ((x, y), (width, height)) in bars {
            canvas.rectangle((x - edge, y - edge), (width + 2 * edge, height + 2 * edge), color, 1.0);
        }
    }
    let size = pixels(TEXT_SIZE).unsigned_abs();
    let text = typeface.width(&ruler.label, size, Weight::Regular) as i32;
    let place = (left + (length - text) / 2, foot - tick - pixels(2.0));
    for (right, down) in [(-1, 0), (1, 0), (0, -1), (0, 1)] {
        canvas.text(typeface, &ruler.label, (place.0 + right, place.1 + down), size, Weight::Regular, PAPER);
    }
    canvas.text(typeface, &ruler.label, place, size, Weight::Regular, INK);
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::draw::canvas::Color;

    proptest! {
        #[test]
        fn a_fitting_length_is_round_and_takes_at_most_a_third_of_the_picture(
            power in -12i32..12, part in 1.0f32..10.0, size in (100usize..3000, 100usize..2000),
        ) {
            let distance = part * 10f32.powi(power);
            let camera = Camera { distance, ..Camera::default() };
            let length = fitting_length(&camera, size, 1.0).unwrap();
            let long = pixels(length, &camera, &camera.view(size));
            prop_assert!(long <= size.0 as f32 / 3.0 + 0.01 && long > size.0.min(180) as f32 / 3.0 / 2.6);
            let digit = f64::from(length) / 10f64.powf((f64::from(length) * 1.0001).log10().floor());
            prop_assert!([1.0, 2.0, 5.0].iter().any(|round| (digit - round).abs() < 1e-3), "{length}");
        }

        #[test]
        fn no_numbers_make_it_panic(raw in any::<[f32; 3]>(), bottom in 0i32..300) {
            let camera = Camera { distance: raw[0], ..Camera::default() };
            fitting_length(&camera, (200, 100), raw[1]);
            let ruler = ScaleBar { length: raw[2], label: "1 m".into() };
            let mut canvas = Canvas::new(200, 100);
            let length = pixels(raw[2], &camera, &camera.view((200, 100)));
            draw(&ruler, length, 1.0, (200, bottom), &mut Typeface::without_letters(), &mut canvas);
        }
    }

    #[test]
    fn the_ruler_is_as_long_as_its_length_is_at_the_target() {
        let camera = Camera { distance: 10.0, ..Camera::default() };
        let size = (600, 400);
        let view = camera.view(size);
        let ruler = ScaleBar { length: 2.0, label: String::new() };
        let mut canvas = Canvas::new(600, 400);
        canvas.clear(Color::WHITE);
        draw(
            &ruler,
            pixels(2.0, &camera, &view),
            1.0,
            (600, 400),
            &mut Typeface::without_letters(),
            &mut canvas,
        );
        let dark = canvas.pixels().iter().enumerate().filter(|(_, pixel)| **pixel == INK.0);
        let columns: Vec<usize> = dark.map(|(index, _)| index % 600).collect();
        let long = (columns.iter().max().unwrap() + 1 - columns.iter().min().unwrap()) as f32;
        let ends = [-1.0, 1.0].map(|aside| view.project(camera.target + view.right * aside).unwrap().x);
        assert!((long - (ends[1] - ends[0])).abs() <= 1.0, "{long} {ends:?}");
    }

    #[test]
    fn the_ruler_gives_way_to_what_stands_on_the_right() {
        let camera = Camera { distance: 10.0, ..Camera::default() };
        let ruler = ScaleBar { length: 2.0, label: String::new() };
        let last = |right: i32| {
            let mut canvas = Canvas::new(600, 400);
            canvas.clear(Color::WHITE);
            let long = pixels(2.0, &camera, &camera.view((600, 400)));
            draw(&ruler, long, 1.0, (right, 400), &mut Typeface::without_letters(), &mut canvas);
            let dark = canvas.pixels().iter().enumerate().filter(|(_, pixel)| **pixel == INK.0);
            dark.map(|(index, _)| index % 600).max().unwrap()
        };
        assert_eq!(last(600), last(500), "there is room in the middle");
        assert!(last(350) < 350 && last(350) < last(600));
    }
}
