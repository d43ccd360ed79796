//! From lit capsules to pixels: a ray through each pixel meets the capsule exactly, and silhouettes are anti-aliased by
//! how far the ray passes inside or outside of them.

use super::capsule::Capsule;
use super::light::LightMaps;
use super::shade::{Rays, Shader, Tones};
use super::shape::{Body, Hit, Row};
use crate::camera::View;
use crate::draw::canvas::{Canvas, Color};

/// The most pixels between two for which light is calculated, and how many of them lie on a capsule's radius.
const MOST_APART: f32 = 12.0;
const ON_RADIUS: f32 = 8.0;

/// Room for silhouettes at first, in widths and heights of the picture: more than a body has.
const ROOM_FOR_EDGES: usize = 16;

/// Balls of two bones at one joint may be the same: the second must be nearer by this, in depths, to be seen.
const CLEARLY: f32 = 1e-4;

/// Surfaces that come nearer to each other by less than this from pixel to pixel touch rather than cross, and those that
/// do by more have nothing to do with each other.
const TOUCHING: f32 = 3e-4;
const APART: f32 = 0.02;

/// Draws capsules.
pub(super) struct Raster {
    tones: Tones,
    /// Capsules from near to far, each with its least depth.
    order: Vec<(f32, usize)>,
    scratch: Scratch,
}

/// Memory that is kept.
#[derive(Default)]
struct Scratch {
    /// The silhouettes of all capsules.
    edges: Vec<Edge>,
    /// Neighbouring pixels of a row.
    run: Vec<Hit>,
    /// How much nearer the body was in the row above than what was there, for each column.
    above: Vec<f32>,
}

/// A pixel that a capsule covers in part.
struct Edge {
    index: usize,
    nearness: f32,
    color: Color,
    share: f32,
}

impl Default for Raster {
    fn default() -> Raster {
        Raster { tones: Tones::new(), order: Vec::new(), scratch: Scratch::default() }
    }
}

impl Raster {
    /// Draws `capsules` where nothing nearer is in the way. `per_world` is how many units of theirs a unit of the
    /// world is.
    pub fn draw(
        &mut self,
        capsules: &[Capsule],
        light: &LightMaps,
        lens: &View,
        per_world: f32,
        canvas: &mut Canvas,
    ) {
        let depth = |capsule: &Capsule| {
            let ends = [capsule.from, capsule.to].map(|end| (end - lens.eye).dot(lens.forward));
            (ends[0].min(ends[1]) - capsule.radius).max(lens.near)
        };
        self.order.clear();
        self.order.extend(capsules.iter().enumerate().map(|(index, capsule)| (depth(capsule), index)));
        // Near ones first: what they hide need not be lit.
        self.order.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));

        let (width, height) = canvas.size();
        self.scratch.run.clear();
        self.scratch.run.reserve(width);
        self.scratch.above.clear();
        self.scratch.above.reserve(width);
        self.scratch.edges.clear();
        self.scratch.edges.reserve(ROOM_FOR_EDGES * (width + height));
        for &(depth, index) in &self.order {
            let capsule = &capsules[index];
            if let Some(body) = Body::new(capsule, lens) {
                let radius = capsule.radius * lens.focal / depth;
                let apart = (radius / ON_RADIUS).clamp(1.0, MOST_APART) as usize;
                let shader = Shader { light, net: light.net(index), tones: &self.tones, apart };
                fill(&body, &shader, lens, (per_world, depth), &mut self.scratch, canvas);
            }
        }
        // Edges are blended with what lies behind them: far ones first, when everything else is there.
        let (pixels, nearness) = canvas.layers();
        for edge in self.scratch.edges.iter_mut().rev() {
            if edge.nearness * (1.0 - CLEARLY) > nearness[edge.index] {
                pixels[edge.index] = Color(pixels[edge.index]).mix(edge.color, edge.share).0;
            } else {
                edge.share = 0.0;
            }
        }
        // Only then they hide what is behind them: of two edges at the same depth, both count.
        for edge in self.scratch.edges.iter().filter(|edge| edge.share > 0.5) {
            nearness[edge.index] = nearness[edge.index].max(edge.nearness);
        }
        // What thousands of thin bones take is not kept for a few.
        self.scratch.edges.clear();
        self.scratch.edges.shrink_to(width * height);
    }
}

/// Draws what `body` covers entirely, and notes its silhouette. No part of it is nearer than `depth`.
fn fill(
    body: &Body,
    shader: &Shader,
    lens: &View,
    (per_world, depth): (f32, f32),
    scratch: &mut Scratch,
    canvas: &mut Canvas,
) {
    let (width, height) = canvas.size();
    let (pixels, nearness) = canvas.layers();
    let Some(rows) = body.rows(height) else { return };
    let (per_pixel, nearest, world) = (1.0 / lens.focal, per_world / depth, 1.0 / per_world);
    scratch.above.clear();
    scratch.above.resize(width, f32::NAN);
    for y in rows {
        let Some(columns) = body.columns(y as f32 + 0.5, width) else { continue };
        let slope = (lens.centre.y - (y as f32 + 0.5)) * per_pixel;
        let start = 0.5 - lens.centre.x + columns.start as f32;
        let sight = lens.forward + lens.up * slope;
        let rays = Rays { start: sight + lens.right * (start * per_pixel), step: lens.right * per_pixel };
        let line = Row::new(body, sight, lens.right);
        let first = y * width + columns.start;
        let row = &mut pixels[first..first + columns.len()];
        scratch.run.clear();
        let mut before = f32::NAN;
        let aboves = &mut scratch.above[columns.clone()];
        let nears = &mut nearness[first..first + columns.len()];
        for (x, (near, above)) in nears.iter_mut().zip(aboves).enumerate() {
            let aside = (start + x as f32) * per_pixel;
            let hit = if *near < nearest { line.meet(body, aside, per_pixel) } else { None };
            // How much nearer it is than what is there, in depths of that.
            let ahead = hit.map_or(f32::NAN, |hit| 1.0 - hit.depth * (*near * world));
            let front = in_front(ahead, [before, *above]);
            (before, *above) = (ahead, ahead);
            if let Some(hit) = hit
                && hit.share >= 1.0
                && front >= 1.0
            {
                *near = per_world / hit.depth;
                scratch.run.push(hit);
                continue;
            }
            shader.paint(body, &scratch.run, &rays, x, row);
            scratch.run.clear();
            let Some(hit) = hit.filter(|_| front > 0.0) else { continue };
            let nearness = per_world / hit.depth;
            let color = shader.pixel(body, &hit, &rays, x);
            if hit.share >= 1.0 {
                row[x] = Color(row[x]).mix(color, front).0;
                *near = near.max(nearness);
            } else {
                scratch.edges.push(Edge { index: first + x, nearness, color, share: hit.share });
            }
        }
        shader.paint(body, &scratch.run, &rays, columns.len(), row);
    }
}

/// The share of a pixel in which a surface lies in front of another. `ahead` says how much nearer it is in the middle of
/// the pixel, and `beside` how much it is in the pixels to the left and above, if anything is there: where two bodies
/// cross, their border is smooth.
#[inline]
fn in_front(ahead: f32, beside: [f32; 2]) -> f32 {
    if ahead.abs() >= APART {
        return if ahead > 0.0 { 1.0 } else { 0.0 };
    }
    let mut slope = 0.0;
    for other in beside {
        let change = (ahead - other).abs();
        // Nothing there is not a number, which is not below anything.
        if change < APART {
            slope += change;
        }
    }
    match slope > TOUCHING {
        true => (0.5 + ahead / slope).clamp(0.0, 1.0),
        false if ahead > CLEARLY => 1.0,
        false => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn where_bodies_cross_their_border_is_smooth_and_where_they_touch_it_is_sharp() {
        // Crossing, by 0.001 from pixel to pixel: half of the pixel in the middle of the border, more in front of it.
        assert_eq!(in_front(0.0, [-0.001, f32::NAN]), 0.5);
        assert!((in_front(0.000_25, [-0.000_75, f32::NAN]) - 0.75).abs() < 0.01);
        assert_eq!((in_front(0.002, [0.001, 0.001]), in_front(-0.002, [-0.001, -0.001])), (1.0, 0.0));
        // The same ball twice, but for rounding: the first one stays.
        assert_eq!(in_front(1e-6, [-1e-6, 2e-6]), 0.0);
        // Far in front of something, of nothing, and far behind.
        let alone = [f32::NAN; 2];
        assert_eq!([0.5, 1.0, -0.5].map(|ahead| in_front(ahead, alone)), [1.0, 1.0, 0.0]);
        // A silhouette behind it is not a border.
        assert_eq!(in_front(0.03, [1.0, 1.0]), 1.0);
    }
}
