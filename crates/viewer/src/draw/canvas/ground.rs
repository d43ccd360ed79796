//! The background: the sky, and a grid on the ground that fades towards the horizon.

use super::{Canvas, Color};
use crate::camera::View;

/// A level plane with a grid of squares.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Ground {
    /// Its height: the world's Y, in world units.
    pub height: f32,
    /// The side of a square, in world units. Every fifth line is stronger.
    pub cell: f32,
}

/// How many cells lie between two strong lines.
const STRONG: f32 = 5.0;

/// Widths of the lines, in cells.
const LINE_WIDTH: f32 = 0.022;
const STRONG_LINE_WIDTH: f32 = 0.05;

const ZENITH: Color = Color(0xC3_CF_DD);
const HORIZON: Color = Color(0xDF_E4_E8);
const PLANE: Color = Color(0xD6_D9_DB);
const LINE: Color = Color(0xAE_B5_BE);
const STRONG_LINE: Color = Color(0x84_8D_99);

impl Canvas {
    /// Fills the whole picture with sky and ground, infinitely far. `reach` is the distance, in world units, at which
    /// a good part of the ground has faded away.
    pub fn background(&mut self, view: &View, ground: Ground, reach: f32) {
        self.nearness.fill(0.0);
        for (y, row) in self.pixels.chunks_exact_mut(self.width).enumerate() {
            let slope = (view.centre.y - (y as f32 + 0.5)) / view.focal;
            let sight = view.forward + view.up * slope;
            // The camera does not roll: a row of the picture meets the ground at one depth.
            let depth = (ground.height - view.eye.y) / sight.y;
            if !(depth > 0.0 && depth.is_finite() && ground.cell > 0.0) {
                row.fill(HORIZON.mix(ZENITH, 1.6 * sight.y.abs()).0);
                continue;
            }
            // Along the row, and from this row to the next, the point on the ground moves by these steps.
            let along = view.right * (depth / view.focal);
            let across = (view.up - sight * (view.up.y / sight.y)) * (depth / view.focal);
            let start = sight - view.right * ((view.centre.x - 0.5) / view.focal);
            let lines = [
                GridLines::new(view.eye.x, depth * start.x, along.x, across.x, ground.cell),
                GridLines::new(view.eye.z, depth * start.z, along.z, across.z, ground.cell),
            ];
            let colors = RowColors::new(haze(depth, reach));
            let is_even =
                |shade: fn(&GridLines) -> LineShade| lines.iter().all(|lines| shade(lines).is_even());
            match (is_even(|lines| lines.weak), is_even(|lines| lines.strong)) {
                (true, true) => row.fill(colors.at(lines[0].weak.low, lines[0].strong.low)),
                (true, false) => fill_row::<false>(row, 0, &lines, &colors),
                _ if lines.iter().map(|lines| lines.work(row.len())).sum::<f32>()
                    < 0.5 * row.len() as f32 =>
                {
                    fill_sparse_row(row, &lines, &colors);
                }
                _ => fill_row::<true>(row, 0, &lines, &colors),
            }
        }
    }
}

/// How much of the ground has faded at a depth: 0 to 1.
pub(crate) fn haze(depth: f32, reach: f32) -> f32 {
    1.0 - (-(depth / reach).powi(2)).exp()
}

/// Shades a row in which lines are far apart: only the pixels close to them, in front of the plain ground.
fn fill_sparse_row(row: &mut [u32], lines: &[GridLines; 2], colors: &RowColors) {
    row.fill(colors.at(0.0, 0.0));
    let width = row.len() as f32;
    for direction in lines {
        let ends = [direction.start, direction.start + direction.step * width].map(nearest_whole);
        let (first, last) = (ends[0].min(ends[1]) as i32, ends[0].max(ends[1]) as i32);
        for line in first..=last {
            let middle = (line as f32 - direction.start) / direction.step;
            let from = (middle - direction.half).floor().clamp(0.0, width) as usize;
            let to = (middle + direction.half).ceil().clamp(0.0, width) as usize;
            fill_row::<true>(&mut row[from..to], from, lines, colors);
        }
    }
}

/// Shades a part of a row of the ground that begins with pixel `from`. Without `WEAK`, the weak lines are no longer told apart. This is done for most pixels
/// of every picture: no branch and no call is in the loop, so that the compiler does many pixels at once.
fn fill_row<const WEAK: bool>(
    row: &mut [u32],
    from: usize,
    [x_lines, z_lines]: &[GridLines; 2],
    colors: &RowColors,
) {
    let even = larger(x_lines.weak.low, z_lines.weak.low);
    for (x, pixel) in (from as i32..).zip(row) {
        let x = x as f32;
        let at_x = x_lines.start + x_lines.step * x;
        let at_z = z_lines.start + z_lines.step * x;
        let weak = if WEAK { larger(x_lines.weak.at(at_x), z_lines.weak.at(at_z)) } else { even };
        let strong =
            larger(x_lines.strong.at(at_x * (1.0 / STRONG)), z_lines.strong.at(at_z * (1.0 / STRONG)));
        *pixel = colors.at(weak, strong);
    }
}

/// The colours of a row, each as red, green and blue from 0 to 255.
struct RowColors {
    plane: [f32; 3],
    /// What lines add to the plane.
    weak: [f32; 3],
    strong: [f32; 3],
}

impl RowColors {
    fn new(haze: f32) -> RowColors {
        let [plane, line, strong] =
            [PLANE, LINE, STRONG_LINE].map(|color| color.mix(HORIZON, haze).channels().map(f32::from));
        let over_plane = |color: [f32; 3]| [0, 1, 2].map(|channel| color[channel] - plane[channel]);
        RowColors { plane, weak: over_plane(line), strong: over_plane(strong) }
    }

    /// The colour of a pixel that is covered by weak and strong lines to these shares. Strong ones lie on top.
    fn at(&self, weak: f32, strong: f32) -> u32 {
        let weak = weak * (1.0 - strong);
        let shade = |channel: usize| {
            let value = self.plane[channel] + self.weak[channel] * weak + self.strong[channel] * strong;
            // Beside 2²³ a float's last eight bits are its whole number; shifting drops those before them.
            (value + 8_388_608.0).to_bits()
        };
        (shade(0) << 16) | (shade(1) << 8) | (shade(2) & 0xFF)
    }
}

/// The grid lines that lie across one world axis, seen along one row of the picture. Lengths are in cells.
#[derive(Clone, Copy)]
struct GridLines {
    start: f32,
    step: f32,
    /// How many pixels of the row a line covers on each side of its middle, at most.
    half: f32,
    weak: LineShade,
    strong: LineShade,
}

impl GridLines {
    fn new(eye: f32, start: f32, step: f32, across: f32, cell: f32) -> GridLines {
        // In double precision and within one strong square: the eye may be far from the origin.
        let start = ((f64::from(eye) + f64::from(start)) / f64::from(cell)).rem_euclid(f64::from(STRONG));
        // How much of the axis one pixel covers.
        let footprint = (step.abs() + across.abs()) / cell;
        GridLines {
            start: start as f32,
            step: step / cell,
            half: 0.5 * (STRONG_LINE_WIDTH + footprint) * (cell / step.abs()) + 1.0,
            weak: LineShade::new(footprint, LINE_WIDTH),
            strong: LineShade::new(footprint / STRONG, STRONG_LINE_WIDTH / STRONG),
        }
    }

    /// The work of shading only the pixels close to lines in a row of `width` pixels, in pixels of [`fill_row`] at its
    /// full speed; endless where there are no gaps between the lines.
    fn work(&self, width: usize) -> f32 {
        const SHORT_SPAN: f32 = 16.0;
        let count = self.step.abs() * width as f32 + 1.0;
        let is_apart = self.weak.low == 0.0 && self.strong.low == 0.0;
        if is_apart { count * (2.0 * self.half + SHORT_SPAN) } else { f32::INFINITY }
    }
}

/// How much of a pixel is covered by lines at all whole numbers. What is the same along a row is calculated once.
#[derive(Clone, Copy)]
struct LineShade {
    per_length: f32,
    middle: f32,
    low: f32,
    high: f32,
}

impl LineShade {
    /// For pixels that cover `footprint`, and lines of this width.
    fn new(footprint: f32, width: f32) -> LineShade {
        let footprint = footprint.max(1e-4);
        // Where a pixel covers a whole cell, lines can no longer be told apart: only their average shade is left.
        let blur = (2.0 * footprint - 0.6).clamp(0.0, 1.0);
        let (sharp, low) = (1.0 - blur, blur * width);
        LineShade {
            per_length: sharp / footprint,
            middle: sharp * 0.5 * (width + footprint) / footprint + low,
            low,
            high: sharp * (width / footprint).min(1.0) + low,
        }
    }

    /// Whether all pixels are covered alike.
    fn is_even(self) -> bool {
        self.low == self.high
    }

    fn at(self, at: f32) -> f32 {
        let away = (at - nearest_whole(at)).abs();
        let covered = larger(self.middle - away * self.per_length, self.low);
        if covered < self.high { covered } else { self.high }
    }
}

/// The larger of two numbers. Unlike `f32::max` it is one instruction, because it does not care for NaN.
fn larger(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

/// The nearest whole number, for numbers below four million: beside 1.5 · 2²³ a float has no room for fractions.
/// `f32::round` is a call into a library on many machines.
fn nearest_whole(number: f32) -> f32 {
    const NO_FRACTIONS: f32 = 12_582_912.0;
    (number + NO_FRACTIONS) - NO_FRACTIONS
}

#[cfg(test)]
mod tests {
    use glam::Vec3;
    use proptest::prelude::*;

    use super::*;
    use crate::camera::Camera;

    fn picture(camera: Camera, ground: Ground) -> Canvas {
        let mut canvas = Canvas::new(64, 48);
        canvas.background(&camera.view((64, 48)), ground, 4.0 * camera.distance);
        canvas
    }

    #[test]
    fn the_average_shade_of_the_lines_is_their_share_of_the_ground() {
        for footprint in [0.01, 0.1, 0.3, 0.7, 3.0] {
            let shade = LineShade::new(footprint, 0.05);
            let samples = (0..10_000).map(|i| shade.at(i as f32 * 1e-3));
            let average: f32 = samples.sum::<f32>() / 10_000.0;
            assert!((average - 0.05).abs() < 0.003, "{average} with a footprint of {footprint}");
        }
    }

    #[test]
    fn a_line_of_the_grid_is_where_the_projection_puts_it() {
        let camera = Camera { target: Vec3::ZERO, azimuth: 0.4, elevation: 0.6, distance: 8.0 };
        let view = camera.view((640, 480));
        let mut canvas = Canvas::new(640, 480);
        canvas.background(&view, Ground { height: 0.5, cell: 1.0 }, 1e6);
        let shade = |x: f32, z: f32| {
            let spot = view.project(Vec3::new(x, 0.5, z)).unwrap();
            canvas.pixel(spot.x as usize, spot.y as usize).unwrap().channels()[0]
        };
        for step in 0..9 {
            let along = -0.9 + 0.2 * step as f32;
            assert!(shade(0.0, along) < 0x90, "a strong line");
            assert!(shade(along, 1.0) < 0xC0, "a line");
            assert!(shade(0.5, 0.5) > 0xD0, "between the lines");
        }
    }

    #[test]
    fn there_is_sky_above_the_horizon_and_ground_below_it_also_when_seen_from_below() {
        let camera = Camera { target: Vec3::ZERO, azimuth: 0.0, elevation: 0.3, distance: 8.0 };
        let canvas = picture(Camera { elevation: 0.1, ..camera }, Ground { height: -1.0, cell: 1e6 });
        assert!(canvas.pixel(3, 3).unwrap().channels()[2] > canvas.pixel(3, 44).unwrap().channels()[2]);
        let canvas = picture(Camera { elevation: -0.1, ..camera }, Ground { height: 1.0, cell: 1e6 });
        assert!(canvas.pixel(3, 44).unwrap().channels()[2] > canvas.pixel(3, 3).unwrap().channels()[2]);
    }

    #[test]
    fn a_row_with_gaps_between_its_lines_is_shaded_as_any_other() {
        let mut sparse_rows = 0;
        for azimuth in [0.0f32, 0.01, 0.4, 0.8, 1.55, 3.0] {
            let view = Camera { target: Vec3::ZERO, azimuth, elevation: 0.5, distance: 9.0 }.view((640, 480));
            for y in (150..480).step_by(7) {
                let sight = view.forward + view.up * ((240.0 - y as f32) / view.focal);
                let depth = (-1.0 - view.eye.y) / sight.y;
                let along = view.right * (depth / view.focal);
                let across = (view.up - sight * (view.up.y / sight.y)) * (depth / view.focal);
                let start = sight - view.right * (319.5 / view.focal);
                let lines = [
                    GridLines::new(view.eye.x, depth * start.x, along.x, across.x, 1.0),
                    GridLines::new(view.eye.z, depth * start.z, along.z, across.z, 1.0),
                ];
                if !lines.iter().map(|lines| lines.work(640)).sum::<f32>().is_finite() {
                    continue;
                }
                sparse_rows += 1;
                let (mut sparse, mut full) = ([0; 640], [0; 640]);
                fill_sparse_row(&mut sparse, &lines, &RowColors::new(0.1));
                fill_row::<true>(&mut full, 0, &lines, &RowColors::new(0.1));
                assert!(sparse == full, "row {y} at {azimuth}");
            }
        }
        assert!(sparse_rows > 100);
    }

    proptest! {
        #[test]
        fn no_numbers_make_it_panic(raw in any::<[f32; 9]>()) {
            let target = Vec3::new(raw[0], raw[1], raw[2]);
            let camera = Camera { target, azimuth: raw[3], elevation: raw[4], distance: raw[5] };
            let mut canvas = Canvas::new(8, 8);
            canvas.background(&camera.view((8, 8)), Ground { height: raw[6], cell: raw[7] }, raw[8]);
        }
    }
}
