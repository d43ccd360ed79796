//! From lit capsules to pixels: a ray through each pixel meets the capsule exactly, and silhouettes are anti-aliased by
//! how far the ray passes inside or outside of them.

use glam::Vec3;

use super::SUN;
use super::capsule::Capsule;
use super::light::{LightMaps, Net};
use crate::camera::View;
use crate::canvas::{Canvas, Color};

/// The sun's light.
const SUNLIGHT: Vec3 = Vec3::new(1.55, 1.48, 1.32);

/// How strongly the surface shines where it mirrors the sun, and at its rims.
const SHINE: f32 = 0.16;
const RIM: Vec3 = Vec3::new(0.10, 0.13, 0.16);

/// What pale bodies are mixed with, and by how much.
const PALE: Color = Color(0xDD_E0_E3);
const PALENESS: f32 = 0.45;

/// Draws capsules.
pub(super) struct Raster {
    tones: Tones,
    /// Capsules from near to far, each with its least depth.
    order: Vec<(f32, usize)>,
    edges: Vec<Edge>,
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
        Raster { tones: Tones::new(), order: Vec::new(), edges: Vec::new() }
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
        let depth = |point: Vec3| (point - lens.eye).dot(lens.forward);
        self.order.clear();
        let nearest = |capsule: &Capsule| depth(capsule.from).min(depth(capsule.to)) - capsule.radius;
        self.order.extend(capsules.iter().enumerate().map(|(index, capsule)| (nearest(capsule), index)));
        // Near ones first: what they hide need not be lit.
        self.order.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));

        self.edges.clear();
        for &(_, index) in &self.order {
            if let Some(body) = Body::new(&capsules[index], lens) {
                let shader = Shader { light, net: light.net(index), tones: &self.tones };
                body.fill(&shader, lens, per_world, canvas, &mut self.edges);
            }
        }
        // Edges are blended with what lies behind them: far ones first, when everything else is there.
        let (pixels, nearness) = canvas.layers();
        for edge in self.edges.iter().rev() {
            if edge.nearness >= nearness[edge.index] {
                pixels[edge.index] = Color(pixels[edge.index]).mix(edge.color, edge.share).0;
                if edge.share > 0.5 {
                    nearness[edge.index] = edge.nearness;
                }
            }
        }
    }
}

/// A capsule as the camera sees it. The axis is measured from its point that is nearest to the eye: from there
/// everything stays exact, however far away its ends are.
struct Body<'a> {
    capsule: &'a Capsule,
    /// From the nearest point of the whole axis to the eye; at a right angle to the axis.
    to_eye: Vec3,
    /// Where the capsule starts and ends on its axis.
    start: f32,
    end: f32,
    /// Where it starts when nothing is cut off.
    own_start: f32,
    /// From its ends to the eye.
    from_start: Vec3,
    from_end: Vec3,
    /// The boxes around its two end balls in the picture.
    boxes: [Box; 2],
}

/// Left, top, right and bottom in pixels.
#[derive(Clone, Copy)]
struct Box {
    low: [f32; 2],
    high: [f32; 2],
}

impl<'a> Body<'a> {
    /// `None` when no part of the capsule is in front of the camera.
    fn new(capsule: &'a Capsule, lens: &View) -> Option<Body<'a>> {
        let seen = |point: Vec3| {
            let away = point - lens.eye;
            Vec3::new(away.dot(lens.right), away.dot(lens.up), away.dot(lens.forward))
        };
        let on_axis = (lens.eye - capsule.from).dot(capsule.axis);
        let (mut start, mut end) = (-on_axis, capsule.length - on_axis);
        let (mut from, mut to) = (seen(capsule.from), seen(capsule.to));
        // The camera never gets into a body: one that reaches into it is cut off in front of it.
        let limit = capsule.radius + lens.near;
        if from.z.max(to.z) < limit {
            return None;
        }
        if from.z < limit {
            let share = (limit - from.z) / (to.z - from.z);
            (from, start) = (from.lerp(to, share), start + share * (end - start));
        } else if to.z < limit {
            let share = (limit - to.z) / (from.z - to.z);
            (to, end) = (to.lerp(from, share), end + share * (start - end));
        }
        let to_eye = lens.eye - (capsule.from + capsule.axis * on_axis);
        Some(Body {
            capsule,
            to_eye,
            start,
            end,
            own_start: -on_axis,
            from_start: to_eye - capsule.axis * start,
            from_end: to_eye - capsule.axis * end,
            boxes: [from, to].map(|centre| Box::around(centre, capsule.radius, lens)),
        })
    }

    fn fill(&self, shader: &Shader, lens: &View, per_world: f32, canvas: &mut Canvas, edges: &mut Vec<Edge>) {
        let (width, height) = canvas.size();
        let (pixels, nearness) = canvas.layers();
        let Some(rows) = self.rows(height) else { return };
        let per_pixel = 1.0 / lens.focal;
        for y in rows {
            let Some(columns) = self.columns(y as f32 + 0.5, width) else { continue };
            let slope = (lens.centre.y - (y as f32 + 0.5)) * per_pixel;
            let sight = lens.forward + lens.up * slope;
            let line = Row::new(self, sight, lens.right);
            let first = y * width + columns.start;
            let count = columns.len();
            let row = pixels[first..first + count].iter_mut().zip(&mut nearness[first..first + count]);
            for ((x, index), (pixel, near)) in columns.zip(first..).zip(row) {
                let aside = (x as f32 + 0.5 - lens.centre.x) * per_pixel;
                let Some(hit) = line.meet(self, aside, per_pixel) else { continue };
                let now = per_world / hit.depth;
                if now <= *near {
                    continue;
                }
                let color = shader.color(self, &hit, sight + lens.right * aside);
                if hit.share >= 1.0 {
                    (*pixel, *near) = (color.0, now);
                } else {
                    edges.push(Edge { index, nearness: now, color, share: hit.share });
                }
            }
        }
    }

    /// The rows of the picture that it may touch.
    fn rows(&self, height: usize) -> Option<std::ops::Range<usize>> {
        let [a, b] = self.boxes;
        range(a.low[1].min(b.low[1]), a.high[1].max(b.high[1]), height)
    }

    /// The pixels of the row through `y` that it may touch. Its outline lies within all boxes between those around
    /// its ends.
    fn columns(&self, y: f32, width: usize) -> Option<std::ops::Range<usize>> {
        let [a, b] = self.boxes;
        let (mut first, mut last) = (0.0f32, 1.0f32);
        // The upper side of the box must be above the row, the lower side below it.
        for (start, end) in [(a.low[1] - y, b.low[1] - y), (y - a.high[1], y - b.high[1])] {
            let crossing = start / (start - end);
            match (start > 0.0, end > 0.0) {
                (true, true) => return None,
                (true, false) => first = first.max(crossing),
                (false, true) => last = last.min(crossing),
                (false, false) => {}
            }
        }
        let at = |share: f32, a: f32, b: f32| a + share * (b - a);
        let low = at(first, a.low[0], b.low[0]).min(at(last, a.low[0], b.low[0]));
        let high = at(first, a.high[0], b.high[0]).max(at(last, a.high[0], b.high[0]));
        range(low, high, width)
    }
}

/// The pixels between two places.
fn range(low: f32, high: f32, length: usize) -> Option<std::ops::Range<usize>> {
    let first = (low.floor().max(0.0) as usize).min(length);
    let last = (high.ceil().max(0.0) as usize).min(length);
    (first < last).then_some(first..last)
}

impl Box {
    /// Around a ball whose centre is at this place seen from the camera (right, up, forward).
    fn around(centre: Vec3, radius: f32, lens: &View) -> Box {
        // The slopes of the two lines of sight that touch the ball, in one direction across the picture.
        let touching = |aside: f32| {
            let away = (centre.z * centre.z - radius * radius).max(1e-12);
            let reach = radius * (aside * aside + away).sqrt();
            [(aside * centre.z - reach) / away, (aside * centre.z + reach) / away]
        };
        let [left, right] = touching(centre.x);
        let [bottom, top] = touching(centre.y);
        // One pixel more, for soft edges.
        let (x, y, focal) = (lens.centre.x, lens.centre.y, lens.focal);
        Box {
            low: [x + focal * left - 1.0, y - focal * top - 1.0],
            high: [x + focal * right + 1.0, y - focal * bottom + 1.0],
        }
    }
}

/// What is the same for all rays through a row of pixels. A ray's direction has a depth of 1, so that how far it goes
/// is a depth.
struct Row {
    squared: f32,
    along: [f32; 2],
    to_eye: [f32; 2],
    from_start: [f32; 2],
    from_end: [f32; 2],
    /// By how much the squared distances of the eye exceed the squared radius.
    axis_excess: f32,
    start_excess: f32,
    end_excess: f32,
}

/// Where a ray meets a capsule.
struct Hit {
    depth: f32,
    /// How much of the pixel the capsule covers.
    share: f32,
    /// On the capsule's axis, from its point nearest to the eye.
    along: f32,
}

impl Row {
    fn new(body: &Body, sight: Vec3, right: Vec3) -> Row {
        let both = |vector: Vec3| [vector.dot(sight), vector.dot(right)];
        let radius_squared = body.capsule.radius * body.capsule.radius;
        let excess = |vector: Vec3| vector.length_squared() - radius_squared;
        Row {
            squared: sight.length_squared(),
            along: both(body.capsule.axis),
            to_eye: both(body.to_eye),
            from_start: both(body.from_start),
            from_end: both(body.from_end),
            axis_excess: excess(body.to_eye),
            start_excess: excess(body.from_start),
            end_excess: excess(body.from_end),
        }
    }

    /// Meets `body` with the ray that goes this far to the right.
    #[inline]
    fn meet(&self, body: &Body, aside: f32, per_pixel: f32) -> Option<Hit> {
        let squared = self.squared + aside * aside;
        let along = self.along[0] + self.along[1] * aside;
        let to_eye = self.to_eye[0] + self.to_eye[1] * aside;
        // The squared sine between ray and axis, times the ray's squared length.
        let apart = squared - along * along;
        let parallel = apart < 1e-6 * squared;
        // Where the ray passes closest to the axis, and where it enters the endless cylinder around it.
        let closest = -to_eye / apart;
        let inside = to_eye * to_eye - apart * self.axis_excess;
        let on_axis = closest * along;
        let beside = on_axis >= body.start && on_axis <= body.end && !parallel;
        let entry = if inside > 0.0 && !parallel { closest - inside.sqrt() / apart } else { closest };
        let entry_on_axis = entry * along;

        let ball = |at_start: bool| {
            let (to_centre, excess) = match at_start {
                true => (self.from_start, self.start_excess),
                false => (self.from_end, self.end_excess),
            };
            let to_centre = to_centre[0] + to_centre[1] * aside;
            (-to_centre / squared, to_centre * to_centre - squared * excess, squared)
        };
        let at_start = if parallel { along > 0.0 } else { entry_on_axis < body.start };
        // The soft edge belongs to the part that the ray passes closest to.
        let (passing, within, measure) = if beside {
            (closest, inside, apart)
        } else {
            ball(if parallel { at_start } else { on_axis < body.start })
        };
        let share = self.share(within / measure, body.capsule.radius, passing * per_pixel);
        if !(share > 0.0 && passing > 0.0) {
            return None;
        }
        let on_cylinder = !parallel && entry_on_axis >= body.start && entry_on_axis <= body.end;
        let depth = if on_cylinder {
            entry
        } else {
            let (closest, inside, measure) = ball(at_start);
            if inside > 0.0 { closest - inside.sqrt() / measure } else { passing }
        };
        (depth > 0.0).then_some(Hit { depth, share, along: depth * along })
    }

    /// The share of a pixel that is covered where a ray passes inside of a surface. `within` is the squared radius
    /// less the squared distance from the axis, `pixel` the size of a pixel there.
    #[inline]
    fn share(&self, within: f32, radius: f32, pixel: f32) -> f32 {
        if within >= radius * pixel {
            return 1.0;
        }
        let distance = (radius * radius - within).max(0.0).sqrt();
        // What is thinner than a pixel never covers all of it.
        ((radius - distance) / pixel + 0.5).clamp(0.0, (2.0 * radius / pixel).min(1.0))
    }
}

/// What gives a pixel of a capsule its colour.
struct Shader<'a> {
    light: &'a LightMaps,
    net: Net,
    tones: &'a Tones,
}

impl Shader<'_> {
    #[inline]
    fn color(&self, body: &Body, hit: &Hit, ray: Vec3) -> Color {
        let capsule = body.capsule;
        let on_axis = hit.along.clamp(body.start, body.end);
        let normal = (body.to_eye + ray * hit.depth - capsule.axis * on_axis).normalize_or_zero();
        let light = self.light.at(&self.net, hit.along - body.own_start, normal);
        let (around, sun) = (light.truncate(), light.w);

        let sight = ray * ray.length_recip();
        let half = SUN - sight;
        let mirrored = normal.dot(half).max(0.0);
        let mirrored = (mirrored * mirrored / half.length_squared().max(1e-6)).powi(16);
        let rim = (1.0 + normal.dot(sight)).max(0.0);
        let rim = rim * rim * rim * (around.x + around.z);
        let lit = capsule.albedo * (SUNLIGHT * (normal.dot(SUN).max(0.0) * sun) + around)
            + Vec3::splat(SHINE * mirrored * sun)
            + RIM * rim;
        let color = self.tones.color(lit);
        if capsule.pale { color.mix(PALE, PALENESS) } else { color }
    }
}

/// From light to the numbers of a picture (sRGB), with bright light held back so that it keeps its colour.
struct Tones {
    shades: Vec<u8>,
}

const TONES: usize = 4096;

impl Tones {
    fn new() -> Tones {
        let shade = |step: usize| {
            let light = step as f32 / TONES as f32;
            let shade =
                if light <= 0.003_130_8 { 12.92 * light } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 };
            (shade * 255.0 + 0.5) as u8
        };
        Tones { shades: (0..=TONES).map(shade).collect() }
    }

    #[inline]
    fn color(&self, light: Vec3) -> Color {
        let held = light / (Vec3::ONE + 0.28 * light);
        let shade = |light: f32| {
            let step = ((light * TONES as f32).max(0.0) as usize).min(TONES);
            self.shades.get(step).map_or(0, |shade| u32::from(*shade))
        };
        Color((shade(held.x) << 16) | (shade(held.y) << 8) | shade(held.z))
    }
}
