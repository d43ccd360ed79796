//! From lit capsules to pixels: a ray through each pixel meets the capsule exactly, and silhouettes are anti-aliased by
//! how far the ray passes inside or outside of them.

use super::capsule::Capsule;
use super::light::LightMaps;
use super::shade::{Rays, Shader, Tones};
use super::shape::{Body, Hit, Row};
use crate::camera::View;
use crate::canvas::{Canvas, Color};

/// The most pixels between two for which light is calculated, and how many of them lie on a capsule's radius.
const MOST_APART: f32 = 10.0;
const ON_RADIUS: f32 = 10.0;

/// Room for silhouettes, in widths and heights of the picture: more than a body has.
const ROOM_FOR_EDGES: usize = 16;

/// Balls of two bones at one joint may be the same: the second must be nearer by more than rounding to be seen.
const CLEARLY: f32 = 1.0 - 1e-4;

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
        for edge in self.scratch.edges.iter().rev() {
            if edge.nearness * CLEARLY > nearness[edge.index] {
                pixels[edge.index] = Color(pixels[edge.index]).mix(edge.color, edge.share).0;
                if edge.share > 0.5 {
                    nearness[edge.index] = edge.nearness;
                }
            }
        }
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
    let (per_pixel, nearest) = (1.0 / lens.focal, per_world / depth);
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
        for (x, near) in nearness[first..first + columns.len()].iter_mut().enumerate() {
            let aside = (start + x as f32) * per_pixel;
            let hit = if *near < nearest { line.meet(body, aside, per_pixel) } else { None };
            match hit.filter(|hit| hit.depth * *near < per_world * CLEARLY) {
                Some(hit) if hit.share >= 1.0 => {
                    *near = per_world / hit.depth;
                    scratch.run.push(hit);
                }
                partial => {
                    shader.paint(body, &scratch.run, &rays, x, row);
                    scratch.run.clear();
                    if let Some(hit) = partial {
                        let color = shader.pixel(body, &hit, &rays, x);
                        let nearness = per_world / hit.depth;
                        scratch.edges.push(Edge { index: first + x, nearness, color, share: hit.share });
                    }
                }
            }
        }
        shader.paint(body, &scratch.run, &rays, columns.len(), row);
    }
}
