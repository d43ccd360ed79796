//! The shadow that all bodies cast on the ground, and the shade close to them.

use glam::{Vec2, Vec3, Vec3Swizzles};

use super::capsule::{Capsule, Footprint};
use crate::camera::View;
use crate::draw::canvas::{Canvas, haze};

/// The most cells along a side of the map: shadows are soft, a coarse map is enough.
const MOST_CELLS: usize = 224;

/// With many bodies the map gets coarser, so that all of them together look at no more than about this many cells; but
/// never coarser than this.
const MOST_LOOKS: f32 = 4e6;
const FEWEST_CELLS: usize = 48;

/// The least size of a cell, in sizes of the figure.
const SMALLEST_CELL: f32 = 0.0035;

/// Shadows farther than this from what the camera looks at, in sizes of the figure, are left out.
const REACH: f32 = 4.0;

/// The least width of a shadow's edge, in sizes of the figure.
const BLUR: f32 = 0.003;

/// The light that is left where the sun is covered, and where the sky is.
const WITHOUT_SUN: f32 = 0.46;
const WITHOUT_SKY: f32 = 0.25;

/// A map of a part of the ground. Each cell knows which share of the sun, and of all light, arrives there.
#[derive(Default)]
pub(super) struct GroundShadow {
    floor: f32,
    /// The corner of the first cell, and the size of a cell.
    corner: Vec2,
    cell: f32,
    columns: usize,
    rows: usize,
    sun: Vec<f32>,
    light: Vec<f32>,
}

impl GroundShadow {
    /// Lets `capsules` cast their shadows on the plane at height `floor`.
    pub fn cast(&mut self, capsules: &[Capsule], floor: f32, lens: &View, size: (usize, usize)) {
        (self.floor, self.columns, self.rows) = (floor, 0, 0);
        let area = area(capsules, floor);
        if area.is_empty() {
            return;
        }
        // No finer than can be seen.
        let depth = (lens.eye - Vec3::new(0.0, floor, 0.0)).length();
        let pixel = depth / lens.focal;
        let side = (area.high - area.low).max_element();
        let affordable = (MOST_LOOKS / capsules.len() as f32).sqrt() as usize;
        let most = MOST_CELLS.min(size.0.max(size.1)).min(affordable.max(FEWEST_CELLS));
        self.cell = (side / most as f32).max(SMALLEST_CELL).max(0.5 * pixel);
        self.corner = area.low - self.cell;
        let cells = ((area.high - area.low) / self.cell).ceil() + 2.0;
        (self.columns, self.rows) =
            ((cells.x as usize).min(MOST_CELLS + 3), (cells.y as usize).min(MOST_CELLS + 3));
        for map in [&mut self.sun, &mut self.light] {
            map.clear();
            map.reserve((MOST_CELLS + 3) * (MOST_CELLS + 3));
            map.resize(self.columns * self.rows, 1.0);
        }
        for capsule in capsules {
            if let Some(footprint) = capsule.shadow(floor) {
                self.each(footprint, |point, sun, _| *sun = sun.min(capsule.sun_share(point, BLUR)));
            }
            if let Some(footprint) = capsule.contact(floor) {
                self.each(footprint, |point, _, light| *light *= 1.0 - 0.8 * capsule.contact_share(point));
            }
        }
        for (light, sun) in self.light.iter_mut().zip(&self.sun) {
            *light = (WITHOUT_SUN + (1.0 - WITHOUT_SUN) * sun) * (WITHOUT_SKY + (1.0 - WITHOUT_SKY) * *light);
        }
    }

    /// Changes the cells of the map in `footprint`.
    fn each(&mut self, footprint: Footprint, mut change: impl FnMut(Vec3, &mut f32, &mut f32)) {
        let low = ((footprint.low - self.corner) / self.cell).floor().max(Vec2::ZERO);
        let high = ((footprint.high - self.corner) / self.cell).ceil().max(Vec2::ZERO);
        let (left, right) = ((low.x as usize).min(self.columns), (high.x as usize).min(self.columns));
        for row in low.y as usize..(high.y as usize).min(self.rows) {
            let z = self.corner.y + (row as f32 + 0.5) * self.cell;
            let cells = row * self.columns..(row + 1) * self.columns;
            let (sun, light) = (&mut self.sun[cells.clone()], &mut self.light[cells]);
            for column in left..right {
                let x = self.corner.x + (column as f32 + 0.5) * self.cell;
                change(Vec3::new(x, self.floor, z), &mut sun[column], &mut light[column]);
            }
        }
    }

    /// The height of the ground.
    pub fn floor(&self) -> f32 {
        self.floor
    }

    /// The share of the sun that arrives on the ground below `place`.
    pub fn sun_below(&self, place: Vec3) -> f32 {
        self.look_up(&self.sun, place.xz())
    }

    /// Looks up `map` between the four nearest cells; 1 outside of it.
    fn look_up(&self, map: &[f32], place: Vec2) -> f32 {
        let at = (place - self.corner) / self.cell - 0.5;
        let inside = |at: f32, count: usize| at >= 0.0 && at + 1.0 < count as f32;
        if !(inside(at.x, self.columns) && inside(at.y, self.rows)) {
            return 1.0;
        }
        let (column, row) = (at.x as usize, at.y as usize);
        let (right, down) = (at.x - column as f32, at.y - row as f32);
        let first = row * self.columns + column;
        let Some(cells) = map.get(first..first + self.columns + 2) else { return 1.0 };
        let upper = cells[0] + (cells[1] - cells[0]) * right;
        let lower = cells[self.columns] + (cells[self.columns + 1] - cells[self.columns]) * right;
        upper + (lower - upper) * down
    }

    /// Darkens the ground in the picture, less where it has faded at `reach`.
    pub fn darken(&self, lens: &View, reach: f32, canvas: &mut Canvas) {
        if self.columns < 2 || self.rows < 2 {
            return;
        }
        let (width, _) = canvas.size();
        let low = self.corner + 0.5 * self.cell;
        let high = self.corner + (Vec2::new(self.columns as f32, self.rows as f32) - 1.5) * self.cell;
        let (pixels, _) = canvas.layers();
        for (y, row) in pixels.chunks_exact_mut(width).enumerate() {
            let slope = (lens.centre.y - (y as f32 + 0.5)) / lens.focal;
            let sight = lens.forward + lens.up * slope;
            let depth = (self.floor - lens.eye.y) / sight.y;
            if !(depth > 0.0 && depth.is_finite()) {
                continue;
            }
            // The place on the ground moves evenly along the row: the part of the row inside the map is a single one.
            let step = lens.right.xz() * (depth / lens.focal);
            let start = (lens.eye + sight * depth).xz() - step * (lens.centre.x - 0.5);
            let (mut first, mut last) = (0.0f32, width as f32);
            for axis in [0, 1] {
                let [enter, leave] =
                    [low[axis], high[axis]].map(|border| (border - start[axis]) / step[axis]);
                if step[axis].abs() > 1e-9 {
                    (first, last) = (first.max(enter.min(leave)), last.min(enter.max(leave)));
                } else if !(low[axis]..high[axis]).contains(&start[axis]) {
                    last = 0.0;
                }
            }
            let strength = 1.0 - haze(depth, reach);
            let first = (first.ceil() as usize).min(width);
            let last = (last.max(0.0) as usize).clamp(first, width);
            for (x, pixel) in (first..last).zip(&mut row[first..last]) {
                let light = self.look_up(&self.light, start + step * x as f32);
                if light < 0.998 {
                    *pixel = darker(*pixel, 1.0 - (1.0 - light) * strength);
                }
            }
        }
    }
}

/// The part of the ground on which anything falls.
fn area(capsules: &[Capsule], floor: f32) -> Footprint {
    let mut all = Footprint::NOTHING;
    for capsule in capsules {
        for footprint in [capsule.shadow(floor), capsule.contact(floor)].into_iter().flatten() {
            all.low = all.low.min(footprint.low);
            all.high = all.high.max(footprint.high);
        }
    }
    all.within(Footprint { low: Vec2::splat(-REACH), high: Vec2::splat(REACH) })
}

/// `pixel` in `light` from 0 to 1. What is left of it is a little blue: the sky's.
fn darker(pixel: u32, light: f32) -> u32 {
    let light = (light * 256.0) as u32;
    let blue = light + (256 - light.min(256)) / 9;
    let red_green = [16, 8].map(|shift| ((((pixel >> shift) & 0xFF) * light) >> 8) << shift);
    red_green[0] | red_green[1] | (((pixel & 0xFF) * blue) >> 8)
}
